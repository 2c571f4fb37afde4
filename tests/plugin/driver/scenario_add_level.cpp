// SPDX-License-Identifier: GPL-3.0-or-later
// Edit element > Add level...: a level that a run went without, picked in the view and walled.
#include "driver.h"

#include <QDockWidget>

#include <ccGLWindowInterface.h>
#include <ccPlane.h>

namespace
{

constexpr float kUpper_m = 3.1F;  // above the lowest point: between the lower ceiling and the upper floor

/// The cloud's levels without the upper one, as if a run had missed it.
void removeUpperLevel(Driver& driver, QWidget* dialog)
{
    dialog->findChild<QTabWidget*>("tabs")->setCurrentIndex(1);
    auto* storeys = dialog->findChild<QTableWidget*>("storeys");
    driver.check(driver.waitFor([&] { return storeys->rowCount() == 2; }), "the dialog finds two storeys");
    storeys->setCurrentCell(1, 0);
    QTest::mouseClick(dialog->findChild<QPushButton*>("removeStorey"), Qt::LeftButton);
    driver.check(storeys->rowCount() == 1, "and lets one be removed");
}

/// A place on the upper floor, off the columns that stand half way across.
CCVector3d placeOnUpperFloor(Driver& driver)
{
    const ccPointCloud& cloud = *driver.cloud();
    const ccBBox box = driver.cloud()->getOwnBB();
    const CCVector3 size = box.getDiagVec();
    const CCVector3 aim = box.minCorner() + CCVector3(size.x / 4, size.y / 3, 0);
    CCVector3d sum;
    unsigned count = 0;
    for (unsigned i = 0; i < cloud.size(); ++i)
    {
        const CCVector3& p = *cloud.getPoint(i);
        if (p.z < box.minCorner().z + kUpper_m || std::hypot(p.x - aim.x, p.y - aim.y) > 0.2F)
            continue;
        sum += p.toDouble();
        ++count;
    }
    driver.check(count > 10, QString("the upper floor is in the cloud: %1 points").arg(count));
    return count ? sum / count : CCVector3d();
}

/// A click with the mouse where a place is seen.
void clickInView(Driver& driver, const CCVector3d& place)
{
    ccGLWindowInterface* view = driver.app().getActiveGLWindow();
    auto* widget = qobject_cast<QWidget*>(view->asQObject());
    if (!widget)
        return driver.check(false, "the view is a widget");
    ccGLCameraParameters camera;
    view->getGLCameraParameters(camera);
    CCVector3d seen;
    camera.project(place, seen);
    const QPoint at(qRound(seen.x), qRound(camera.viewport[3] - seen.y));
    QTest::mouseMove(widget, at);
    QTest::mouseClick(widget, Qt::LeftButton, Qt::NoModifier, at);
}

QString message(QDockWidget* panel)
{
    return panel->findChild<QLabel*>("message")->text();
}

void press(Driver& driver, QDockWidget* panel, const char* name)
{
    auto* button = panel->findChild<QPushButton*>(name);
    driver.check(button && button->isVisible() && button->isEnabled(), QString("\"%1\" can be pressed").arg(name));
    QTest::mouseClick(button, Qt::LeftButton);
    QTest::qWait(100);
}

std::size_t levels(Driver& driver)
{
    return driver.named<ccPlane>("Floor level").size();
}

void addByPicking(Driver& driver, const CCVector3d& place)
{
    driver.select(driver.model());
    driver.action("S2B.Edit")->trigger();
    auto* panel = driver.app().getMainWindow()->findChild<QDockWidget*>("S2BEditPanel");
    if (!panel)
        return driver.check(false, "there is the panel");
    driver.app().setView(CC_TOP_VIEW);
    driver.app().setGlobalZoom();
    QTest::qWait(500);

    press(driver, panel, "addLevel");
    driver.check(message(panel).startsWith("Pick a point"), "the panel says what to pick: " + message(panel));
    press(driver, panel, "cancelPicking");
    clickInView(driver, place);
    QTest::qWait(1000);
    driver.check(levels(driver) == 1, "after Stop picking a click adds nothing");

    driver.select(driver.model());
    press(driver, panel, "addLevel");
    // CloudCompare itself asks before its first pick in a large cloud whether to make an octree for it.
    driver.whenShown("QMessageBox",
                     [&](QWidget* box)
                     {
                         for (auto* button : box->findChildren<QPushButton*>())
                         {
                             if (button->text().remove('&') == "Never")
                                 return QTest::mouseClick(button, Qt::LeftButton);
                         }
                         driver.check(false, "unknown question: " + static_cast<QMessageBox*>(box)->text());
                         box->close();
                     });
    clickInView(driver, place);
    driver.check(driver.waitFor([&] { return levels(driver) == 2; }, 10000), "a click on the floor adds a level");
    driver.check(message(panel).startsWith("The level was added"), "the panel says so: " + message(panel));

    press(driver, panel, "addLevel");
    clickInView(driver, place);
    driver.check(driver.waitFor([&] { return message(panel).contains("already at that height"); }, 10000),
                 "a second one there is refused: " + message(panel));
    driver.check(levels(driver) == 2, "and not added");
    driver.shoot("added_level");
}

void addLevel(Driver& driver)
{
    driver.reconstructQuietly([&](QWidget* dialog) { removeUpperLevel(driver, dialog); });
    if (!driver.model())
        return driver.check(false, "there is a model");
    driver.check(levels(driver) == 1 && driver.named("Level 1").empty(), "the model is without the upper storey");
    const std::size_t walls = driver.named<ccMesh>("Wall ").size();
    const CCVector3d place = placeOnUpperFloor(driver);
    addByPicking(driver, place);

    const auto added = driver.named("Level 1");
    if (added.size() != 1)
        return driver.check(false, "the level is a storey of the tree");
    const double floor_m = driver.cloud()->toGlobal3d(place).z;
    const double elevation_m = added.front()->getMetaData("Elevation").toString().section(' ', 0, 0).toDouble();
    driver.check(std::abs(elevation_m - floor_m) < 0.02,
                 QString("as high as the floor that was clicked: %1, %2 m").arg(elevation_m).arg(floor_m));

    driver.select(driver.model());
    driver.action("S2B.Walls")->trigger();
    QTest::qWait(300);
    std::size_t onTop = 0;
    for (ccMesh* wall : driver.named<ccMesh>("Wall "))
    {
        if (wall->getParent()->getParent() != driver.named("Level 1").front())
            continue;
        ++onTop;
        const double base_m = wall->getMetaData("Base").toString().section(' ', 0, 0).toDouble();
        driver.check(std::abs(base_m - elevation_m) < 0.002, QString("a wall stands on it, at %1 m").arg(base_m));
    }
    driver.check(onTop >= 5, QString("Walls finds the walls on the new level: %1").arg(onTop));
    driver.check(driver.named<ccMesh>("Wall ").size() == walls + onTop, "and as many below as before");
    driver.shoot("walls_on_added_level");
    driver.check(driver.exportModel("added_level.ifc"), "the model was exported");
    std::printf("upper %zu\nlower %zu\n", onTop, walls);
}

const Scenario kScenario("add_level", addLevel);

}  // namespace
