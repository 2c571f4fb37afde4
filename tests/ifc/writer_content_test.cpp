// SPDX-License-Identifier: GPL-3.0-or-later
// What the file says besides geometry, looked up through IfcOpenShell's parser.
#include "sample_building.h"
#include "test_files.h"

#include "core/validation/loa.h"
#include "ifc/relations.h"

#include <gtest/gtest.h>
#include <ifcparse/IfcFile.h>

#include <memory>
#include <set>

namespace s2b
{
namespace
{

using Instance = const IfcUtil::IfcBaseClass*;

class WriterContent : public testing::TestWithParam<const char*>
{
protected:
    void write(const Building& building)
    {
        ifc::WriteOptions options;
        options.schema = GetParam();
        options.projectName = "Größe";
        options.parameters = {{"walls.maxThickness", "0.6"}};
        ifc::writeIfc(building, m_folder.file("a.ifc"), options);
        m_file = std::make_unique<IfcParse::IfcFile>(m_folder.file("a.ifc"));
        ASSERT_TRUE(m_file->good());
    }
    [[nodiscard]] std::vector<Instance> all(const std::string& type) const
    {
        const auto found = m_file->instances_by_type(type);
        return found ? std::vector<Instance>(found->begin(), found->end()) : std::vector<Instance>();
    }
    [[nodiscard]] Instance named(const std::string& type, const std::string& name) const
    {
        for (const Instance i : all(type))
            if (ifc::attributeText(i, "Name") == name)
                return i;
        throw std::runtime_error("no " + type + ' ' + name);
    }
    [[nodiscard]] static std::vector<Instance> list(Instance i, const char* attribute)
    {
        const auto index = static_cast<std::size_t>(i->declaration().as_entity()->attribute_index(attribute));
        const aggregate_of_instance::ptr items = i->data().get_attribute_value(index);
        return {items->begin(), items->end()};
    }
    /// The property or quantity set of an element; null when it has none of that name.
    [[nodiscard]] Instance setOf(Instance element, const std::string& name) const
    {
        for (const Instance relation : all("IfcRelDefinesByProperties"))
            for (const Instance object : list(relation, "RelatedObjects"))
                if (object == element)
                    if (const Instance set = ifc::attributeInstance(relation, "RelatingPropertyDefinition");
                        ifc::attributeText(set, "Name") == name)
                        return set;
        return nullptr;
    }
    /// Text or number of a property; empty when there is no such property.
    [[nodiscard]] std::string property(Instance element, const std::string& set, const std::string& name) const
    {
        const Instance found = setOf(element, set);
        for (const Instance p : found == nullptr ? std::vector<Instance>() : list(found, "HasProperties"))
            if (ifc::attributeText(p, "Name") == name)
            {
                std::ostringstream text;
                const Instance value = p->declaration().name() == "IfcPropertyEnumeratedValue"
                                           ? list(p, "EnumerationValues").front()
                                           : ifc::attributeInstance(p, "NominalValue");
                value->toString(text, true);
                return text.str();
            }
        return {};
    }
    [[nodiscard]] double quantity(Instance element, const std::string& set, const std::string& name) const
    {
        for (const Instance q : list(setOf(element, set), "Quantities"))
            if (ifc::attributeText(q, "Name") == name)
                for (const char* value : {"LengthValue", "AreaValue", "VolumeValue"})
                    if (const auto number = ifc::attributeNumber(q, value))
                        return *number;
        throw std::runtime_error("no quantity " + name);
    }

    test::TestFolder m_folder;
    std::unique_ptr<IfcParse::IfcFile> m_file;
};
INSTANTIATE_TEST_SUITE_P(Schemas, WriterContent, testing::Values("IFC4", "IFC4X3_ADD2"));

TEST_P(WriterContent, CountsAreTheBuildings)
{
    const Building b = test::sampleBuilding();
    write(b);
    EXPECT_EQ(all("IfcBuildingStorey").size(), b.storeys.size());
    EXPECT_EQ(all("IfcWall").size(), b.walls.size());
    EXPECT_EQ(all("IfcOpeningElement").size(), b.openings.size());
    EXPECT_EQ(all("IfcRelVoidsElement").size(), b.openings.size());
    EXPECT_EQ(all("IfcDoor").size(), 5U);
    EXPECT_EQ(all("IfcWindow").size(), 3U);
    EXPECT_EQ(all("IfcRelFillsElement").size(), 8U);
    EXPECT_EQ(all("IfcColumn").size(), b.columns.size());
    EXPECT_EQ(all("IfcSlab").size(), b.slabs.size());
    EXPECT_EQ(all("IfcSpace").size(), b.spaces.size());
    EXPECT_EQ(all("IfcRelSpaceBoundary").size(), 6U);
    EXPECT_EQ(all("IfcRelConnectsPathElements").size(), b.junctions.size());
    EXPECT_EQ(all("IfcRelContainedInSpatialStructure").size(), 2U) << "one per storey";
    EXPECT_EQ(all("IfcMaterial").size(), 1U);
}

TEST_P(WriterContent, NamesKeepTheirLetters)
{
    write(test::sampleBuilding());
    EXPECT_EQ(ifc::attributeText(all("IfcProject").front(), "Name"), "Größe");
    EXPECT_NO_THROW((void)named("IfcBuildingStorey", "Étage 1 – 日本"));
    EXPECT_NO_THROW((void)named("IfcSpace", "Büro"));
}

TEST_P(WriterContent, GlobalIdsAreUnique)
{
    write(test::sampleBuilding());
    std::set<std::string> ids;
    const auto roots = all("IfcRoot");
    for (const Instance root : roots)
        ids.insert(ifc::attributeText(root, "GlobalId"));
    EXPECT_EQ(ids.size(), roots.size());
}

TEST_P(WriterContent, OperationTypeOnlyWhereTheLeafTells)
{
    write(test::sampleBuilding());
    const auto operation = [&](const char* name)
    { return ifc::attributeText(named("IfcDoor", name), "OperationType"); };
    // Hinge at the wall's start. Looking to the wall's left that is the left hand, looking to its right the right hand.
    EXPECT_EQ(operation("Door 30"), "SINGLE_SWING_LEFT");
    EXPECT_EQ(operation("Door 31"), "SINGLE_SWING_RIGHT");
    EXPECT_EQ(operation("Door 32"), "DOUBLE_DOOR_SINGLE_SWING");
    EXPECT_EQ(operation("Door 33"), "NOTDEFINED");
    EXPECT_EQ(operation("Door 38"), "NOTDEFINED");
    EXPECT_DOUBLE_EQ(ifc::attributeNumber(named("IfcDoor", "Door 30"), "OverallWidth").value(), 1.01);
    EXPECT_DOUBLE_EQ(ifc::attributeNumber(named("IfcDoor", "Door 30"), "OverallHeight").value(), 2.13);
}

TEST_P(WriterContent, ExternalIsSaidOnlyWhereItIsKnown)
{
    write(test::sampleBuilding());
    const auto external = [&](const char* type, const char* name, const char* set)
    { return property(named(type, name), set, "IsExternal"); };
    EXPECT_EQ(external("IfcWall", "Wall 10", "Pset_WallCommon"), "IFCBOOLEAN(.T.)");
    EXPECT_EQ(external("IfcWall", "Wall 14", "Pset_WallCommon"), "IFCBOOLEAN(.F.)");
    EXPECT_EQ(external("IfcWall", "Wall 15", "Pset_WallCommon"), "");
    EXPECT_EQ(external("IfcDoor", "Door 30", "Pset_DoorCommon"), "IFCBOOLEAN(.T.)");
    EXPECT_EQ(external("IfcDoor", "Door 38", "Pset_DoorCommon"), "");
    for (const char* invented : {"FireRating", "LoadBearing", "ThermalTransmittance", "AcousticRating"})
        EXPECT_EQ(property(named("IfcWall", "Wall 10"), "Pset_WallCommon", invented), "");
}

TEST_P(WriterContent, EvidenceTellsMeasuredFromAssumed)
{
    write(test::sampleBuilding());
    const auto evidence = [&](const char* name, const char* what)
    { return property(named("IfcWall", name), "S2B_Evidence", what); };
    EXPECT_EQ(evidence("Wall 10", "Points"), "IFCINTEGER(12345)");
    EXPECT_EQ(evidence("Wall 10", "FacesSeen"), "IFCINTEGER(2)");
    EXPECT_EQ(evidence("Wall 10", "CoverageRight"), "IFCNORMALISEDRATIOMEASURE(0.75)");
    EXPECT_EQ(evidence("Wall 10", "LevelOfAccuracy"), "IFCLABEL('LOA30')");  // 2 x 4 mm
    EXPECT_EQ(evidence("Wall 10", "ThicknessProvenance"), "IFCLABEL('Measured')");
    EXPECT_EQ(evidence("Wall 10", "ThicknessRms"), "IFCLENGTHMEASURE(0.004)");
    EXPECT_EQ(evidence("Wall 10", "Remarks"), "");
    EXPECT_EQ(evidence("Wall 14", "ThicknessProvenance"), "IFCLABEL('Assumed')");
    EXPECT_EQ(evidence("Wall 14", "ThicknessRms"), "");
    EXPECT_EQ(evidence("Wall 14", "Remarks"), "IFCTEXT('Only one face was seen; \"0.1 m\" isn''t measured')");
    EXPECT_EQ(property(all("IfcProject").front(), "S2B_Parameters", "walls.maxThickness"), "IFCLABEL('0.6')");
}

TEST_P(WriterContent, LevelOfAccuracyIsTheValidations)
{
    Building b = test::oneWall();
    b.walls[0].evidence.points = 1;
    for (const double rms : {0.0004, 0.0006, 0.002, 0.0026, 0.007, 0.008, 0.025, 0.026, 0.075, 0.076, 1.0})
    {
        b.walls[0].evidence.rms_m = rms;
        write(b);
        const std::string band = validation::loaName(validation::bandOf(2.0 * rms, {}));
        EXPECT_EQ(property(named("IfcWall", "Wall 2"), "S2B_Evidence", "LevelOfAccuracy"), "IFCLABEL('" + band + "')")
            << rms;
    }
    EXPECT_EQ(property(named("IfcWall", "Wall 2"), "S2B_Evidence", "LevelOfAccuracy"), "IFCLABEL('beyond LOA10')");
}

TEST_P(WriterContent, QuantitiesAgreeWithTheGeometry)
{
    const Building b = test::sampleBuilding();
    write(b);
    const auto open = ifc::readIfc(m_folder.file("a.ifc"));
    const auto closed = ifc::readIfc(m_folder.file("a.ifc"), {.subtractOpenings = false});
    for (const Wall& wall : b.walls)
    {
        const std::string name = "Wall " + std::to_string(wall.id.value);
        const Instance element = named("IfcWall", name);
        const double gross = quantity(element, "Qto_WallBaseQuantities", "GrossVolume");
        const double net = quantity(element, "Qto_WallBaseQuantities", "NetVolume");
        // 0.1 %, and for the reader's 1 mm chords on arcs another 0.1 %.
        const double tolerance = wall.bulge == 0.0 ? 0.001 : 0.002;
        EXPECT_NEAR(gross, test::volumeOf(test::elementOf(closed, "IfcWall", name)), tolerance * gross) << name;
        EXPECT_NEAR(net, test::volumeOf(test::elementOf(open, "IfcWall", name)), tolerance * net) << name;
    }
    for (const Column& column : b.columns)
    {
        const std::string name = "Column " + std::to_string(column.id.value);
        const Instance element = named("IfcColumn", name);
        const double volume = test::volumeOf(test::elementOf(open, "IfcColumn", name));
        const bool isRound = std::holds_alternative<CircleSection>(column.section);
        const double tolerance = (isRound ? 0.004 : 1e-6) * volume;  // the reader's 1 mm chords
        for (const char* which : {"GrossVolume", "NetVolume"})
            EXPECT_NEAR(quantity(element, "Qto_ColumnBaseQuantities", which), volume, tolerance) << name;
        EXPECT_NEAR(quantity(element, "Qto_ColumnBaseQuantities", "CrossSectionArea"), volume / column.height.value_m,
                    tolerance / column.height.value_m)
            << name;
    }
    EXPECT_NEAR(quantity(named("IfcSlab", "Slab 50"), "Qto_SlabBaseQuantities", "NetVolume"),
                test::volumeOf(test::elementOf(open, "IfcSlab", "Slab 50")), 1e-6);
    EXPECT_NEAR(quantity(named("IfcSpace", "Room 2"), "Qto_SpaceBaseQuantities", "NetVolume"),
                test::volumeOf(test::elementOf(open, "IfcSpace", "Room 2")), 1e-6);
}

TEST_P(WriterContent, OverlappingAndProtrudingOpeningsCountOnce)
{
    Building b = test::oneWall();  // 6 x 0.2 x 2.8
    const auto add = [&](unsigned id, double offset, double width, double height, double sill)
    {
        Opening o;
        o.id = {id};
        o.host = {2};
        o.offset_m = offset;
        o.width.value_m = width;
        o.height.value_m = height;
        o.sill.value_m = sill;
        b.openings.push_back(o);
    };
    add(3, 1.0, 1.0, 2.0, 0.0);
    add(4, 1.5, 1.0, 2.0, 0.0);  // half of it is in the first
    add(5, 5.5, 1.0, 1.0, 2.3);  // sticks out of the end and the top: 0.5 x 0.5 is left
    write(b);
    const Instance wall = named("IfcWall", "Wall 2");
    const auto q = [&](const char* name) { return quantity(wall, "Qto_WallBaseQuantities", name); };
    EXPECT_NEAR(q("NetSideArea"), 6.0 * 2.8 - 1.5 * 2.0 - 0.25, 1e-9);
    EXPECT_NEAR(q(GetParam() == std::string("IFC4") ? "NetFootprintArea" : "NetFootPrintArea"), 6.0 * 0.2 - 1.5 * 0.2,
                1e-9);
    EXPECT_NEAR(q("NetVolume"),
                test::volumeOf(test::elementOf(ifc::readIfc(m_folder.file("a.ifc")), "IfcWall", "Wall 2")), 1e-6);
}

TEST_P(WriterContent, ElementsOfOneSizeShareTheirType)
{
    write(test::sampleBuilding());
    EXPECT_EQ(all("IfcWallType").size(), 2U) << "200 mm and 100 mm";
    std::size_t typed = 0;
    for (const Instance relation : all("IfcRelDefinesByType"))
        typed += list(relation, "RelatedObjects").size();
    EXPECT_EQ(typed, 11U + 5U + 3U + 6U + 2U) << "walls, doors, windows, columns, slabs";
}

TEST_P(WriterContent, SectionsAreTheStandardsProfiles)
{
    write(test::sampleBuilding());
    const auto only = [&](const char* entity)
    {
        const auto profiles = all(entity);
        EXPECT_EQ(profiles.size(), 1U) << entity;
        return profiles.front();
    };
    const auto size = [](Instance profile, const char* attribute)
    { return ifc::attributeNumber(profile, attribute).value_or(-1.0); };
    const Instance i = only("IfcIShapeProfileDef");
    EXPECT_EQ(size(i, "OverallWidth"), 0.30);
    EXPECT_EQ(size(i, "OverallDepth"), 0.28);
    EXPECT_EQ(size(i, "WebThickness"), 0.011);
    EXPECT_EQ(size(i, "FlangeThickness"), 0.019);
    const Instance l = only("IfcLShapeProfileDef");
    EXPECT_EQ(size(l, "Width"), 0.25);
    EXPECT_EQ(size(l, "Depth"), 0.20);
    EXPECT_EQ(size(l, "Thickness"), 0.020);
    EXPECT_EQ(size(only("IfcUShapeProfileDef"), "FlangeWidth"), 0.10);
    EXPECT_EQ(size(only("IfcTShapeProfileDef"), "Depth"), 0.15);
    EXPECT_EQ(property(named("IfcColumn", "Column 42"), "Pset_ColumnCommon", "Reference"),
              "IFCIDENTIFIER('Column I 300 x 280 mm, web 11 mm, flange 19 mm')");
}

TEST_P(WriterContent, JunctionsSayWhichEnds)
{
    write(test::sampleBuilding());
    for (const Instance relation : all("IfcRelConnectsPathElements"))
        if (ifc::attributeText(ifc::attributeInstance(relation, "RelatingElement"), "Name") == "Wall 14")
        {
            EXPECT_EQ(ifc::attributeText(relation, "RelatingConnectionType"), "ATSTART");
            EXPECT_EQ(ifc::attributeText(relation, "RelatedConnectionType"), "ATPATH");
            return;
        }
    FAIL() << "wall 14 joins nothing";
}

TEST_P(WriterContent, EmptyBuildingIsWrittenAndExplained)
{
    Building b;
    b.diagnostics = {{Severity::Error, "levels", "NoFloor", "No floor was found", {}, {}}};
    write(b);
    EXPECT_EQ(property(all("IfcBuilding").front(), "S2B_Evidence", "Remarks"), "IFCTEXT('No floor was found')");
    EXPECT_EQ(all("IfcProject").size(), 1U);
    EXPECT_EQ(all("IfcBuilding").size(), 1U);
    EXPECT_TRUE(all("IfcElement").empty());
}

}  // namespace
}  // namespace s2b
