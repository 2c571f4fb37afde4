// SPDX-License-Identifier: GPL-3.0-or-later
// The list of findings and their labels.
#include "driver.h"

#include <QDockWidget>

#include <cc2DLabel.h>

namespace
{

bool isLookedAt(Driver& driver, ccHObject* label)
{
    return driver.isInTheMiddle(static_cast<cc2DLabel*>(label)->getPickedPoint(0).getPointPosition().toDouble());
}

void checkList(Driver& driver, QTreeWidget* list)
{
    const auto labels = driver.labels();
    driver.check(!labels.empty() && list->topLevelItemCount() == static_cast<int>(labels.size()),
                 QString("each of %1 findings has a label and a row").arg(labels.size()));
    driver.app().setView(CC_ISO_VIEW_1);
    driver.app().setGlobalZoom();
    driver.check(
        std::none_of(labels.begin(), labels.end(), [&](ccHObject* label) { return isLookedAt(driver, label); }),
        "the middle of the building is no finding's place");
    QTreeWidgetItem* row = list->topLevelItem(list->topLevelItemCount() - 1);
    list->setCurrentItem(row);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, list->visualItemRect(row).center());
    QTest::qWait(200);
    const auto& selection = driver.app().getSelectedEntities();
    driver.check(selection.size() == 1 && selection.front()->isA(CC_TYPES::LABEL_2D), "a row selects its label");
    if (selection.size() != 1 || !selection.front()->isA(CC_TYPES::LABEL_2D))
        return;
    driver.check(isLookedAt(driver, selection.front()), "and takes the camera there");
    QTest::qWait(1000);  // docks glide into their place
    driver.shoot("findings");
}

void checkTree(Driver& driver)
{
    for (ccHObject* label : driver.labels())
    {
        driver.app().setGlobalZoom();
        driver.clickInTree(label);
        driver.check(driver.waitFor([&] { return isLookedAt(driver, label); }, 5000),
                     "so does a click in the tree on " + label->getName());
        driver.check(label->isEnabled() && static_cast<cc2DLabel*>(label)->isSelected(), "which shows the label");
    }
}

QString nameOfGroup(Driver& driver)
{
    const auto groups = driver.named("Findings (");
    return groups.size() == 1 ? groups.front()->getName() : QString();
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
    checkTree(driver);
    driver.select(driver.labels().front()->getParent());
    driver.check(!driver.action("S2B.Reconstruct")->isEnabled() && driver.action("S2B.ExportIfc")->isEnabled(),
                 "the findings' own cloud is a part of the model, no scan");

    dock->close();
    driver.unselectAll();
    driver.action("S2B.Findings")->trigger();
    driver.check(dock->isVisible(), "the list comes back");
    const int rows = list->topLevelItemCount();
    driver.check(nameOfGroup(driver) == QString("Findings (%1)").arg(rows), "the group counts them");
    driver.clickInTree(driver.labels().front());
    driver.app().getMainWindow()->findChild<QAction*>("actionDelete")->trigger();
    driver.check(driver.waitFor([&] { return list->topLevelItemCount() == rows - 1; }, 5000),
                 "a label that is deleted leaves the list");
    driver.check(driver.waitFor([&] { return nameOfGroup(driver) == QString("Findings (%1)").arg(rows - 1); }, 5000),
                 "and the group's count: " + nameOfGroup(driver));
    driver.app().removeFromDB(driver.model());
    driver.check(driver.waitFor([&] { return list->topLevelItemCount() == 0; }, 5000), "and so do all of a model");
    // With the list open, its model gone and CloudCompare closing next: nothing may crash.
}

const Scenario kScenario("findings", findings);

}  // namespace
