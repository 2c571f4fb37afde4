// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a validation: sorting, filters, selecting, the report, and entities that go.
#include "driver.h"

#include <QDir>
#include <QDockWidget>
#include <QTableView>

namespace
{

void validateWithoutReport(Driver& driver)
{
    driver.selectBoth();
    driver.whenShown("S2BValidateDlg",
                     [&driver](QWidget* dialog)
                     {
                         dialog->findChild<QLineEdit*>("truth")->setText(qEnvironmentVariable("S2B_DRIVER_TRUTH"));
                         dialog->findChild<QCheckBox*>("writeReport")->setChecked(false);
                         driver.press(dialog, QDialogButtonBox::Ok);
                     });
    driver.action("S2B.Validate")->trigger();
}

QString cell(QTableView* table, int row, int column)
{
    return table->model()->index(row, column).data().toString();
}

void checkSorting(Driver& driver, QTableView* table)
{
    constexpr int kCentre = 7;
    table->sortByColumn(kCentre, Qt::DescendingOrder);
    double last = 1e9;
    bool isSorted = true;
    for (int row = 0; row < table->model()->rowCount(); ++row)
    {
        bool isNumber = false;
        const double value = cell(table, row, kCentre).section(' ', 0, 0).toDouble(&isNumber);
        isSorted = isSorted && (!isNumber || value <= last);
        last = isNumber ? value : last;
    }
    driver.check(isSorted && last < 1e9, "errors are sorted by their size");
    table->sortByColumn(0, Qt::AscendingOrder);
}

void checkFilters(Driver& driver, QDockWidget* dock, QTableView* table)
{
    const int all = table->model()->rowCount();
    auto* classes = dock->findChild<QComboBox*>("classFilter");
    classes->setCurrentText("wall");
    bool isOnlyWalls = table->model()->rowCount() > 0 && table->model()->rowCount() < all;
    for (int row = 0; row < table->model()->rowCount(); ++row)
        isOnlyWalls = isOnlyWalls && cell(table, row, 2) == "wall";
    driver.check(isOnlyWalls, "one class can be shown");
    classes->setCurrentIndex(0);
    dock->findChild<QLineEdit*>("search")->setText("no such element");
    driver.check(table->model()->rowCount() == 0, "a text that nothing has shows nothing");
    dock->findChild<QLineEdit*>("search")->clear();
    driver.check(table->model()->rowCount() == all, "without filters all are back");
}

void exportReport(Driver& driver, QDockWidget* dock)
{
    const QString folder = driver.output("exported_report");
    QDir(folder).removeRecursively();
    QDir().mkpath(folder);
    driver.whenShown("S2BExportReport",
                     [folder](QWidget* dialog)
                     {
                         static_cast<QFileDialog*>(dialog)->setDirectory(folder);
                         dialog->findChild<QLineEdit*>("fileNameEdit")->setText(folder);
                         QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
                     });
    dock->findChild<QPushButton*>("exportReport")->click();
    for (const char* name : {"report.html", "report.json", "elements.csv", "issues.bcf"})
        driver.check(QFile::exists(folder + "/" + name), QString("%1 is exported").arg(name));
}

void validationTable(Driver& driver)
{
    driver.reconstructQuietly();
    if (!driver.model())
        return driver.check(false, "there is a model");
    validateWithoutReport(driver);
    auto* dock = driver.app().getMainWindow()->findChild<QDockWidget*>("S2BValidationDock");
    driver.check(dock && dock->isVisible(), "the table is shown after a validation");
    if (!dock)
        return;
    auto* table = dock->findChild<QTableView*>("elements");
    driver.check(driver.waitFor([&] { return !table->visibleRegion().isEmpty(); }, 5000), "before the other lists");
    driver.check(table->model()->rowCount() > 8, QString("%1 elements are listed").arg(table->model()->rowCount()));
    dock->close();
    driver.action("S2B.ValidationTable")->trigger();
    driver.check(driver.waitFor([&] { return !table->visibleRegion().isEmpty(); }, 5000), "and comes back");
    checkSorting(driver, table);
    checkFilters(driver, dock, table);

    driver.app().setView(CC_ISO_VIEW_1);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier,
                      table->visualRect(table->model()->index(0, 3)).center());
    QTest::qWait(200);
    const auto selection = driver.app().getSelectedEntities();
    driver.check(selection.size() == 1 && selection.front()->getMetaData("No.").toString() == cell(table, 0, 0),
                 "a row selects its element");
    driver.check(selection.size() == 1 &&
                     driver.isInTheMiddle(selection.front()->getDisplayBB_recursive(false).getCenter().toDouble()),
                 "and takes the camera there");
    driver.app().setGlobalZoom();
    driver.shoot("validation_table");
    exportReport(driver, dock);

    const int rows = table->model()->rowCount();
    ccHObject* element = selection.empty() ? nullptr : selection.front();
    driver.unselectAll();
    if (element)
        driver.app().removeFromDB(element);
    driver.check(driver.waitFor([&] { return table->model()->rowCount() == rows - 1; }, 5000),
                 "an element that is deleted leaves the table");
    for (ccHObject* group : driver.named("Within tolerance"))
        driver.app().removeFromDB(group->getParent());
    driver.check(driver.waitFor([&] { return table->model()->rowCount() == 0; }, 5000),
                 "and so do all of a validation");
    driver.check(!dock->findChild<QPushButton*>("exportReport")->isEnabled(), "then there is no report either");
}

const Scenario kScenario("validation_table", validationTable);

}  // namespace
