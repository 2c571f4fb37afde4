// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.h"

#include <ccGLWindowInterface.h>

namespace
{

ccViewportParameters viewOf(Driver& driver)
{
    return driver.app().getActiveGLWindow()->getViewportParameters();
}

void floorPlan(Driver& driver)
{
    QAction* plan = driver.action("S2B.FloorPlan");
    driver.unselectAll();
    driver.check(plan && !plan->isEnabled(), "without a selection there is nothing to cut");
    driver.reconstructQuietly();
    if (!driver.model())
        return driver.check(false, "there is a model");
    driver.app().setView(CC_ISO_VIEW_1);
    driver.app().setGlobalZoom();
    driver.cloud()->setEnabled(false);
    driver.select(driver.model());
    driver.check(plan->isEnabled(), "a model has a floor plan");
    const ccViewportParameters before = viewOf(driver);
    plan->trigger();
    driver.unselectAll();
    driver.app().redrawAll();
    driver.shoot("floor_plan");
    driver.check(!viewOf(driver).perspectiveView && viewOf(driver).getViewDir().z < -0.999, "it is seen from above");
    driver.check(plan->isEnabled(), "and can be left");
    driver.cloud()->setEnabled(true);
    driver.app().redrawAll();
    driver.shoot("floor_plan_over_points");
    plan->trigger();
    driver.check((viewOf(driver).getViewDir() - before.getViewDir()).norm() < 1e-9 &&
                     (viewOf(driver).getCameraCenter() - before.getCameraCenter()).norm() < 1e-6,
                 "the view is as it was before");
    driver.app().redrawAll();
    driver.shoot("floor_plan_left");
}

const Scenario kScenario("floor_plan", floorPlan);

}  // namespace
