// SPDX-License-Identifier: GPL-3.0-or-later
// Selections that fit and that do not, two clouds at once, a cloud without labels; the input stays as it is.
#include "driver.h"

#include <QCryptographicHash>
#include <QSettings>

namespace
{

/// All that a run could change of a cloud.
QByteArray stateOf(ccPointCloud& cloud)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (unsigned i = 0; i < cloud.size(); ++i)
        hash.addData(reinterpret_cast<const char*>(cloud.getPoint(i)), sizeof(CCVector3));
    for (unsigned f = 0; f < cloud.getNumberOfScalarFields(); ++f)
    {
        const auto& field = *static_cast<ccScalarField*>(cloud.getScalarField(static_cast<int>(f)));
        hash.addData(QByteArray(field.getName()));
        hash.addData(reinterpret_cast<const char*>(field.data()), static_cast<int>(field.size() * sizeof(ScalarType)));
    }
    hash.addData(cloud.getName().toUtf8());
    hash.addData(QByteArray::number(cloud.getCurrentDisplayedScalarFieldIndex()));
    hash.addData(QByteArray::number(int(cloud.isEnabled()) + 2 * int(cloud.sfShown()) + 4 * int(cloud.isVisible())));
    hash.addData(QByteArray::number(cloud.getChildrenNumber()));
    return hash.result();
}

void selections(Driver& driver)
{
    ccPointCloud* cloud = driver.cloud();
    QAction* reconstruct = driver.action("S2B.Reconstruct");
    for (const QAction* action : driver.menu()->actions())
        driver.check(!action->icon().isNull() && action->toolTip().size() > 20,
                     action->text() + " has an icon and a tool tip");
    driver.unselectAll();
    for (const char* name : {"Reconstruct", "Segment", "Levels", "Walls", "Doors", "Columns", "Rooms", "Translucent",
                             "ExportIfc", "Validate", "FloorPlan"})
        driver.check(driver.action(QString("S2B.") + name) && !driver.action(QString("S2B.") + name)->isEnabled(),
                     QString("%1 needs a selection").arg(name));
    driver.select(cloud->getParent());
    driver.check(!reconstruct->isEnabled(), "a group is no cloud");
    auto* mesh = new ccMesh(cloud);
    mesh->setName("a mesh");
    driver.app().addToDB(mesh);
    driver.select(mesh);
    driver.check(!reconstruct->isEnabled() && !driver.action("S2B.ExportIfc")->isEnabled(), "nor is a mesh a model");
    driver.unselectAll();
    driver.app().removeFromDB(mesh);

    // The two halves are one room; the second has no labels, so that the run says why it uses none.
    ccPointCloud* other = cloud->cloneThis();
    other->setName("other half");
    const auto field = other->getScalarFieldIndexByName("Classification");
    if (field >= 0)
        other->deleteScalarField(field);
    driver.app().addToDB(other);
    driver.select(cloud);
    driver.selectToo(other);
    driver.check(driver.app().getSelectedEntities().size() == 2 && reconstruct->isEnabled(), "two clouds can be taken");
    const QByteArray before = stateOf(*cloud) + stateOf(*other);
    driver.whenShown("S2BReconstructDlg",
                     [&](QWidget* dialog)
                     {
                         driver.shoot("dialog_two_clouds");
                         driver.press(dialog, QDialogButtonBox::Ok);
                     });
    // The dialog's field is not in both clouds: that is said, and nothing is made.
    bool wasTold = false;
    driver.whenShown("S2BMessage",
                     [&](QWidget* box)
                     {
                         wasTold = static_cast<QMessageBox*>(box)->text().contains("other half");
                         QTest::mouseClick(static_cast<QMessageBox*>(box)->button(QMessageBox::Ok), Qt::LeftButton);
                     });
    reconstruct->trigger();
    driver.check(wasTold && driver.named<ccMesh>("Wall ").empty(), "a label field that one of them lacks is named");

    driver.whenShown("S2BReconstructDlg",
                     [&](QWidget* dialog)
                     {
                         dialog->findChild<QComboBox*>("labelField")->setCurrentIndex(0);
                         driver.press(dialog, QDialogButtonBox::Ok);
                     });
    reconstruct->trigger();
    driver.check(driver.named<ccMesh>("Wall ").size() == 4, "both together make one room");
    driver.check(stateOf(*cloud) + stateOf(*other) == before, "the clouds are as they were");
}

const Scenario kScenario("selections", selections);

}  // namespace
