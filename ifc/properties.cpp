// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc/properties.h"

#include "core/validation/loa.h"
#include "ifc/guid.h"

#include <charconv>

namespace s2b::ifc
{
namespace
{

/// Exact text of a value, to compare by.
std::string textOf(const TypedValue& value)
{
    std::string text(value.type);
    text += '(';
    std::visit(
        [&](const auto& x)
        {
            using T = std::decay_t<decltype(x)>;
            if constexpr (std::is_same_v<T, std::string>)
                text += x;
            else if constexpr (std::is_same_v<T, bool>)
                text += x ? 'T' : 'F';
            else if constexpr (!std::is_same_v<T, std::vector<int>>)
            {
                char buffer[32];
                const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
                text.append(buffer, end);
            }
        },
        value.value);
    text += ')';
    return text;
}

}  // namespace

const char* accuracyBand(double rms_m)
{
    return validation::loaName(validation::bandOf(2.0 * rms_m, validation::ValidationParams()));
}

const char* provenanceName(Provenance provenance)
{
    switch (provenance)
    {
        case Provenance::Measured:
            return "Measured";
        case Provenance::Corrected:
            return "Corrected";
        case Provenance::Assumed:
            break;
    }
    return "Assumed";
}

Instance Properties::single(const Property& property, const std::string& content)
{
    Instance& instance = m_singleByContent[content];
    if (!instance)
        instance =
            property.isEnumerated
                ? m_builder.add("IfcPropertyEnumeratedValue",
                                {{"Name", property.name}, {"EnumerationValues", TypedList{property.value}}})
                : m_builder.add("IfcPropertySingleValue", {{"Name", property.name}, {"NominalValue", property.value}});
    return instance;
}

void Properties::define(const std::string& key, const char* name, const char* entity, const char* listName,
                        const InstanceList& items, const InstanceList& objects)
{
    const Instance set = m_builder.add(
        entity, {{"GlobalId", globalId(m_nameSpace, key + '/' + name)}, {"Name", name}, {listName, items}});
    m_builder.add("IfcRelDefinesByProperties", {{"GlobalId", globalId(m_nameSpace, key + "/has/" + name)},
                                                {"RelatedObjects", objects},
                                                {"RelatingPropertyDefinition", set}});
}

void Properties::add(Instance object, const std::string& key, const char* name, const std::vector<Property>& properties)
{
    InstanceList list;
    for (const Property& property : properties)
        list.push_back(single(property, property.name + '=' + textOf(property.value)));
    if (!list.empty())
        define(key, name, "IfcPropertySet", "HasProperties", list, {object});
}

void Properties::addShared(Instance object, const char* name, const std::vector<Property>& properties)
{
    if (properties.empty())
        return;
    std::string content = name;
    std::vector<std::string> texts;
    for (const Property& property : properties)
    {
        texts.push_back(property.name + '=' + textOf(property.value));
        content += '\n' + texts.back();
    }
    const auto [it, isNew] = m_setByContent.try_emplace(content, m_sets.size());
    if (isNew)
    {
        Set set;
        set.content = std::move(content);
        set.name = name;
        for (std::size_t i = 0; i < properties.size(); ++i)
            set.properties.push_back(single(properties[i], texts[i]));
        m_sets.push_back(std::move(set));
    }
    m_sets[it->second].objects.push_back(object);
}

void Properties::addQuantities(Instance object, const std::string& key, const char* name,
                               const std::vector<Quantity>& quantities)
{
    InstanceList list;
    for (const Quantity& q : quantities)
        switch (q.kind)
        {
            case QuantityKind::Length:
                list.push_back(m_builder.add("IfcQuantityLength", {{"Name", q.name}, {"LengthValue", q.value}}));
                break;
            case QuantityKind::Area:
                list.push_back(m_builder.add("IfcQuantityArea", {{"Name", q.name}, {"AreaValue", q.value}}));
                break;
            case QuantityKind::Volume:
                list.push_back(m_builder.add("IfcQuantityVolume", {{"Name", q.name}, {"VolumeValue", q.value}}));
                break;
        }
    define(key, name, "IfcElementQuantity", "Quantities", list, {object});
}

void Properties::finish()
{
    for (const Set& set : m_sets)
        define("shared/" + set.content, set.name, "IfcPropertySet", "HasProperties", set.properties, set.objects);
    m_sets.clear();
    m_setByContent.clear();
}

}  // namespace s2b::ifc
