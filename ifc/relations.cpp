// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc/relations.h"

#include <ifcparse/IfcFile.h>
#include <ifcparse/IfcSIPrefix.h>

#include <Eigen/Geometry>

#include <cmath>

namespace s2b::ifc
{
namespace
{

using Instance = const IfcUtil::IfcBaseClass*;

/// Null where the attribute is unset or doesn't exist.
std::optional<AttributeValue> attribute(Instance instance, const char* name)
{
    const IfcParse::entity* entity = instance == nullptr ? nullptr : instance->declaration().as_entity();
    if (entity == nullptr)
        return std::nullopt;
    const auto index = entity->attribute_index(name);
    if (index < 0)
        return std::nullopt;
    const AttributeValue value = instance->data().get_attribute_value(static_cast<std::size_t>(index));
    if (value.isNull())
        return std::nullopt;
    return value;
}

aggregate_of_instance::ptr instances(IfcParse::IfcFile& file, const char* entity)
{
    try
    {
        return file.instances_by_type(entity);
    }
    catch (const IfcParse::IfcException&)  // the schema has no such entity
    {
        return nullptr;
    }
}

/// Metres per unit of an IfcSIUnit or IfcConversionBasedUnit; 1 for anything else.
double metresPer(Instance unit)
{
    if (unit == nullptr)
        return 1.0;
    if (unit->declaration().is("IfcSIUnit"))
    {
        const std::string prefix = attributeText(unit, "Prefix");
        return prefix.empty() ? 1.0 : IfcParse::IfcSIPrefixToValue(prefix);
    }
    const Instance factor = attributeInstance(unit, "ConversionFactor");
    const Instance value = attributeInstance(factor, "ValueComponent");
    if (value == nullptr)
        return 1.0;
    const AttributeValue number = value->data().get_attribute_value(0);
    return number.type() == IfcUtil::Argument_DOUBLE ? static_cast<double>(number) : 1.0;
}

}  // namespace

std::string attributeText(Instance instance, const char* name)
{
    const auto value = attribute(instance, name);
    if (!value || (value->type() != IfcUtil::Argument_STRING && value->type() != IfcUtil::Argument_ENUMERATION))
        return {};
    return static_cast<std::string>(*value);
}

std::optional<double> attributeNumber(Instance instance, const char* name)
{
    const auto value = attribute(instance, name);
    if (!value)
        return std::nullopt;
    if (value->type() == IfcUtil::Argument_DOUBLE)
        return static_cast<double>(*value);
    if (value->type() == IfcUtil::Argument_INT)
        return static_cast<int>(*value);
    return std::nullopt;
}

Instance attributeInstance(Instance instance, const char* name)
{
    const auto value = attribute(instance, name);
    if (!value || value->type() != IfcUtil::Argument_ENTITY_INSTANCE)
        return nullptr;
    return static_cast<IfcUtil::IfcBaseClass*>(*value);
}

Relations::Relations(IfcParse::IfcFile& file)
{
    collect(file, "IfcRelContainedInSpatialStructure", "RelatingStructure", "RelatedElements", m_containers);
    collect(file, "IfcRelAggregates", "RelatingObject", "RelatedObjects", m_wholes);
    collect(file, "IfcRelNests", "RelatingObject", "RelatedObjects", m_wholes);
    collect(file, "IfcRelFillsElement", "RelatingOpeningElement", "RelatedBuildingElement", m_openings);
    collect(file, "IfcRelVoidsElement", "RelatingBuildingElement", "RelatedOpeningElement", m_voided);
}

void Relations::collect(IfcParse::IfcFile& file, const char* entity, const char* parent, const char* children,
                        Parents& parents)
{
    const auto relations = instances(file, entity);
    if (!relations)
        return;
    for (const Instance relation : *relations)
    {
        const Instance one = attributeInstance(relation, parent);
        const auto many = attribute(relation, children);
        if (one == nullptr || !many)
            continue;
        if (many->type() == IfcUtil::Argument_ENTITY_INSTANCE)
            parents.emplace(static_cast<IfcUtil::IfcBaseClass*>(*many)->id(), one);
        else if (many->type() == IfcUtil::Argument_AGGREGATE_OF_ENTITY_INSTANCE)
            for (const Instance child : *static_cast<aggregate_of_instance::ptr>(*many))
                parents.emplace(child->id(), one);
    }
}

Instance Relations::find(const Parents& parents, Instance child)
{
    const auto it = parents.find(child->id());
    return it == parents.end() ? nullptr : it->second;
}

Instance Relations::storeyOf(Instance element) const
{
    // A damaged file may go in circles.
    for (int depth = 0; element != nullptr && depth < 32; ++depth)
    {
        if (element->declaration().is("IfcBuildingStorey"))
            return element;
        Instance next = nullptr;
        for (const Parents* parents : {&m_containers, &m_wholes, &m_openings, &m_voided})
            if (next == nullptr)
                next = find(*parents, element);
        element = next;
    }
    return nullptr;
}

Instance Relations::hostOf(Instance element) const
{
    if (const Instance opening = openingOf(element))
        return find(m_voided, opening);
    if (element->declaration().is("IfcOpeningElement"))
        return find(m_voided, element);
    if (!element->declaration().is("IfcDoor") && !element->declaration().is("IfcWindow"))
        return nullptr;
    const Instance whole = find(m_wholes, element);
    if (whole == nullptr || (!whole->declaration().is("IfcWall") && !whole->declaration().is("IfcCurtainWall")))
        return nullptr;
    return whole;
}

Instance Relations::wholeOf(Instance element) const
{
    const Instance whole = find(m_wholes, element);
    return whole != nullptr && whole->declaration().is("IfcElement") ? whole : nullptr;
}

Instance Relations::openingOf(Instance element) const
{
    return find(m_openings, element);
}

std::optional<MapConversion> mapConversionOf(IfcParse::IfcFile& file, double lengthUnit_m)
{
    const auto all = instances(file, "IfcMapConversion");
    if (!all || all->size() == 0)
        return std::nullopt;
    const Instance conversion = *all->begin();
    const Instance crs = attributeInstance(conversion, "TargetCRS");
    const Instance unit = attributeInstance(crs, "MapUnit");
    const double mapUnit_m = unit != nullptr ? metresPer(unit) : lengthUnit_m;
    const auto number = [&](const char* name, double otherwise)
    { return attributeNumber(conversion, name).value_or(otherwise); };

    MapConversion result;
    result.crs = attributeText(crs, "Name");
    result.origin =
        mapUnit_m * Eigen::Vector3d(number("Eastings", 0.0), number("Northings", 0.0), number("OrthogonalHeight", 0.0));
    result.yaw_rad = std::atan2(number("XAxisOrdinate", 0.0), number("XAxisAbscissa", 1.0));
    // The scale also converts the project's unit to the map's, and many writers leave that out.
    const double scale = number("Scale", 1.0) * mapUnit_m / lengthUnit_m;
    result.scale = scale > 0.5 && scale < 2.0 ? scale : 1.0;
    return result;
}

Eigen::Vector3d MapConversion::toMap(const Eigen::Vector3d& p) const
{
    return origin + scale * (Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) * p);
}

}  // namespace s2b::ifc
