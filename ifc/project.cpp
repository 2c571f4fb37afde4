// SPDX-License-Identifier: GPL-3.0-or-later
// The spatial structure, and the relations that are written once at the end.
#include "ifc/guid.h"
#include "ifc/model.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace s2b::ifc
{

Model::Model(const Building& building, const WriteOptions& options)
    : m_building(building),
      m_options(options),
      m_builder(options.schema),
      m_shapes(m_builder),
      m_properties(m_builder, options.projectName)
{
    for (const Wall& wall : building.walls)
        m_wallById[wall.id] = &wall;
    for (const Opening& opening : building.openings)
        m_openingsOf[opening.host].push_back(&opening);
    for (const Diagnostic& diagnostic : building.diagnostics)
    {
        std::string& remarks = m_remarks[diagnostic.element];  // id 0: of the building as a whole
        remarks += (remarks.empty() ? "" : "; ") + diagnostic.text;
    }

    const Instance project =
        m_builder.add("IfcProject", {{"GlobalId", guid("project")},
                                     {"Name", options.projectName},
                                     {"RepresentationContexts", InstanceList{m_shapes.modelContext()}},
                                     {"UnitsInContext", units()}});
    std::vector<Property> parameters;
    for (const auto& [name, value] : options.parameters)
        parameters.push_back({name, {value.size() < 256 ? "IfcLabel" : "IfcText", value}});
    m_properties.add(project, "project", "S2B_Parameters", parameters);
    m_properties.add(project, "project", "S2B_Evidence",
                     {{"SoftwareVersion", {"IfcLabel", std::string("Scan to BIM ") + S2B_VERSION}}});
    addSite(project);
}

std::string Model::guid(std::string_view role) const
{
    return globalId(m_options.projectName, role);
}

std::string Model::nameOf(const char* kind, ElementId id) const
{
    const auto given = m_options.names.find(id);
    return given == m_options.names.end() ? std::string(kind) + ' ' + std::to_string(id.value) : given->second;
}

std::string Model::key(const char* kind, ElementId id)
{
    return std::string(kind) + '/' + std::to_string(id.value);
}

std::string Model::text() const
{
    return m_builder.text({m_options.projectName, m_options.timestamp, std::string("Scan to BIM ") + S2B_VERSION});
}

Instance Model::units()
{
    const auto unit = [&](std::string_view type, std::string_view name)
    { return m_builder.add("IfcSIUnit", {{"UnitType", Enumeration{type}}, {"Name", Enumeration{name}}}); };
    m_metre = unit("LENGTHUNIT", "METRE");
    const InstanceList all = {m_metre, unit("AREAUNIT", "SQUARE_METRE"), unit("VOLUMEUNIT", "CUBIC_METRE"),
                              unit("PLANEANGLEUNIT", "RADIAN")};
    return m_builder.add("IfcUnitAssignment", {{"Units", all}});
}

void Model::addMapConversion(int epsg)
{
    const Frame& frame = m_building.frame;
    const Instance crs =
        m_builder.add("IfcProjectedCRS", {{"Name", "EPSG:" + std::to_string(epsg)}, {"MapUnit", m_metre}});
    m_builder.add("IfcMapConversion", {{"SourceCRS", m_shapes.modelContext()},
                                       {"TargetCRS", crs},
                                       {"Eastings", frame.origin.x()},
                                       {"Northings", frame.origin.y()},
                                       {"OrthogonalHeight", frame.origin.z()},
                                       {"XAxisAbscissa", std::cos(frame.yaw_rad)},
                                       {"XAxisOrdinate", std::sin(frame.yaw_rad)},
                                       {"Scale", 1.0}});
}

void Model::addSite(Instance project)
{
    const Frame& frame = m_building.frame;
    Instance sitePlacement;
    Builder::Value datum;
    if (m_options.epsg)
    {
        addMapConversion(*m_options.epsg);
        sitePlacement = m_shapes.placement({}, Eigen::Vector3d::Zero());
        datum = frame.origin.z();
    }
    else
        sitePlacement = m_shapes.placement({}, frame.origin, {std::cos(frame.yaw_rad), std::sin(frame.yaw_rad)});
    m_buildingPlacement = m_shapes.placement(sitePlacement, Eigen::Vector3d::Zero());

    const Instance site = m_builder.add("IfcSite", {{"GlobalId", guid("site")},
                                                    {"Name", "Site"},
                                                    {"ObjectPlacement", sitePlacement},
                                                    {"CompositionType", Enumeration{"ELEMENT"}},
                                                    {"RefElevation", datum}});
    const Instance building = m_builder.add("IfcBuilding", {{"GlobalId", guid("building")},
                                                            {"Name", m_options.projectName},
                                                            {"ObjectPlacement", m_buildingPlacement},
                                                            {"CompositionType", Enumeration{"ELEMENT"}},
                                                            {"ElevationOfRefHeight", frame.origin.z()}});
    if (m_remarks.contains(ElementId{}))
        addEvidence(building, "building", ElementId{}, nullptr, {});
    aggregate("project", project, {site});
    aggregate("site", site, {building});

    InstanceList storeys;
    for (const Storey& storey : m_building.storeys)
    {
        const Instance placement = m_shapes.placement(m_buildingPlacement, {0.0, 0.0, storey.elevation_m});
        const Instance instance = m_builder.add("IfcBuildingStorey", {{"GlobalId", guid(key("storey", storey.id))},
                                                                      {"Name", storey.name},
                                                                      {"ObjectPlacement", placement},
                                                                      {"CompositionType", Enumeration{"ELEMENT"}},
                                                                      {"Elevation", storey.elevation_m}});
        storeys.push_back(instance);
        m_storeys[storey.id] = {instance, placement};
        m_elevations[storey.id] = storey.elevation_m;
        m_containers.push_back({storey.id, {}, {}});
        if (storey.height.value_m > 0.0)
            addEvidence(instance, key("storey", storey.id), storey.id, nullptr, {{"Height", storey.height}},
                        {{"Height", {"IfcLengthMeasure", storey.height.value_m}}});
    }
    if (!storeys.empty())
        aggregate("building", building, storeys);
}

Instance Model::storeyPlacement(ElementId storey, const Eigen::Vector3d& buildingPoint, const Eigen::Vector2d& x)
{
    return m_shapes.placement(m_storeys.at(storey).placement,
                              buildingPoint - Eigen::Vector3d(0.0, 0.0, m_elevations.at(storey)), x);
}

void Model::aggregate(const std::string& parentKey, Instance parent, const InstanceList& children)
{
    m_builder.add("IfcRelAggregates",
                  {{"GlobalId", guid(parentKey + "/parts")}, {"RelatingObject", parent}, {"RelatedObjects", children}});
}

void Model::contain(ElementId storey, Instance element)
{
    const auto it =
        std::find_if(m_containers.begin(), m_containers.end(), [&](const Container& c) { return c.storey == storey; });
    it->elements.push_back(element);
}

void Model::addEvidence(Instance object, const std::string& elementKey, ElementId id, const Evidence* evidence,
                        const std::vector<Named>& dimensions, std::vector<Property> properties)
{
    if (evidence != nullptr)
    {
        // IFC integers have 32 bits: more than 2e9 points of one element are said to be that many.
        const auto points = std::min<std::uint64_t>(evidence->points, std::numeric_limits<int>::max());
        properties.push_back({"Points", {"IfcInteger", static_cast<int>(points)}});
        properties.push_back({"FacesSeen", {"IfcInteger", evidence->facesSeen}});
        properties.push_back({"CoverageLeft", {"IfcNormalisedRatioMeasure", evidence->faceCoverage[0]}});
        properties.push_back({"CoverageRight", {"IfcNormalisedRatioMeasure", evidence->faceCoverage[1]}});
        properties.push_back({"LabelShare", {"IfcNormalisedRatioMeasure", evidence->labelShare}});
        if (evidence->points > 0)
        {
            properties.push_back({"RmsDistance", {"IfcLengthMeasure", evidence->rms_m}});
            properties.push_back({"LevelOfAccuracy", {"IfcLabel", std::string(accuracyBand(evidence->rms_m))}});
        }
    }
    for (const auto& [name, dimension] : dimensions)
    {
        properties.push_back(
            {std::string(name) + "Provenance", {"IfcLabel", std::string(provenanceName(dimension.provenance))}});
        if (dimension.provenance != Provenance::Assumed)
            properties.push_back({std::string(name) + "Rms", {"IfcLengthMeasure", dimension.rms_m}});
    }
    if (m_options.placedByHand.contains(id))
        properties.push_back({"PlacementProvenance", {"IfcLabel", std::string(provenanceName(Provenance::Corrected))}});
    if (const auto it = m_remarks.find(id); it != m_remarks.end())
        properties.push_back({"Remarks", {"IfcText", it->second}});
    properties.push_back({"SoftwareVersion", {"IfcLabel", std::string("Scan to BIM ") + S2B_VERSION}});
    m_properties.add(object, elementKey, "S2B_Evidence", properties);
}

void Model::assignType(const std::string& name, const char* entity, const std::vector<Builder::Attribute>& more,
                       Instance object)
{
    const std::string typeKey = std::string(entity) + '/' + name;
    const auto [it, isNew] = m_typeByKey.try_emplace(typeKey, m_types.size());
    if (isNew)
    {
        std::vector<Builder::Attribute> attributes = {{"GlobalId", guid("type/" + typeKey)}, {"Name", name}};
        attributes.insert(attributes.end(), more.begin(), more.end());
        m_types.push_back({typeKey, m_builder.add(entity, attributes), {}});
    }
    m_types[it->second].objects.push_back(object);
}

void Model::addMaterial()
{
    if (m_material.empty())
        return;
    const Instance material = m_builder.add(
        "IfcMaterial", {{"Name", "Not known"}, {"Description", "The scan tells surfaces, not what is behind them"}});
    m_builder.add(
        "IfcRelAssociatesMaterial",
        {{"GlobalId", guid("material/elements")}, {"RelatedObjects", m_material}, {"RelatingMaterial", material}});
}

void Model::finish()
{
    for (const Container& container : m_containers)
    {
        const std::string storeyKey = key("storey", container.storey);
        const Instance storey = m_storeys.at(container.storey).instance;
        if (!container.spaces.empty())
            aggregate(storeyKey, storey, container.spaces);
        if (!container.elements.empty())
            m_builder.add("IfcRelContainedInSpatialStructure", {{"GlobalId", guid(storeyKey + "/elements")},
                                                                {"RelatedElements", container.elements},
                                                                {"RelatingStructure", storey}});
    }
    for (const ElementType& type : m_types)
        m_builder.add("IfcRelDefinesByType", {{"GlobalId", guid("type/" + type.key + "/objects")},
                                              {"RelatedObjects", type.objects},
                                              {"RelatingType", type.instance}});
    addMaterial();
    m_properties.finish();
}

}  // namespace s2b::ifc
