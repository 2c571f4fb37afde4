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

const Scenario kScenario("labels", labels);

}  // namespace
