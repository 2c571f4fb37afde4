// SPDX-License-Identifier: GPL-3.0-or-later
// The list of findings and their labels.
#include "driver.h"

#include <QDockWidget>

#include <cc2DLabel.h>
#include <ccGLWindowInterface.h>

namespace
{

std::vector<ccHObject*> labelsOf(Driver& driver)
{
    ccHObject::Container labels;
    driver.app().dbRootObject()->filterChildren(labels, true, CC_TYPES::LABEL_2D, true);
    return {labels.begin(), labels.end()};
}

CCVector3d pivot(Driver& driver)
{
    return driver.app().getActiveGLWindow()->getViewportParameters().getPivotPoint();
}

void checkList(Driver& driver, QTreeWidget* list)
{
    const auto labels = labelsOf(driver);
    driver.check(!labels.empty() && list->topLevelItemCount() == static_cast<int>(labels.size()),
                 QString("each of %1 findings has a label and a row").arg(labels.size()));
    driver.app().setGlobalZoom();
    const CCVector3d before = pivot(driver);
    QTreeWidgetItem* row = list->topLevelItem(list->topLevelItemCount() - 1);
    list->setCurrentItem(row);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, list->visualItemRect(row).center());
    QTest::qWait(200);
    const auto& selection = driver.app().getSelectedEntities();
    driver.check(selection.size() == 1 && selection.front()->isA(CC_TYPES::LABEL_2D), "a row selects its label");
    if (selection.size() != 1 || !selection.front()->isA(CC_TYPES::LABEL_2D))
        return;
    const auto place = [](ccHObject* label)
    { return static_cast<cc2DLabel*>(label)->getPickedPoint(0).getPointPosition().toDouble(); };
    driver.check((pivot(driver) - place(selection.front())).norm() < 0.5 && (pivot(driver) - before).norm() > 0.01,
                 "and takes the camera there");
    QTest::qWait(1000);  // docks glide into their place
    driver.shoot("findings");
}

void findings(Driver& driver)
{
    driver.reconstructQuietly();
    if (!driver.model())
        return driver.check(false, "there is a model");
    auto* dock = driver.app().getMainWindow()->findChild<QDockWidget*>("S2BFindingsDock");
    driver.check(dock && dock->isVisible(), "the findings are listed after a run");
    if (!dock)
        return;
    auto* list = dock->findChild<QTreeWidget*>("findings");
    checkList(driver, list);

    dock->close();
    driver.unselectAll();
    driver.action("S2B.Findings")->trigger();
    driver.check(dock->isVisible(), "the list comes back");
    ccHObject* label = labelsOf(driver).front();
    const int rows = list->topLevelItemCount();
    driver.unselectAll();
    driver.app().removeFromDB(label);
    driver.check(driver.waitFor([&] { return list->topLevelItemCount() == rows - 1; }, 5000),
                 "a label that is deleted leaves the list");
    driver.app().removeFromDB(driver.model());
    driver.check(driver.waitFor([&] { return list->topLevelItemCount() == 0; }, 5000), "and so do all of a model");
    // With the list open, its model gone and CloudCompare closing next: nothing may crash.
}

const Scenario kScenario("findings", findings);

}  // namespace
