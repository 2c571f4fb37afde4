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

/// The colour that is seen at a place.
QColor colorAt(Driver& driver, const CCVector3& place)
{
    ccGLWindowInterface* view = driver.app().getActiveGLWindow();
    auto* widget = qobject_cast<QWidget*>(view->asQObject());
    ccGLCameraParameters camera;
    view->getGLCameraParameters(camera);
    CCVector3d seen;
    camera.project(place.toDouble(), seen);
    const QPoint at = widget->mapToGlobal(QPoint(qRound(seen.x), qRound(camera.viewport[3] - seen.y)));
    QTest::qWait(300);
    return widget->screen()->grabWindow(0).toImage().pixelColor(at);
}

/// The colour that is seen in the middle of an entity.
QColor colorAt(Driver& driver, ccHObject* entity)
{
    return colorAt(driver, entity->getBB_recursive().getCenter());
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

CCVector3 centerOf(ccHObject* entity)
{
    return entity->getBB_recursive().getCenter();
}

/// Along the wall that a window is in, which runs along an axis: from its middle to its end.
CCVector3 toEndOf(ccHObject* window)
{
    const CCVector3 half = window->getBB_recursive().getDiagVec() / 2;
    return half.x > half.y ? CCVector3(half.x, 0, 0) : CCVector3(0, half.y, 0);
}

ccMesh* windowOf(Driver& driver, unsigned id)
{
    for (ccMesh* window : driver.named<ccMesh>("Window "))
    {
        if (window->getMetaData("S2B.Id").toUInt() == id)
            return window;
    }
    return nullptr;
}

/// The plan shows windows where they are, whatever corrects them.
void checkCorrections(Driver& driver)
{
    constexpr float kMove_m = 0.25F;
    constexpr float kInside = 0.9F;  // of the way to a window's end
    const auto windows = driver.named<ccMesh>("Window ");
    const auto id = [&](std::size_t i) { return windows[i]->getMetaData("S2B.Id").toUInt(); };
    const unsigned moved = id(0);
    const unsigned wider = id(1);
    const unsigned deleted = id(2);
    const unsigned same = id(3);

    // By CloudCompare's own tool: one end is where no pane was, and the other end of it is bare.
    const CCVector3 before = centerOf(windowOf(driver, moved));
    const CCVector3 end = toEndOf(windowOf(driver, moved));
    ccGLMatrix shift;
    shift.setTranslation(end / end.norm() * kMove_m);
    driver.applyTransformation(windowOf(driver, moved), shift);
    driver.unselectAll();
    driver.app().setGlobalZoom();  // the tool zooms in
    driver.app().redrawAll();
    const CCVector3 after = centerOf(windowOf(driver, moved));
    driver.check(std::abs((after - before).norm() - kMove_m) < 1e-4, "CloudCompare moved a window");
    driver.check(isPane(colorAt(driver, after + end * kInside)), "its pane is where it went");
    driver.check(!isPane(colorAt(driver, before - end * kInside)), "and no longer where it was");

    // By the panel: the wall is drawn anew as well, and has to be cut as it was for the pane to be seen.
    driver.action("S2B.Edit")->trigger();
    driver.select(windowOf(driver, wider));
    auto* panel = driver.app().getMainWindow()->findChild<QWidget*>("S2BEditPanel");
    auto* width = panel->findChild<QDoubleSpinBox*>("width");
    const CCVector3 narrow = toEndOf(windowOf(driver, wider));
    width->setValue(width->value() + 0.3);
    QTest::mouseClick(panel->findChild<QPushButton*>("apply"), Qt::LeftButton);
    driver.unselectAll();
    driver.action("S2B.Edit")->trigger();
    QTest::qWait(200);
    driver.app().redrawAll();
    const CCVector3 wide = toEndOf(windowOf(driver, wider));
    driver.check(std::abs((wide - narrow).norm() - 0.15) < 1e-3, "the panel made a window wider");
    for (const float side : {-kInside, kInside})
        driver.check(isPane(colorAt(driver, centerOf(windowOf(driver, wider)) + wide * side)), "so is its pane");
    driver.check(isPane(colorAt(driver, windowOf(driver, moved))), "the one that was moved still has its pane");

    const CCVector3 gone = centerOf(windowOf(driver, deleted));
    driver.app().removeFromDB(windowOf(driver, deleted));
    driver.app().redrawAll();
    driver.check(!isPane(colorAt(driver, gone)), "a window that is deleted takes its pane with it");
    driver.check(isPane(colorAt(driver, windowOf(driver, same))), "all others keep theirs");
    driver.shoot("floor_plan_corrected");
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

    driver.cloud()->setEnabled(false);
    driver.select(driver.model());
    plan->trigger();
    driver.unselectAll();
    checkCorrections(driver);
    plan->trigger();

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
