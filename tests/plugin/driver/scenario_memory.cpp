// SPDX-License-Identifier: GPL-3.0-or-later
// Reconstructs and deletes the result, again and again: the memory that is held must not grow.
#include "driver.h"

#include <malloc.h>
#include <unistd.h>

namespace
{

/// Memory of this process that is in use [bytes] (proc(5): statm), after what is free was given back.
double resident()
{
    malloc_trim(0);
    QFile file("/proc/self/statm");
    file.open(QIODevice::ReadOnly);
    return static_cast<double>(file.readAll().split(' ').value(1).toLongLong() * sysconf(_SC_PAGESIZE));
}

/// Accepts the dialog as soon as it is there: hundreds of them are opened.
void acceptNext(Driver& driver)
{
    QTimer::singleShot(0, &driver,
                       [&driver]
                       {
                           QWidget* dialog = QApplication::activeModalWidget();
                           if (dialog && dialog->objectName() == "S2BReconstructDlg" && dialog->isVisible())
                               dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
                           else
                               acceptNext(driver);
                       });
}

void memory(Driver& driver)
{
    const int cycles = qEnvironmentVariableIntValue("S2B_DRIVER_CYCLES");
    const int warmUp = cycles / 4;
    constexpr double kMegabyte = 1024.0 * 1024.0;
    const std::size_t entities = driver.entityCount();
    double before = 0;
    double model = 0;  // what one result holds
    for (int i = 0; i < cycles; ++i)
    {
        driver.select(driver.cloud());
        acceptNext(driver);
        driver.action("S2B.Reconstruct")->trigger();
        QApplication::processEvents();
        if (!driver.model())
            return driver.check(false, QString("cycle %1 makes a model").arg(i));
        if (i == warmUp)
            model = resident();
        ccHObject* result = driver.model();
        driver.unselectAll();
        driver.app().removeFromDB(result);
        QApplication::processEvents();
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        if (i == warmUp)
        {
            before = resident();
            model -= before;
        }
    }
    const double growth = (resident() - before) / kMegabyte;
    driver.check(driver.entityCount() == entities, "the tree is as it was");
    std::printf("memory: %.1f MB before, %.2f MB more after %d cycles, one result holds %.2f MB\n", before / kMegabyte,
                growth, cycles - warmUp - 1, model / kMegabyte);
    // A result that was not freed would cost its size in each cycle; the console keeps some 3 kB of text.
    const double bound = 0.05 * (cycles - warmUp) + 4.0;
    driver.check(growth < bound, QString("memory grew by %1 MB, at most %2 MB are allowed").arg(growth).arg(bound));
}

const Scenario kScenario("memory", memory);

}  // namespace
