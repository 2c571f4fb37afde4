// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.h"

namespace
{

// Cancels at three moments: at once, after a while, and late. Nothing may be left each time.
void cancel(Driver& driver)
{
    ccHObject::Container before;
    driver.app().dbRootObject()->filterChildren(before, true);
    for (const int delay_ms : {0, 400, 1200})
    {
        driver.select(driver.cloud());
        ProcessorTime sinceCancel;
        QString stage;
        driver.whenShown("S2BReconstructDlg",
                         [&](QWidget* dialog)
                         {
                             dialog->findChild<QCheckBox*>("writeIfc")->setChecked(true);
                             dialog->findChild<QLineEdit*>("ifcPath")->setText(driver.output("cancelled.ifc"));
                             driver.whenShown("S2BProgress",
                                              [&, delay_ms](QWidget* progress)
                                              {
                                                  QTest::qWait(delay_ms);
                                                  if (delay_ms == 400)
                                                      driver.shoot("cancel");
                                                  stage = static_cast<QProgressDialog*>(progress)->labelText();
                                                  sinceCancel.start();
                                                  QTest::mouseClick(progress->findChild<QPushButton*>(),
                                                                    Qt::LeftButton);
                                              });
                             driver.press(dialog, QDialogButtonBox::Ok);
                         });
        driver.action("S2B.Reconstruct")->trigger();
        driver.checkCancelled(sinceCancel, QString("after %1 ms, in \"%2\"").arg(delay_ms).arg(stage));
        ccHObject::Container after;
        driver.app().dbRootObject()->filterChildren(after, true);
        driver.check(after.size() == before.size(), "the tree is as it was");
        driver.check(!QFile::exists(driver.output("cancelled.ifc")), "no file was left");
    }
}

const Scenario kScenario("cancel", cancel);

}  // namespace
