// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.h"

namespace
{

// A map that does not know the codes must be settled before anything can run.
void labels(Driver& driver)
{
    driver.select(driver.cloud());
    driver.whenShown("S2BReconstructDlg",
                     [&](QWidget* dialog)
                     {
                         auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
                         auto* field = dialog->findChild<QComboBox*>("labelField");
                         driver.check(!ok->isEnabled(), "codes that the map does not know can't be reconstructed");
                         driver.shoot("dialog_unknown_codes");
                         field->setCurrentIndex(0);
                         driver.check(ok->isEnabled(), "the geometry alone can be");
                         driver.press(dialog, QDialogButtonBox::Cancel);
                     });
    driver.action("S2B.Reconstruct")->trigger();
    driver.check(driver.named<ccMesh>("Wall ").empty(), "closing the dialog runs nothing");
}

/// In a build that brings no model with it, of a cloud without labels.
void withoutModel(Driver& driver)
{
    driver.select(driver.cloud());
    driver.whenShown("S2BReconstructDlg",
                     [&](QWidget* dialog)
                     {
                         auto* field = dialog->findChild<QComboBox*>("labelField");
                         const int row = field->findText("Those of the shipped model", Qt::MatchStartsWith);
                         driver.check(
                             row > 0 && !(field->model()->flags(field->model()->index(row, 0)) & Qt::ItemIsEnabled),
                             "the labels of a model that is not there can't be chosen");
                         driver.check(field->itemData(row, Qt::ToolTipRole).toString().contains("brings no model"),
                                      "and why is said");
                         driver.check(field->currentIndex() == 0, "the geometry alone is chosen");
                         field->showPopup();
                         driver.shoot("label_fields");
                         // As with the keyboard: the next row that can be had is the first field.
                         field->hidePopup();
                         QTest::keyClick(field, Qt::Key_Down);
                         driver.check(field->currentIndex() != row, "not with the keyboard either");
                         field->setCurrentIndex(0);
                         driver.press(dialog, QDialogButtonBox::Ok);
                     });
    driver.action("S2B.Reconstruct")->trigger();
    driver.check(!driver.named<ccMesh>("Wall ").empty(), "the geometry alone gives walls");
}

const Scenario kScenario("labels", labels);
const Scenario kWithoutModel("without_model", withoutModel);

}  // namespace
