// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.h"

namespace
{

void checkValidation(Driver& driver)
{
    const auto copies = driver.named<ccPointCloud>(driver.cloud()->getName() + " [deviation]");
    driver.check(copies.size() == 1, "there is a copy of the cloud");
    if (copies.size() != 1)
        return;
    const ccScalarField* field = copies.front()->getCurrentDisplayedScalarField();
    driver.check(field && QString(field->getName()) == "S2B deviation" && copies.front()->sfShown(),
                 "it shows its deviations");
    double low = 0.0;
    double high = 0.0;
    if (field && field->getColorScale() && !field->getColorScale()->isRelative())
        field->getColorScale()->getAbsoluteBoundaries(low, high);
    driver.check(high > 0.0 && low == -high, QString("in colours that are symmetric about 0, to %1 m").arg(high));
    std::size_t near = 0;
    for (unsigned i = 0; field && i < field->size(); ++i)
        near += std::abs(field->getValue(i)) < 0.02F ? 1 : 0;
    driver.check(near > copies.front()->size() / 4, QString("%1 points lie on the model").arg(near));
    const auto within = driver.named("Within tolerance");
    driver.check(within.size() == 1 && within.front()->getParent()->getName().endsWith("[validation]"),
                 "there is a group of what is within tolerance");
    std::size_t walls = 0;
    for (unsigned i = 0; !within.empty() && i < within.front()->getChildrenNumber(); ++i)
    {
        const ccHObject* element = within.front()->getChild(i);
        walls += element->getMetaData("Class").toString() == "wall" && element->hasMetaData("GUID") ? 1 : 0;
    }
    driver.check(walls > 0, QString("%1 walls are within tolerance").arg(walls));
    driver.unselectAll();
    driver.app().setView(CC_ISO_VIEW_1);
    driver.app().setGlobalZoom();
    driver.app().redrawAll();
    driver.shoot("validation_deviations");
    copies.front()->setEnabled(false);
    if (!within.empty())
        driver.select(within.front()->getChild(0));
    driver.app().redrawAll();
    driver.shoot("validation_verdicts");
}

/// Fills the dialog as a user would and presses Validate; `onProgress` runs once the progress is shown.
void runValidation(Driver& driver, const QString& truth, const QString& folder, const QString& picture,
                   const std::function<void(QWidget*)>& onProgress = {})
{
    driver.selectBoth();
    driver.whenShown("S2BValidateDlg",
                     [=, &driver](QWidget* dialog)
                     {
                         dialog->findChild<QLineEdit*>("truth")->setText(truth);
                         dialog->findChild<QCheckBox*>("writeReport")->setChecked(true);
                         dialog->findChild<QLineEdit*>("report")->setText(folder);
                         dialog->findChild<QCheckBox*>("openReport")->setChecked(false);
                         auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
                         driver.check(ok->isEnabled() == QFile::exists(truth),
                                      "only a truth that is there can be compared with");
                         if (!picture.isEmpty())
                             driver.shoot(picture);
                         if (!ok->isEnabled())
                             return driver.press(dialog, QDialogButtonBox::Cancel);
                         if (onProgress)
                             driver.whenShown("S2BProgress", onProgress);
                         driver.press(dialog, QDialogButtonBox::Ok);
                     });
    driver.action("S2B.Validate")->trigger();
    QTest::qWait(300);
}

void validate(Driver& driver)
{
    const QString truth = qEnvironmentVariable("S2B_DRIVER_TRUTH");
    const QString folder = driver.output("window_report");
    QAction* validate = driver.action("S2B.Validate");
    driver.check(validate != nullptr, "the action is there");
    driver.unselectAll();
    driver.check(!validate->isEnabled(), "nothing can be validated without a selection");
    driver.reconstructQuietly();
    if (!driver.model())
        return driver.check(false, "there is a model");
    driver.select(driver.model());
    driver.check(validate->isEnabled(), "a model can be validated");
    driver.selectBoth();
    driver.check(driver.app().getSelectedEntities().size() == 2 && validate->isEnabled(),
                 "a model and a cloud can be validated together");

    // What is wrong, or cancelled, changes nothing.
    const std::size_t before = driver.entityCount();
    runValidation(driver, folder + "/no.ifc", folder, {});
    driver.whenShown("S2BMessage",
                     [&driver](QWidget* box)
                     {
                         driver.check(static_cast<QMessageBox*>(box)->text().contains("bad.ifc"),
                                      "a bad truth is named");
                         driver.shoot("validate_bad_truth");
                         QTest::mouseClick(static_cast<QMessageBox*>(box)->button(QMessageBox::Ok), Qt::LeftButton);
                     });
    runValidation(driver, qEnvironmentVariable("S2B_DRIVER_BAD_TRUTH"), folder, {});
    driver.check(driver.entityCount() == before && !QFile::exists(folder), "a bad truth changes nothing");
    ProcessorTime sinceCancel;
    runValidation(driver, truth, folder, {}, [&](QWidget* progress) { driver.cancel(progress, sinceCancel); });
    driver.checkCancelled(sinceCancel, "a validation");
    driver.check(driver.entityCount() == before && !QFile::exists(folder), "cancelling leaves nothing");

    const unsigned fields = driver.cloud()->getNumberOfScalarFields();
    runValidation(driver, truth, folder, "validate_dialog");
    driver.check(QFile::exists(folder + "/report.html"), "the report was written");
    driver.check(driver.cloud()->getNumberOfScalarFields() == fields, "the cloud is unchanged");
    checkValidation(driver);
}

const Scenario kScenario("validate", validate);

}  // namespace
