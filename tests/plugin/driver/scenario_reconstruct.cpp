// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.h"

namespace
{

void showMenu(Driver& driver)
{
    driver.pluginsMenu()->popup(driver.app().getMainWindow()->menuBar()->mapToGlobal(QPoint(300, 24)));
    for (QAction* sub : driver.pluginsMenu()->actions())
    {
        if (sub->text() == "Scan to BIM")
            driver.pluginsMenu()->setActiveAction(sub);
    }
    driver.shoot("menu");
    driver.menu()->close();
    driver.pluginsMenu()->close();
    QApplication::processEvents();
}

void checkTree(Driver& driver)
{
    const auto walls = driver.named<ccMesh>("Wall ");
    driver.check(driver.named("Level 0").size() == 1, "there is a storey");
    driver.check(!walls.empty(), QString("there are walls: %1").arg(walls.size()));
    driver.check(!driver.named<ccMesh>("Door ").empty(), "there are doors");
    for (const ccMesh* wall : walls)
    {
        if (wall->getParent()->getName() != "Walls" || wall->getParent()->getParent()->getName() != "Level 0")
            return driver.check(false, "walls are below storey > Walls");
    }
    for (const char* key : {"Length", "Thickness", "Height", "Evidence: points", "Evidence: RMS"})
        driver.check(!walls.empty() && walls.front()->hasMetaData(key), QString("a wall's properties: %1").arg(key));
    driver.check(
        !walls.empty() && walls.front()->getAssociatedCloud()->getGlobalShift().x == driver.cloud()->getGlobalShift().x,
        "the model lies over the cloud");
}

void showResult(Driver& driver)
{
    driver.unselectAll();
    driver.app().setView(CC_ISO_VIEW_1);
    driver.app().setGlobalZoom();
    driver.app().redrawAll();
    driver.shoot("model_over_points");
    driver.cloud()->setEnabled(false);
    const auto walls = driver.named<ccMesh>("Wall ");
    if (!walls.empty())
        driver.select(walls.front());
    driver.app().redrawAll();
    QTest::qWait(300);
    driver.showMetaData();
    driver.shoot("model");
    driver.cloud()->setEnabled(true);
}

void saveAndReport(std::size_t walls)
{
    std::printf("walls %zu\n", walls);
    std::fflush(stdout);
}

void exportWithoutOneWall(Driver& driver, QAction* exportIfc)
{
    const auto walls = driver.named<ccMesh>("Wall ");
    driver.select(walls.back());
    driver.check(exportIfc->isEnabled(), "a model's wall can be exported with its model");
    ccHObject* model = walls.back()->getParent()->getParent()->getParent();
    driver.unselectAll();
    driver.app().removeFromDB(walls.back());
    driver.select(model);
    driver.whenShown("S2BExportDialog",
                     [&driver](QWidget* dialog)
                     {
                         auto* files = static_cast<QFileDialog*>(dialog);
                         files->findChild<QLineEdit*>("fileNameEdit")->setText(driver.output("without_one_wall.ifc"));
                         QMetaObject::invokeMethod(files, "accept", Qt::QueuedConnection);
                     });
    exportIfc->trigger();
    driver.check(QFile::exists(driver.output("without_one_wall.ifc")), "the corrected model was exported");
    saveAndReport(walls.size() - 1);
}

void reconstruct(Driver& driver)
{
    QAction* reconstruct = driver.action("S2B.Reconstruct");
    QAction* exportIfc = driver.action("S2B.ExportIfc");
    driver.check(reconstruct && exportIfc, "both actions are there");
    driver.unselectAll();
    driver.check(!reconstruct->isEnabled() && !exportIfc->isEnabled(), "nothing is enabled without a selection");
    driver.select(driver.cloud());
    driver.check(reconstruct->isEnabled() && !exportIfc->isEnabled(),
                 "a cloud can be reconstructed, and not be exported");
    showMenu(driver);

    const CCVector3 firstPoint = *driver.cloud()->getPoint(0);
    const unsigned fields = driver.cloud()->getNumberOfScalarFields();
    bool wasResponsive = false;
    driver.whenShown("S2BReconstructDlg",
                     [&](QWidget* dialog)
                     {
                         auto* field = dialog->findChild<QComboBox*>("labelField");
                         driver.check(field && field->currentText() == "Classification", "the label field is proposed");
                         driver.check(dialog->findChild<QTreeWidget*>("classes")->topLevelItemCount() > 3,
                                      "the classes are listed");
                         auto* thickness = dialog->findChild<QDoubleSpinBox*>("walls.defaultThickness");
                         thickness->setValue(0.18);
                         driver.shoot("dialog_in_window");
                         dialog->findChild<QTabWidget*>("tabs")->setCurrentIndex(1);
                         bool isShown = false;
                         for (auto* box : dialog->findChildren<QDoubleSpinBox*>("walls.defaultThickness"))
                             isShown = isShown || (box != thickness && box->value() == 0.18);
                         driver.check(isShown, "the expert page shows what was set in front");
                         driver.shoot("dialog_parameters");
                         dialog->findChild<QTabWidget*>("tabs")->setCurrentIndex(0);
                         dialog->findChild<QCheckBox*>("writeIfc")->setChecked(true);
                         dialog->findChild<QLineEdit*>("ifcPath")->setText(driver.output("dialog.ifc"));
                         driver.whenShown("S2BProgress",
                                          [&](QWidget* progress)
                                          {
                                              wasResponsive = progress->isVisible();
                                              driver.shoot("progress");
                                          });
                         driver.press(dialog, QDialogButtonBox::Ok);
                     });
    reconstruct->trigger();
    QTest::qWait(500);
    driver.check(wasResponsive, "progress was shown while it ran");
    driver.check(QFile::exists(driver.output("dialog.ifc")), "the IFC file was written");
    checkTree(driver);
    driver.check(
        (*driver.cloud()->getPoint(0) - firstPoint).norm2() == 0 && driver.cloud()->getNumberOfScalarFields() == fields,
        "the cloud is unchanged");
    showResult(driver);
    exportWithoutOneWall(driver, exportIfc);
}

const Scenario kScenario("reconstruct", reconstruct);

}  // namespace
