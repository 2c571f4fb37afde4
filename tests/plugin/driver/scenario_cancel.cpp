// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.h"

#include <QPointer>

namespace
{

/// Cancels as soon as the progress says something that begins so, and has the time until the end of the run measured.
void cancelWhen(Driver& driver, const QString& moment, QWidget* progress, ProcessorTime& sinceCancel)
{
    const QPointer<QProgressDialog> dialog = static_cast<QProgressDialog*>(progress);
    driver.waitFor([&] { return !dialog || dialog->labelText().startsWith(moment); });
    if (!dialog || !dialog->labelText().startsWith(moment))
        return driver.check(false, "the progress said \"" + moment + "\"");
    if (moment.startsWith("Sorting"))
        driver.shoot(dialog, "progress");
    if (dialog)
        driver.cancel(dialog, sinceCancel);
}

// Cancels at three moments: in the points, in the cells, and with the walls. Nothing may be left each time.
void cancel(Driver& driver)
{
    const std::size_t before = driver.entityCount();
    for (const QString moment : {"Reading the points", "Sorting the points", "Walls"})
    {
        driver.select(driver.cloud());
        ProcessorTime sinceCancel;
        driver.whenShown("S2BReconstructDlg",
                         [&](QWidget* dialog)
                         {
                             dialog->findChild<QCheckBox*>("writeIfc")->setChecked(true);
                             dialog->findChild<QLineEdit*>("ifcPath")->setText(driver.output("cancelled.ifc"));
                             driver.whenShown("S2BProgress", [&](QWidget* progress)
                                              { cancelWhen(driver, moment, progress, sinceCancel); });
                             driver.press(dialog, QDialogButtonBox::Ok);
                         });
        driver.action("S2B.Reconstruct")->trigger();
        driver.checkCancelled(sinceCancel, QString("in \"%1\"").arg(moment));
        driver.check(driver.entityCount() == before, "the tree is as it was");
        driver.check(!QFile::exists(driver.output("cancelled.ifc")), "no file was left");
    }
}

const Scenario kScenario("cancel", cancel);

}  // namespace
