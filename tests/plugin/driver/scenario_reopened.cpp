// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.h"

namespace
{

// The model came back from a .bin file.
void reopened(Driver& driver)
{
    const auto walls = driver.named<ccMesh>("Wall ");
    driver.check(!walls.empty(), "the walls are there again");
    if (walls.empty())
        return;
    driver.select(walls.front());
    driver.check(driver.action("S2B.ExportIfc")->isEnabled(), "the model can be exported after reopening");
}

const Scenario kScenario("reopened", reopened);

}  // namespace
