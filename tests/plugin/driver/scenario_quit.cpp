// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.h"

#include <QThreadPool>

namespace
{

constexpr int kThreadEnds_ms = 10;  // what it ran has ended before

// CloudCompare ends while a model is made, at the end of a session say: every event loop returns, the worker's too.
void quit(Driver& driver)
{
    const std::size_t before = driver.entityCount();
    bool hasQuit = false;
    driver.whenShown("S2BProgress",
                     [&](QWidget*)
                     {
                         hasQuit = QThreadPool::globalInstance()->activeThreadCount() > 0;
                         QCoreApplication::exit(1);
                     });
    driver.reconstructQuietly();
    driver.check(hasQuit, "CloudCompare quits within a run");
    driver.check(QThreadPool::globalInstance()->waitForDone(kThreadEnds_ms * slowdown()),
                 "the run has ended before it goes on");
    driver.check(driver.entityCount() == before, "the tree is as it was");
}

const Scenario kScenario("quit", quit);

}  // namespace
