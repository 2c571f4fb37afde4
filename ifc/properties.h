// SPDX-License-Identifier: GPL-3.0-or-later
/// Property sets and quantities, shared between the elements that have the same ones.
#pragma once

#include "core/model/building.h"
#include "ifc/builder.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace s2b::ifc
{

struct Property
{
    std::string name;
    TypedValue value;
    bool isEnumerated = false;  ///< an IfcPropertyEnumeratedValue, where the standard's template says so
};

enum class QuantityKind
{
    Length,
    Area,
    Volume
};
struct Quantity
{
    const char* name;
    QuantityKind kind;
    double value;
};

/// "LOA30" ..., "beyond LOA10": the validation's band, at its default limits, of twice the RMS distance (95 %).
[[nodiscard]] const char* accuracyBand(double rms_m);

/// "Measured", "Assumed", "Corrected".
[[nodiscard]] const char* provenanceName(Provenance provenance);

class Properties
{
public:
    Properties(Builder& builder, std::string nameSpace) : m_builder(builder), m_nameSpace(std::move(nameSpace)) {}

    /// Gives `object` a property set; objects with equal sets share one. Nothing when there is no property.
    void addShared(Instance object, const char* name, const std::vector<Property>& properties);

    /// Gives `object`, whose name in the GUIDs is `key`, a property set of its own.
    void add(Instance object, const std::string& key, const char* name, const std::vector<Property>& properties);

    /// Gives `object`, whose name in the GUIDs is `key`, its quantities.
    void addQuantities(Instance object, const std::string& key, const char* name,
                       const std::vector<Quantity>& quantities);

    /// Writes the relations. To be called once, at the end.
    void finish();

private:
    struct Set
    {
        std::string content;
        const char* name = nullptr;
        InstanceList properties;
        InstanceList objects;
    };
    Instance single(const Property& property, const std::string& content);
    void define(const std::string& key, const char* name, const char* entity, const char* listName,
                const InstanceList& items, const InstanceList& objects);

    Builder& m_builder;
    std::string m_nameSpace;
    std::vector<Set> m_sets;
    std::map<std::string, std::size_t, std::less<>> m_setByContent;
    std::map<std::string, Instance, std::less<>> m_singleByContent;
};

}  // namespace s2b::ifc
