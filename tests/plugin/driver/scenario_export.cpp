// SPDX-License-Identifier: GPL-3.0-or-later
// Export IFC...'s own field: the coordinate system, checked as the command does and remembered.
#include "driver.h"

namespace
{

/// Types a code and presses Save; true when a file was written. `said` gets the complaint, after which the dialog is
/// closed.
bool exportWith(Driver& driver, const QString& code, const QString& file, QString& remembered, QString* said = nullptr)
{
    QFile::remove(driver.output(file));
    driver.select(driver.model());
    driver.whenShown("S2BExportDialog",
                     [&, code, file](QWidget* dialog)
                     {
                         auto* field = dialog->findChild<QLineEdit*>("epsg");
                         if (!field || !field->isVisible())
                         {
                             driver.check(false, "there is a field for the coordinate system");
                             return static_cast<QDialog*>(dialog)->reject();
                         }
                         remembered = field->text();
                         field->setText(code);
                         if (code.trimmed() == "4647")
                             driver.shoot(dialog, "export_dialog");
                         dialog->findChild<QLineEdit*>("fileNameEdit")->setText(driver.output(file));
                         if (said)
                             driver.expectMessage(*said);
                         auto* buttons = dialog->findChild<QDialogButtonBox*>();
                         QTest::mouseClick(buttons->button(QDialogButtonBox::Save), Qt::LeftButton);
                         if (!said)
                             return;
                         driver.check(dialog->isVisible(), "the dialog stays open");
                         static_cast<QDialog*>(dialog)->reject();
                     });
    driver.action("S2B.ExportIfc")->trigger();
    QTest::qWait(200);
    return QFile::exists(driver.output(file));
}

void exportIfc(Driver& driver)
{
    driver.reconstructQuietly();
    if (!driver.model())
        return driver.check(false, "there is a model");
    QString remembered;
    for (const char* code : {"EPSG:4647", "0", "32632.5"})
    {
        QString said;
        driver.check(!exportWith(driver, code, "refused.ifc", remembered, &said),
                     QString("'%1' is not written").arg(code));
        driver.check(remembered.isEmpty(), "what was refused is not remembered");
        std::printf("refused %s\n", qPrintable(said));
    }
    driver.check(exportWith(driver, " 4647 ", "projected.ifc", remembered), "a code is taken");
    driver.check(exportWith(driver, "", "placed.ifc", remembered), "and so is none");
    driver.check(remembered == "4647", "a code is remembered: " + remembered);
    driver.check(exportWith(driver, "", "again.ifc", remembered) && remembered.isEmpty(), "as is that there is none");
}

const Scenario kScenario("export", exportIfc);

}  // namespace
