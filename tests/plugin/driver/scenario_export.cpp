// SPDX-License-Identifier: GPL-3.0-or-later
// The field for the coordinate system, in Export IFC... and in Reconstruct...: checked as the command does and
// remembered.
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

/// The same in Reconstruct...'s dialog, on the page of the levels.
bool reconstructWith(Driver& driver, const QString& code, const QString& file, QString& remembered,
                     QString* said = nullptr)
{
    QFile::remove(driver.output(file));
    driver.select(driver.cloud());
    driver.whenShown("S2BReconstructDlg",
                     [&, code, file](QWidget* dialog)
                     {
                         auto* field = dialog->findChild<QLineEdit*>("epsg");
                         auto* tabs = dialog->findChild<QTabWidget*>("tabs");
                         if (!field || !field->isVisible())
                         {
                             driver.check(false, "there is a field for the coordinate system");
                             return static_cast<QDialog*>(dialog)->reject();
                         }
                         remembered = field->text();
                         dialog->findChild<QCheckBox*>("writeIfc")->setChecked(true);
                         driver.check(field->isEnabled(), "the file that is written can have one");
                         dialog->findChild<QLineEdit*>("ifcPath")->setText(driver.output(file));
                         field->setText(code);
                         tabs->setCurrentIndex(2);
                         if (said)
                             driver.expectMessage(*said);
                         driver.press(dialog, QDialogButtonBox::Ok);
                         if (!said)
                             return;
                         driver.check(dialog->isVisible() && field->isVisible(),
                                      "the dialog stays open, with the field in it");
                         static_cast<QDialog*>(dialog)->reject();
                     });
    driver.action("S2B.Reconstruct")->trigger();
    QTest::qWait(200);
    return QFile::exists(driver.output(file));
}

/// Whichever of the two writes: no file, no memory, and the complaint for the test to read.
void refuseWrongCodes(Driver& driver, decltype(exportWith)& write)
{
    QString remembered;
    for (const char* code : {"EPSG:4647", "0", "32632.5"})
    {
        QString said;
        driver.check(!write(driver, code, "refused.ifc", remembered, &said),
                     QString("nothing is written in '%1'").arg(code));
        driver.check(remembered.isEmpty(), "what was refused is not remembered");
        std::printf("refused %s\n", qPrintable(said));
    }
}

void reconstruct(Driver& driver)
{
    refuseWrongCodes(driver, reconstructWith);
    QString remembered;
    driver.check(reconstructWith(driver, " 4647 ", "reconstructed.ifc", remembered), "a code is taken");
    driver.check(exportWith(driver, "", "last.ifc", remembered), "and the model can be exported without");
    driver.check(remembered == "4647", "where the code is remembered: " + remembered);
}

void exportIfc(Driver& driver)
{
    // Without a file there is nothing to be in a coordinate system.
    driver.reconstructQuietly(
        [&driver](QWidget* dialog)
        {
            auto* field = dialog->findChild<QLineEdit*>("epsg");
            driver.check(field && !field->isEnabled(), "without a file the field is not needed");
            if (field)
                field->setText("nonsense");
        });
    if (!driver.model())
        return driver.check(false, "there is a model");
    QString remembered;
    refuseWrongCodes(driver, exportWith);
    driver.check(exportWith(driver, " 4647 ", "projected.ifc", remembered), "a code is taken");
    driver.check(exportWith(driver, "", "placed.ifc", remembered), "and so is none");
    driver.check(remembered == "4647", "a code is remembered: " + remembered);
    driver.check(exportWith(driver, "", "again.ifc", remembered) && remembered.isEmpty(), "as is that there is none");
    reconstruct(driver);
}

const Scenario kScenario("export", exportIfc);

}  // namespace
