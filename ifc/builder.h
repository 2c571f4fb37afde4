// SPDX-License-Identifier: GPL-3.0-or-later
/// A thin, late-bound way to write IFC instances: entity and attribute names are text that is looked up in
/// IfcOpenShell's schema chosen at run time, so that one code path writes every schema version.
///
/// An instance becomes its line of the file (ISO 10303-21) at once: IfcOpenShell's instances, which can be read again
/// and changed, take three times as long and hold several times the memory.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace s2b::ifc
{

/// An instance of the file that is being written, by its number; 0: none.
struct Instance
{
    std::uint32_t number = 0;
    explicit operator bool() const { return number != 0; }
};
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
    /// No Instance or an empty variant leaves an optional attribute unset.
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

    /// Writes an instance. The kinds of the values are checked against the schema, and that none is missing.
    /// @throws Error{Internal} for an unknown entity, attribute or item of an enumeration, a value of another kind than
    ///         the attribute's, a missing one, NaN, an empty list where one item is the least. The builder is of no use
    ///         then.
    /// Cost: about 0.5 us.
    Instance add(std::string_view entity, std::span<const Attribute> attributes);
    Instance add(std::string_view entity, std::initializer_list<Attribute> attributes)
    {
        return add(entity, std::span<const Attribute>(attributes.begin(), attributes.size()));
    }

    /// The whole file.
    [[nodiscard]] std::string text(const Header& header) const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> m_impl;
};

}  // namespace s2b::ifc
