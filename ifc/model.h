// SPDX-License-Identifier: GPL-3.0-or-later
/// The IFC model while it is being written: what the elements of a building need of one another.
#pragma once

#include "core/model/building.h"
#include "ifc/builder.h"
#include "ifc/ifc_writer.h"
#include "ifc/properties.h"
#include "ifc/shapes.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace s2b::ifc
{

class Model
{
public:
    /// Writes project, site, building and storeys.
    Model(const Building& building, const WriteOptions& options);

    // Elements, in this order.
    void addWalls();
    void addOpenings();
    void addColumns();
    void addSlabs();
    void addSpaces();
    void addJunctions();
    /// Writes what relates elements: containment, types, materials, shared property sets. To be called last.
    void finish();

    [[nodiscard]] std::string text() const;

private:
    struct Placed
    {
        Instance instance;
        Instance placement;
    };
    struct ElementType
    {
        std::string key;
        Instance instance;
        InstanceList objects;
    };
    struct Container
    {
        ElementId storey;
        InstanceList elements;
        InstanceList spaces;
    };
    /// A length of an element that its evidence tells about.
    struct Named
    {
        const char* name;
        const Dimension& dimension;
    };

    [[nodiscard]] std::string guid(std::string_view role) const;
    [[nodiscard]] static std::string key(const char* kind, ElementId id);
    /// The name that a person gave, or "Wall 12".
    [[nodiscard]] std::string nameOf(const char* kind, ElementId id) const;
    [[nodiscard]] Instance units();
    [[nodiscard]] Instance storeyPlacement(ElementId storey, const Eigen::Vector3d& buildingPoint,
                                           const Eigen::Vector2d& x);
    void addSite(Instance project);
    void addMapConversion(int epsg);
    void aggregate(const std::string& parentKey, Instance parent, const InstanceList& children);
    void contain(ElementId storey, Instance element);
    void assignType(const std::string& name, const char* entity, const std::vector<Builder::Attribute>& more,
                    Instance object);
    void addMaterial();

    /// S2B_Evidence of an element. `evidence` may be null (storeys, spaces).
    void addEvidence(Instance object, const std::string& key, ElementId id, const Evidence* evidence,
                     const std::vector<Named>& dimensions, std::vector<Property> more = {});
    void addWall(const Wall& wall);
    Instance wallBody(const Wall& wall, Shapes::Representation& representation);
    void addOpening(const Opening& opening);
    Placed addVoid(const Opening& opening, const Wall& host);
    void addDoor(const Opening& opening, const Wall& host, const Placed& hole);
    void addWindow(const Opening& opening, const Wall& host, const Placed& hole);

    const Building& m_building;
    const WriteOptions& m_options;
    Builder m_builder;
    Shapes m_shapes;
    Properties m_properties;
    Instance m_metre;
    Instance m_buildingPlacement;
    std::map<ElementId, Placed> m_storeys;
    std::map<ElementId, Placed> m_walls;
    std::map<ElementId, const Wall*> m_wallById;
    std::map<ElementId, double> m_elevations;
    std::map<ElementId, std::vector<const Opening*>> m_openingsOf;
    std::map<ElementId, std::string> m_remarks;
    std::vector<Container> m_containers;
    std::vector<ElementType> m_types;
    std::map<std::string, std::size_t, std::less<>> m_typeByKey;
    InstanceList m_material;  // elements and types that get the generic material
};

}  // namespace s2b::ifc
