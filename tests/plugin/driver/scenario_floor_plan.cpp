// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.h"

#include <QScreen>

#include <ccGLWindowInterface.h>

namespace
{

ccViewportParameters viewOf(Driver& driver)
{
    return driver.app().getActiveGLWindow()->getViewportParameters();
}

/// The colour that is seen in the middle of an entity.
QColor colorAt(Driver& driver, ccHObject* entity)
{
    ccGLWindowInterface* view = driver.app().getActiveGLWindow();
    auto* widget = qobject_cast<QWidget*>(view->asQObject());
    ccGLCameraParameters camera;
    view->getGLCameraParameters(camera);
    CCVector3d seen;
    camera.project(entity->getBB_recursive().getCenter().toDouble(), seen);
    const QPoint at = widget->mapToGlobal(QPoint(qRound(seen.x), qRound(camera.viewport[3] - seen.y)));
    QTest::qWait(300);
    return widget->screen()->grabWindow(0).toImage().pixelColor(at);
}

bool isPane(const QColor& color)
{
    return color.blue() > 180 && color.blue() - color.red() > 150 && color.blue() - color.green() > 60;
}

/// From straight above a pane has no face: the plan has to draw it.
void checkPanes(Driver& driver)
{
    const auto windows = driver.named<ccMesh>("Window ");
    std::size_t panes = 0;
    for (ccMesh* window : windows)
        panes += isPane(colorAt(driver, window)) ? 1 : 0;
    driver.check(windows.size() > 5 && panes == windows.size(),
                 QString("a pane is seen in %1 of %2 windows").arg(panes).arg(windows.size()));
    windows.front()->setEnabled(false);
    driver.app().redrawAll();
    driver.check(!isPane(colorAt(driver, windows.front())), "not in one that is hidden");
    driver.check(isPane(colorAt(driver, windows.back())), "in another one still");
    windows.front()->setEnabled(true);
    driver.app().redrawAll();
    driver.check(isPane(colorAt(driver, windows.front())), "and there again");
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
    checkPanes(driver);
    const std::size_t entities = driver.entityCount();
    driver.cloud()->setEnabled(true);
    driver.app().redrawAll();
    driver.shoot("floor_plan_over_points");
    plan->trigger();
    driver.check(driver.entityCount() == entities, "what the plan draws is not in the tree");
    driver.check((viewOf(driver).getViewDir() - before.getViewDir()).norm() < 1e-9 &&
                     (viewOf(driver).getCameraCenter() - before.getCameraCenter()).norm() < 1e-6,
                 "the view is as it was before");
    driver.app().redrawAll();
    driver.shoot("floor_plan_left");
    driver.app().setView(CC_TOP_VIEW);
    driver.app().redrawAll();
    const auto windows = driver.named<ccMesh>("Window ");
    driver.check(
        std::none_of(windows.begin(), windows.end(), [&](ccMesh* window) { return isPane(colorAt(driver, window)); }),
        "the panes went with the plan");

    // The view closes with a plan in it: nothing may crash, now or when CloudCompare ends.
    driver.select(driver.model());
    plan->trigger();
    driver.app().getMainWindow()->findChild<QAction*>("actionClose3DView")->trigger();
    QApplication::processEvents();
    driver.check(!driver.app().getActiveGLWindow(), "the view is closed");
    plan->trigger();
}

const Scenario kScenario("floor_plan", floorPlan);

}  // namespace
