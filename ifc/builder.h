// SPDX-License-Identifier: GPL-3.0-or-later
/// A thin, late-bound way to make IFC instances: entity and attribute names are text that is looked up in the schema
/// chosen at run time, so that one code path writes every schema version.
#pragma once

#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace IfcUtil
{
class IfcBaseClass;
}

namespace s2b::ifc
{

using Instance = IfcUtil::IfcBaseClass*;  ///< owned by the Builder that made it
using InstanceList = std::vector<Instance>;

/// An item of an EXPRESS enumeration, without the dots.
struct Enumeration
{
    std::string_view item;
};

/// A value whose type is written with it, as a SELECT wants: IFCLABEL('x').
struct TypedValue
{
    std::string_view type;
    std::variant<std::string, double, int, bool, std::vector<int>> value;
};
using TypedList = std::vector<TypedValue>;

/// File header (ISO 10303-21). What we don't know is said to be unknown.
struct Header
{
    std::string name;
    std::string timestamp;
    std::string originatingSystem;
};

class Builder
{
public:
    /// A null Instance or an empty variant leaves an optional attribute unset.
    using Value = std::variant<std::monostate, Instance, InstanceList, std::string, double, int, bool, Enumeration,
                               TypedValue, TypedList, std::vector<double>, std::vector<int>,
                               std::vector<std::vector<double>>, std::vector<std::vector<int>>>;
    struct Attribute
    {
        const char* name;
        Value value;
    };

    /// @throws Error{BadParameter} for a schema that is not known.
    explicit Builder(const std::string& schema);
    ~Builder();
    Builder(const Builder&) = delete;
    Builder& operator=(const Builder&) = delete;

    /// Makes an instance. Mandatory attributes and the kinds of values are checked, which IfcOpenShell doesn't do.
    /// @throws Error{Internal} for an unknown entity or attribute, a missing one, NaN, an empty list where one item is
    ///         the least.
    /// Cost: about 2 us.
    Instance add(std::string_view entity, std::span<const Attribute> attributes);
    Instance add(std::string_view entity, std::initializer_list<Attribute> attributes)
    {
        return add(entity, std::span<const Attribute>(attributes.begin(), attributes.size()));
    }

    /// The whole file. Cost: about 1 us per instance.
    [[nodiscard]] std::string text(const Header& header) const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> m_impl;
};

}  // namespace s2b::ifc
