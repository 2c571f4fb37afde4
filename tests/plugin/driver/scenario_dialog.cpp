// SPDX-License-Identifier: GPL-3.0-or-later
// Reconstruct...'s dialog: presets, search, files of parameters, the levels, and what it remembers.
#include "driver.h"

namespace
{

double valueOf(QWidget* dialog, const char* parameter)
{
    return dialog->findChild<QDoubleSpinBox*>(parameter)->value();
}

QTabWidget* tabsOf(QWidget* dialog)
{
    return dialog->findChild<QTabWidget*>("tabs");
}

/// Types a path into the next file dialog of that name and accepts it.
void answer(Driver& driver, const QString& name, const QString& path)
{
    driver.whenShown(name,
                     [path](QWidget* dialog)
                     {
                         dialog->findChild<QLineEdit*>("fileNameEdit")->setText(path);
                         QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
                     });
}

void choose(QComboBox* box, const QString& text)
{
    box->setCurrentText(text);
    Q_EMIT box->activated(box->currentIndex());
}

void tryPresets(Driver& driver, QWidget* dialog)
{
    auto* building = dialog->findChild<QComboBox*>("buildingPreset");
    auto* survey = dialog->findChild<QComboBox*>("surveyPreset");
    driver.check(building && building->count() == 4 && survey && survey->count() == 2, "the presets are offered");
    const double thickness = valueOf(dialog, "walls.defaultThickness");
    choose(building, "Office");
    choose(survey, "Mobile mapping");
    driver.check(
        valueOf(dialog, "walls.defaultThickness") == 0.125 && valueOf(dialog, "walls.minimumThickness") == 0.07,
        "a kind of building and a kind of survey are combined");
    driver.check(building->toolTip().contains("metal stud"), "each value's reason is told");
    driver.shoot(dialog, "dialog_presets");
    choose(building, "Any");
    choose(survey, "Tripod scanner");
    driver.check(valueOf(dialog, "walls.defaultThickness") == thickness, "without a preset the defaults are back");
}

void tryFiles(Driver& driver, QWidget* dialog)
{
    QWidget* panel = tabsOf(dialog)->widget(2);
    auto* search = dialog->findChild<QLineEdit*>("parameterSearch");
    auto* gap = panel->findChild<QDoubleSpinBox*>("walls.mergeGap");
    driver.shoot(dialog, "dialog_parameters");
    search->setText("collinear");
    driver.check(gap->isVisible() && !panel->findChild<QDoubleSpinBox*>("cells.size")->isVisible(),
                 "parameters are searched by their help");
    search->clear();
    gap->setValue(0.725);
    const QString path = driver.output("window_parameters.toml");
    QFile::remove(path);
    answer(driver, "S2BSaveParameters", path);
    dialog->findChild<QPushButton*>("saveParameters")->click();
    driver.check(QFile::exists(path), "the parameters are saved");
    dialog->findChild<QPushButton*>("defaults")->click();
    driver.check(gap->value() != 0.725, "the defaults are back");
    answer(driver, "S2BLoadParameters", path);
    dialog->findChild<QPushButton*>("loadParameters")->click();
    driver.check(gap->value() == 0.725, "and what was saved is loaded");
    dialog->findChild<QPushButton*>("defaults")->click();
}

/// The floor is dragged up by 0.4 m; the new height is returned.
double dragFloor(Driver& driver, QWidget* dialog)
{
    auto* storeys = dialog->findChild<QTableWidget*>("storeys");
    auto* view = dialog->findChild<QWidget*>("levelView");
    driver.check(driver.waitFor([&] { return storeys->rowCount() > 0; }), "the storeys are found in the background");
    if (storeys->rowCount() == 0)
        return 0;
    const auto height = [&](int column) { return storeys->item(0, column)->text().toDouble(); };
    driver.check(height(1) - height(0) > 2.0 && height(1) - height(0) < 4.0, "the storey is as high as a room");
    driver.shoot(dialog, "dialog_levels");

    // The line is found as a user finds it: where the cursor says that it can be dragged.
    const double before = height(0);
    const QPoint middle = view->rect().center();
    int line = -1;
    for (int y = view->height() - 1; y > 0 && line < 0; --y)
    {
        QTest::mouseMove(view, QPoint(middle.x(), y));
        QMouseEvent move(QEvent::MouseMove, QPoint(middle.x(), y), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(view, &move);
        if (view->cursor().shape() == Qt::SizeVerCursor)
            line = y;
    }
    driver.check(line > 0, "the floor's line can be grasped");
    const QPoint from(middle.x(), line - 3);
    QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, from);
    for (int step = 1; step <= 8; ++step)
    {
        QMouseEvent move(QEvent::MouseMove, from - QPoint(0, 5 * step), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(view, &move);
    }
    QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, from - QPoint(0, 40));
    driver.check(height(0) > before + 0.1, QString("the floor was dragged from %1 to %2 m").arg(before).arg(height(0)));
    storeys->item(0, 0)->setText("nonsense");
    driver.check(height(0) > before + 0.1, "what is no height is not taken");
    storeys->item(0, 0)->setText(QString::number(before + 0.4, 'f', 3));
    driver.shoot(dialog, "dialog_levels_dragged");
    return height(0);
}

void dialog(Driver& driver)
{
    double floor_m = 0;
    driver.reconstructQuietly(
        [&](QWidget* dialog)
        {
            dialog->findChild<QLineEdit*>("ifcPath")->setText("small.ifc");  // not this machine's folders
            driver.shoot(dialog, "dialog");
            tryPresets(driver, dialog);
            tabsOf(dialog)->setCurrentIndex(2);
            tryFiles(driver, dialog);
            tabsOf(dialog)->setCurrentIndex(1);
            floor_m = dragFloor(driver, dialog);
            dialog->findChild<QCheckBox*>("stage.columns")->setChecked(false);
        });
    const auto storeys = driver.named("Level 0");
    driver.check(storeys.size() == 1, "there is one storey");
    const QString elevation = storeys.empty() ? QString() : storeys.front()->getMetaData("Elevation").toString();
    driver.check(std::abs(elevation.section(' ', 0, 0).toDouble() - floor_m) < 0.002,
                 QString("the run takes the dragged floor %1: %2").arg(floor_m).arg(elevation));

    driver.select(driver.model());
    driver.action("S2B.Levels")->trigger();
    QTest::qWait(300);
    const auto again = driver.named("Level 0");
    driver.check(again.size() == 1 && again.front()->getMetaData("Elevation").toString() == elevation,
                 "and so does the stage Levels alone");

    driver.select(driver.cloud());
    driver.whenShown("S2BReconstructDlg",
                     [&](QWidget* dialog)
                     {
                         driver.check(!dialog->findChild<QCheckBox*>("stage.columns")->isChecked(),
                                      "the choices are remembered");
                         driver.press(dialog, QDialogButtonBox::Cancel);
                     });
    driver.action("S2B.Reconstruct")->trigger();
}

const Scenario kScenario("dialog", dialog);

}  // namespace
