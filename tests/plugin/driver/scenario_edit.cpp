// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections with CloudCompare's own tools and with the panel, export, save, reopen.
#include "driver.h"

#include <QDockWidget>
#include <QLabel>
#include <QPlainTextEdit>

#include <BinFilter.h>
#include <cc2DLabel.h>
#include <ccPickingHub.h>

namespace
{

constexpr double kMove_m = 0.3;

template <typename Widget>
Widget* inPanel(Driver& driver, const char* name)
{
    auto* panel = driver.app().getMainWindow()->findChild<QDockWidget*>("S2BEditPanel");
    auto* widget = panel ? panel->findChild<Widget*>(name) : nullptr;
    driver.check(widget != nullptr, QString("the panel has \"%1\"").arg(name));
    return widget;
}

void click(Driver& driver, const char* name)
{
    if (auto* button = inPanel<QPushButton>(driver, name))
    {
        driver.check(button->isEnabled(), QString("\"%1\" can be pressed").arg(name));
        QTest::mouseClick(button, Qt::LeftButton);
        QTest::qWait(100);
    }
}

QString message(Driver& driver)
{
    auto* label = inPanel<QLabel>(driver, "message");
    return label ? label->text() : QString();
}

CCVector3 centerOf(ccHObject* entity)
{
    return entity->getBB_recursive().getCenter();
}

ccMesh* wallOf(Driver& driver, unsigned id)
{
    for (ccMesh* wall : driver.named<ccMesh>(QString()))
    {
        if (wall->getMetaData("S2B.Id").toUInt() == id && id)
            return wall;
    }
    return nullptr;
}

unsigned idOf(const ccHObject* entity)
{
    return entity ? entity->getMetaData("S2B.Id").toUInt() : 0;
}

/// The wall nearest to the middle, and the one furthest from it.
std::pair<unsigned, unsigned> innerAndOuter(Driver& driver)
{
    const CCVector3 middle = centerOf(driver.model());
    const auto away = [&](ccMesh* wall) { return (centerOf(wall) - middle).norm2d(); };
    auto walls = driver.named<ccMesh>("Wall ");
    std::sort(walls.begin(), walls.end(), [&](ccMesh* a, ccMesh* b) { return away(a) < away(b); });
    return {idOf(walls.front()), idOf(walls.back())};
}

/// Across a wall that runs along an axis.
CCVector3 across(ccMesh* wall)
{
    const CCVector3 size = wall->getBB_recursive().getDiagVec();
    return size.x < size.y ? CCVector3(1, 0, 0) : CCVector3(0, 1, 0);
}

void moveWithCloudCompare(Driver& driver, unsigned inner)
{
    ccMesh* wall = wallOf(driver, inner);
    const CCVector3 before = centerOf(wall);
    ccGLMatrix shift;
    shift.setTranslation(across(wall) * static_cast<PointCoordinateType>(kMove_m));
    driver.applyTransformation(wall, shift);
    driver.check(std::abs((centerOf(wall) - before).norm() - kMove_m) < 1e-4, "CloudCompare moved the wall");
    driver.check(driver.exportModel("moved.ifc"), "a moved wall can be exported");
    std::printf("moved %u\n", inner);
}

/// Turned about its middle and back: what CloudCompare's tools do to an element is read from its entity.
void turnWithCloudCompare(Driver& driver, unsigned inner)
{
    constexpr float kTurn_rad = 0.1F;
    for (const float angle_rad : {kTurn_rad, -kTurn_rad})
    {
        ccMesh* wall = wallOf(driver, inner);
        const CCVector3 middle = centerOf(wall);
        ccGLMatrix turn;
        turn.initFromParameters(angle_rad, CCVector3(0, 0, 1), CCVector3(0, 0, 0));
        const CCVector3 turned = turn * middle;
        turn.setTranslation(middle - turned);
        driver.applyTransformation(wall, turn);
        if (angle_rad > 0)
            driver.check(driver.exportModel("turned.ifc"), "a turned wall can be exported");
    }
}

/// Half as high with the tool Multiply/Scale, and back.
void scaleWithCloudCompare(Driver& driver, unsigned inner)
{
    for (const double factor : {0.5, 2.0})
    {
        driver.select(wallOf(driver, inner));
        driver.whenShown(
            "ScaleDialog",
            [&driver, factor](QWidget* dialog)
            {
                dialog->findChild<QCheckBox*>("sameForAllCheckBox")->setChecked(false);
                dialog->findChild<QCheckBox*>("keepInPlaceCheckBox")->setChecked(true);
                for (const char* axis : {"fxSpinBox", "fySpinBox", "fzSpinBox"})
                    dialog->findChild<QDoubleSpinBox*>(axis)->setValue(QString(axis) == "fzSpinBox" ? factor : 1.0);
                driver.press(dialog, QDialogButtonBox::Ok);
            });
        driver.app().getMainWindow()->findChild<QAction*>("actionApplyScale")->trigger();
        QTest::qWait(100);
        if (factor < 1)
            driver.check(driver.exportModel("scaled.ifc"), "a scaled wall can be exported");
    }
}

void useThePanel(Driver& driver, unsigned inner, unsigned outer)
{
    driver.action("S2B.Edit")->trigger();
    driver.cloud()->setEnabled(false);
    driver.app().setView(CC_ISO_VIEW_1);
    driver.app().setGlobalZoom();
    driver.select(wallOf(driver, outer));
    QTest::qWait(200);
    if (auto* thickness = inPanel<QDoubleSpinBox>(driver, "thickness"))
        thickness->setValue(0.5);
    if (auto* name = inPanel<QLineEdit>(driver, "name"))
        name->setText("Facade");
    driver.shoot("edit_panel");
    click(driver, "apply");
    ccMesh* facade = wallOf(driver, outer);
    driver.check(facade && facade->getName() == "Facade", "the wall has its new name");
    driver.check(facade && facade->getMetaData("Thickness").toString() == "0.500 m (corrected)",
                 "and thickness: " + (facade ? facade->getMetaData("Thickness").toString() : QString()));
    // Applying took the wall that was moved with CloudCompare's tool to where it is: its neighbours follow.
    driver.check(wallOf(driver, inner) != nullptr, "the moved wall is still there");

    // Split near its start, and merge again.
    const std::size_t walls = driver.named<ccMesh>("Wall ").size();  // without the facade, until it is reset
    const ccBBox box = facade->getBB_recursive();
    const CCVector3 size = box.getDiagVec();
    for (const float part : {0.1F, 0.3F, 0.5F, 0.7F, 0.9F})  // within a window it is refused, beside it not
    {
        driver.select(wallOf(driver, outer));
        click(driver, "split");
        driver.check(message(driver).startsWith("Pick the place"), "the panel says what to pick");
        driver.pick(wallOf(driver, outer), box.minCorner() + (size.x > size.y ? CCVector3(part * size.x, 0, 0)
                                                                              : CCVector3(0, part * size.y, 0)));
        if (driver.named<ccMesh>("Wall ").size() > walls)
            break;
        driver.check(message(driver).contains("can't be split within"), "a place within a window is refused");
    }
    driver.check(driver.named<ccMesh>("Wall ").size() == walls + 1, "the wall was split: " + message(driver));
    ccMesh* rest = nullptr;
    for (ccMesh* wall : driver.named<ccMesh>("Wall "))
        rest = !rest || idOf(wall) > idOf(rest) ? wall : rest;
    driver.select(wallOf(driver, outer));
    driver.selectToo(rest);
    QTest::qWait(100);
    click(driver, "merge");
    driver.check(driver.named<ccMesh>("Wall ").size() == walls && wallOf(driver, outer), "the parts were merged again");
}

void addWall(Driver& driver, unsigned inner)
{
    const CCVector3 n = across(wallOf(driver, inner));
    const CCVector3 along(n.y, n.x, 0);
    const CCVector3 middle = centerOf(wallOf(driver, inner)) - n * 1.5F;
    std::set<unsigned> before;
    for (ccMesh* wall : driver.named<ccMesh>("Wall "))
        before.insert(idOf(wall));
    click(driver, "addWall");
    ccPointCloud* cloud = driver.cloud();
    driver.pick(cloud, middle - along * 0.8F);
    driver.pick(cloud, middle + along * 0.8F);
    driver.pick(cloud, middle - n * 0.12F);
    unsigned added = 0;
    for (ccMesh* wall : driver.named<ccMesh>("Wall "))
        added = before.count(idOf(wall)) ? added : idOf(wall);
    driver.check(added != 0, "a wall was added by three points: " + message(driver));
    driver.check(added && wallOf(driver, added)->getMetaData("Thickness").toString() == "0.120 m (corrected)",
                 "as thick as was picked");
    std::printf("added %u\n", added);
    driver.shoot("edit_added_wall");
}

void refuseATilt(Driver& driver, unsigned outer)
{
    ccMesh* wall = wallOf(driver, outer);
    ccGLMatrix tilt;
    tilt.initFromParameters(0.2F, CCVector3(1, 1, 0), CCVector3(0, 0, 0));
    driver.applyTransformation(wall, tilt);
    QString said;
    QFile::remove(driver.output("tilted.ifc"));
    driver.expectMessage(said);
    driver.select(driver.model());
    driver.action("S2B.ExportIfc")->trigger();
    QTest::qWait(300);
    driver.check(said.contains("tilted"), "a tilt is refused in one sentence: " + said);
    driver.select(wallOf(driver, outer));
    click(driver, "reset");
    driver.check(message(driver).startsWith("As reconstructed"), "reset: " + message(driver));
    const ccMesh* now = wallOf(driver, outer);
    driver.check(
        now && now->getName().startsWith("Wall ") && !now->getMetaData("Thickness").toString().contains("0.500"),
        "the wall is as reconstructed");
}

void edit(Driver& driver)
{
    driver.reconstructQuietly();
    if (!driver.model())
        return driver.check(false, "there is a model");
    const auto [inner, outer] = innerAndOuter(driver);
    driver.check(driver.exportModel("unmoved.ifc"), "the model can be exported");
    turnWithCloudCompare(driver, inner);
    scaleWithCloudCompare(driver, inner);
    moveWithCloudCompare(driver, inner);
    useThePanel(driver, inner, outer);
    addWall(driver, inner);
    refuseATilt(driver, outer);

    const auto windows = driver.named<ccMesh>("Window ");
    driver.unselectAll();
    std::printf("deleted %u\n", idOf(windows.front()));
    driver.app().removeFromDB(windows.front());
    wallOf(driver, inner)->setName("Partition");
    wallOf(driver, outer)->setEnabled(false);  // hidden, not gone

    driver.cloud()->setEnabled(false);
    driver.unselectAll();
    driver.app().setView(CC_ISO_VIEW_1);
    driver.app().setGlobalZoom();
    driver.app().redrawAll();
    driver.shoot("edited_model");
    driver.select(driver.model());
    driver.action("S2B.Translucent")->trigger();
    driver.unselectAll();
    driver.app().redrawAll();
    driver.shoot("translucent");
    driver.check(driver.exportModel("edited.ifc"), "the corrected model was exported");

    const QString file = driver.output("edited.bin");
    QFile::remove(file);
    FileIOFilter::SaveParameters parameters;
    parameters.alwaysDisplaySaveDialog = false;
    const bool isSaved = FileIOFilter::SaveToFile(driver.app().dbRootObject(), file, parameters,
                                                  BinFilter::GetFileFilter()) == CC_FERR_NO_ERROR;
    driver.check(isSaved && QFile::exists(file), "everything was saved");
}

/// Labels say what they said and lead where they led.
void findingsAreBack(Driver& driver)
{
    const auto labels = driver.labels();
    driver.check(!labels.empty(), QString("findings are there again: %1").arg(labels.size()));
    driver.app().setView(CC_ISO_VIEW_1);
    for (ccHObject* entity : labels)
    {
        auto* label = static_cast<cc2DLabel*>(entity);
        driver.app().setGlobalZoom();
        driver.clickInTree(label);
        const CCVector3d place = label->size() ? label->getPickedPoint(0).getPointPosition().toDouble() : CCVector3d();
        driver.check(!label->getMetaData("Text").toString().isEmpty() && label->size() == 1 &&
                         driver.waitFor([&] { return driver.isInTheMiddle(place); }, 5000),
                     label->getName() + " leads to its place");
    }
    driver.select(driver.model());
    driver.action("S2B.Findings")->trigger();
    auto* list = driver.app().getMainWindow()->findChild<QTreeWidget*>("findings");
    driver.check(list && list->topLevelItemCount() == static_cast<int>(labels.size()), "and are listed");
}

/// In a new process, from the file.
void edited(Driver& driver)
{
    if (!driver.model())
        return driver.check(false, "the model is there again");
    findingsAreBack(driver);
    const auto partitions = driver.named<ccMesh>("Partition");
    driver.check(partitions.size() == 1, "names are there again");
    driver.check(driver.exportModel("reopened.ifc"), "the model can be exported as it was");

    // It goes on from there: another correction, and a stage on the cloud that is found again.
    ccGLMatrix shift;
    shift.setTranslation(across(partitions.front()) * static_cast<PointCoordinateType>(-kMove_m));
    driver.applyTransformation(partitions.front(), shift);
    driver.select(driver.model());
    driver.action("S2B.Columns")->trigger();
    QTest::qWait(300);
    driver.check(!driver.named<ccMesh>("Column ").empty(), "a stage runs on the cloud that is found again");
    driver.check(driver.named<ccMesh>("Partition").size() == 1, "and keeps the corrections");
    driver.check(driver.exportModel("moved_back.ifc"), "and the model can be exported");
}

const Scenario kEdit("edit", edit);
const Scenario kEdited("edited", edited);

}  // namespace
