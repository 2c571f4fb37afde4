// SPDX-License-Identifier: GPL-3.0-or-later
// Levels, Walls, Doors, Columns and Rooms one after another, with corrections in between.
#include "driver.h"

#include <ccPlane.h>

namespace
{

const QStringList kStages{"S2B.Levels", "S2B.Walls", "S2B.Doors", "S2B.Columns", "S2B.Rooms"};

bool areEnabled(Driver& driver, bool isEnabled)
{
    return std::all_of(kStages.begin(), kStages.end(), [&](const QString& name)
                       { return driver.action(name) && driver.action(name)->isEnabled() == isEnabled; });
}

void runStage(Driver& driver, const QString& name, ccHObject* on)
{
    driver.select(on);
    driver.action("S2B." + name)->trigger();
    QTest::qWait(300);
}

std::size_t count(Driver& driver, const QString& start)
{
    std::size_t n = 0;
    for (const ccHObject* entity : driver.named(start))
        n += entity->hasMetaData("S2B.Id") ? 1 : 0;
    return n;
}

void look(Driver& driver, const QString& picture)
{
    driver.unselectAll();
    driver.cloud()->setEnabled(false);
    driver.app().setView(CC_ISO_VIEW_1);
    driver.app().setGlobalZoom();
    driver.app().redrawAll();
    driver.shoot(picture);
    driver.cloud()->setEnabled(true);
}

void wrongSelections(Driver& driver)
{
    driver.unselectAll();
    driver.check(areEnabled(driver, false), "no stage is enabled without a selection");
    driver.select(driver.cloud());
    driver.check(areEnabled(driver, true), "every stage can be run on a cloud");
    driver.select(driver.cloud()->getParent());
    driver.check(areEnabled(driver, false), "none can be run on a group that is no model");
}

void correctLevels(Driver& driver)
{
    const auto planes = driver.named<ccPlane>("Floor level");
    driver.check(planes.size() == 1, QString("there is a level plane: %1").arg(planes.size()));
    if (planes.empty())
        return;
    ccGLMatrix up;
    up.setTranslation(CCVector3(0, 0, 0.1F));
    driver.applyTransformation(planes.front(), up);
    runStage(driver, "Walls", driver.model());
    const auto walls = driver.named<ccMesh>("Wall ");
    driver.check(walls.size() >= 5, QString("walls were found: %1").arg(walls.size()));
    driver.check(!walls.empty() && walls.front()->getMetaData("Base").toString() == "0.100 m",
                 "they stand on the level as it was moved: " +
                     (walls.empty() ? QString() : walls.front()->getMetaData("Base").toString()));
    driver.check(driver.named<ccPlane>("Floor level").size() == 1, "the level plane is still there");
}

/// What of the findings in the tree is about walls.
std::vector<ccHObject*> wallFindings(Driver& driver)
{
    return driver.named("Thickness assumed: Wall");
}

/// Labels and list follow what a stage finds; what a person took out of them stays out.
void checkFindings(Driver& driver)
{
    auto* list = driver.app().getMainWindow()->findChild<QTreeWidget*>("findings");
    const auto isListed = [&]
    {
        ccHObject::Container labels;
        driver.model()->filterChildren(labels, true, CC_TYPES::LABEL_2D, true);
        return list && list->topLevelItemCount() == static_cast<int>(labels.size());
    };
    const auto found = wallFindings(driver);
    driver.check(found.size() >= 2, QString("walls that were seen from one side are findings: %1").arg(found.size()));
    driver.check(driver.waitFor(isListed, 5000), "and in the list");
    if (found.size() < 2)
        return;
    const QString gone = found.front()->getMetaData("Element").toString();
    const QString dismissed = found.back()->getMetaData("Element").toString();
    driver.unselectAll();
    driver.app().removeFromDB(driver.named<ccMesh>(gone).front());
    driver.app().removeFromDB(found.back());
    runStage(driver, "Walls", driver.model());
    bool isBack = false;
    for (ccHObject* finding : wallFindings(driver))
    {
        const QString element = finding->getMetaData("Element").toString();
        isBack = isBack || element == gone || element == dismissed;
    }
    driver.check(!isBack, "findings of a wall that is gone, and such that were taken out, don't come back");
    driver.check(wallFindings(driver).size() == found.size() - 2, "the others stay");
    driver.check(driver.waitFor(isListed, 5000), "and the list follows");
}

void stages(Driver& driver)
{
    wrongSelections(driver);
    runStage(driver, "Levels", driver.cloud());
    driver.check(driver.model() && count(driver, "Level ") == 1, "levels alone give a model");
    driver.check(driver.named<ccMesh>("Wall ").empty(), "and no walls");
    look(driver, "stage_levels");
    correctLevels(driver);
    look(driver, "stage_walls");

    // What was taken out stays out, and other walls give other doors.
    const std::size_t before = driver.named<ccMesh>("Wall ").size();
    checkFindings(driver);
    const auto storeys = driver.named("Level 0");
    runStage(driver, "Walls", storeys.empty() ? driver.model() : storeys.front());
    driver.check(driver.named<ccMesh>("Wall ").size() == before - 1, "a wall that was taken out is not found again");
    runStage(driver, "Doors", driver.model());
    driver.check(count(driver, "Door ") > 0 && count(driver, "Window ") > 0, "doors and windows were found");
    runStage(driver, "Columns", driver.cloud());
    driver.check(count(driver, "Column ") > 0, "columns were found, in the model of the cloud");
    driver.selectBoth();
    driver.check(areEnabled(driver, true), "cloud and model can be selected together");
    driver.action("S2B.Rooms")->trigger();
    QTest::qWait(300);
    driver.check(count(driver, "Slab ") > 0, "slabs were found");
    look(driver, "stage_rooms");
    driver.check(driver.exportModel("stages.ifc"), "the model was exported");
    std::printf("walls %zu\ndoors %zu\n", driver.named<ccMesh>("Wall ").size(), count(driver, "Door "));

    // Without its cloud a model can't be looked at again.
    driver.unselectAll();
    driver.app().removeFromDB(driver.cloud());
    QString said;
    driver.expectMessage(said);
    runStage(driver, "Walls", driver.model());
    driver.check(said.contains("not in the tree"), "a missing cloud is said: " + said);
}

const Scenario kScenario("stages", stages);

}  // namespace
