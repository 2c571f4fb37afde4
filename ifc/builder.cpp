// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc/builder.h"

#include "core/base/error.h"

#include <ifcparse/IfcCharacterDecoder.h>
#include <ifcparse/IfcFile.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <locale>
#include <map>
#include <sstream>
#include <type_traits>

namespace s2b::ifc
{
namespace
{

/// A set of alternatives of Builder::Value, by their place in it.
using Kinds = std::uint32_t;

template <class T, class... All>
constexpr Kinds kindIn(const std::variant<All...>*)
{
    Kinds kind = 1U;
    (void)((std::is_same_v<T, All> || (kind <<= 1U, false)) || ...);
    return kind;
}
template <class T>
constexpr Kinds kKind = kindIn<T>(static_cast<const Builder::Value*>(nullptr));

Kinds kindOf(const Builder::Value& value)
{
    return 1U << value.index();
}

/// What a list of such items is.
Kinds listOf(Kinds items)
{
    Kinds lists = 0;
    const auto add = [&](Kinds item, Kinds list) { lists |= (items & item) != 0 ? list : 0; };
    add(kKind<Instance>, kKind<InstanceList>);
    add(kKind<TypedValue>, kKind<TypedList>);
    add(kKind<double>, kKind<std::vector<double>>);
    add(kKind<int>, kKind<std::vector<int>>);
    add(kKind<std::vector<double>>, kKind<std::vector<std::vector<double>>>);
    add(kKind<std::vector<int>>, kKind<std::vector<std::vector<int>>>);
    return lists;
}

Kinds kindsOf(IfcParse::simple_type::data_type type)
{
    switch (type)
    {
        case IfcParse::simple_type::string_type:
            return kKind<std::string>;
        case IfcParse::simple_type::real_type:
        case IfcParse::simple_type::number_type:
            return kKind<double>;
        case IfcParse::simple_type::integer_type:
            return kKind<int>;
        case IfcParse::simple_type::boolean_type:
        case IfcParse::simple_type::logical_type:
            return kKind<bool>;
        default:
            return 0;
    }
}

/// What the schema takes for a parameter of this type.
Kinds kindsOf(const IfcParse::parameter_type& type)
{
    if (const auto* simple = type.as_simple_type())
        return kindsOf(simple->declared_type());
    if (const auto* aggregation = type.as_aggregation_type())
        return listOf(kindsOf(*aggregation->type_of_element()));
    const auto* declaration = type.as_named_type()->declared_type();
    if (const auto* defined = declaration->as_type_declaration())
        return kindsOf(*defined->declared_type());
    if (declaration->as_select_type() != nullptr)
        return kKind<Instance> | kKind<TypedValue>;
    return declaration->as_enumeration_type() != nullptr ? kKind<Enumeration> : kKind<Instance>;
}

struct AttributeInfo
{
    std::string name;
    Kinds kinds = 0;
    const IfcParse::enumeration_type* enumeration = nullptr;
    bool isMandatory = false;
    bool isDerived = false;
    bool mayBeEmpty = true;
};

/// What is looked up once per entity.
struct EntityInfo
{
    std::string keyword;
    std::vector<AttributeInfo> attributes;
};

/// What is looked up once per type that is written with its values.
struct TypeInfo
{
    std::string keyword;
    Kinds kinds = 0;
};

[[noreturn]] void fail(const std::string& what)
{
    throw Error(ErrorCode::Internal, "the IFC can't be written: " + what);
}

const IfcParse::schema_definition* schemaOf(const std::string& name)
{
    // IfcOpenShell knows more schemas, but these are the ones that the output is proved for.
    if (name != "IFC4" && name != "IFC4X3_ADD2")
        throw Error(ErrorCode::BadParameter, "unknown IFC schema \"" + name + "\"; use IFC4 or IFC4X3_ADD2");
    return IfcParse::schema_by_name(name);
}

AttributeInfo infoOf(const IfcParse::attribute& attribute, bool isDerived)
{
    const IfcParse::parameter_type& type = *attribute.type_of_attribute();
    AttributeInfo info;
    info.name = attribute.name();
    info.kinds = kindsOf(type);
    info.isDerived = isDerived;
    info.isMandatory = !attribute.optional() && !isDerived;
    if (const auto* named = type.as_named_type())
        info.enumeration = named->declared_type()->as_enumeration_type();
    if (const auto* aggregation = type.as_aggregation_type())
        info.mayBeEmpty = aggregation->bound1() < 1;
    return info;
}

bool isUnset(const Builder::Value& value)
{
    const auto* instance = std::get_if<Instance>(&value);
    return std::holds_alternative<std::monostate>(value) || (instance != nullptr && !*instance);
}

template <class T>
constexpr bool kIsList = false;
template <class Item>
constexpr bool kIsList<std::vector<Item>> = true;

bool isEmptyList(const Builder::Value& value)
{
    return std::visit(
        [](const auto& x)
        {
            if constexpr (kIsList<std::decay_t<decltype(x)>>)
                return x.empty();
            else
                return false;
        },
        value);
}

}  // namespace

struct Builder::Implementation
{
    explicit Implementation(const std::string& name) : schema(schemaOf(name)) {}

    [[nodiscard]] const IfcParse::declaration* declared(std::string_view name) const
    {
        try
        {
            return schema->declaration_by_name(std::string(name));
        }
        catch (const IfcParse::IfcException&)
        {
            fail(schema->name() + " has no " + std::string(name));
        }
    }

    const EntityInfo& entity(std::string_view name)
    {
        if (const auto it = entities.find(name); it != entities.end())
            return it->second;
        const auto* declaration = declared(name)->as_entity();
        if (declaration == nullptr || declaration->is_abstract())
            fail(std::string(name) + " is no entity that can be made");
        EntityInfo info;
        info.keyword = declaration->name_uc();
        const auto all = declaration->all_attributes();
        for (std::size_t i = 0; i < all.size(); ++i)
            info.attributes.push_back(infoOf(*all[i], declaration->derived()[i]));
        return entities.emplace(std::string(name), std::move(info)).first->second;
    }

    const TypeInfo& type(std::string_view name)
    {
        if (const auto it = types.find(name); it != types.end())
            return it->second;
        const auto* declaration = declared(name)->as_type_declaration();
        if (declaration == nullptr)
            fail(std::string(name) + " is no type of values");
        return types
            .emplace(std::string(name), TypeInfo{declaration->name_uc(), kindsOf(*declaration->declared_type())})
            .first->second;
    }

    // Values as ISO 10303-21 wants them.
    void print(int value)
    {
        char buffer[16];
        data.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
    }
    void print(bool value) { data += value ? ".T." : ".F."; }
    void print(double value)
    {
        if (!std::isfinite(value))
            fail("a number is not finite");
        char buffer[32];
        const auto* end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 15).ptr;
        const std::string_view text(buffer, static_cast<std::size_t>(end - buffer));
        const std::size_t exponent = text.find('e');
        const std::string_view mantissa = text.substr(0, exponent);
        data += mantissa;
        if (mantissa.find('.') == std::string_view::npos)
            data += '.';
        if (exponent != std::string_view::npos)
            data.append("E").append(text.substr(exponent + 1));
    }
    void print(const std::string& value)
    {
        const auto isPlain = [](char c) { return c >= ' ' && c <= '~' && c != '\'' && c != '\\'; };
        if (std::all_of(value.begin(), value.end(), isPlain))
            data.append("'").append(value).append("'");
        else
            data += std::string(IfcParse::IfcCharacterEncoder(value));
    }
    void print(Enumeration value) { data.append(".").append(value.item).append("."); }
    void print(Instance value)
    {
        char buffer[16];
        data += '#';
        data.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value.number).ptr);
    }
    void print(const TypedValue& value)
    {
        const TypeInfo& info = type(value.type);
        data.append(info.keyword).append("(");
        std::visit(
            [&](const auto& x)
            {
                if ((info.kinds & kKind<std::decay_t<decltype(x)>>) == 0)
                    fail(std::string(value.type) + " takes no value of this kind");
                print(x);
            },
            value.value);
        data += ')';
    }
    template <class Item>
    void print(const std::vector<Item>& list)
    {
        data += '(';
        for (std::size_t i = 0; i < list.size(); ++i)
        {
            if (i > 0)
                data += ',';
            print(list[i]);
        }
        data += ')';
    }

    void print(const AttributeInfo& attribute, const Value& value, const std::string& of)
    {
        if ((attribute.kinds & kindOf(value)) == 0)
            fail(of + "'s " + attribute.name + " takes no value of this kind");
        if (!attribute.mayBeEmpty && isEmptyList(value))
            fail(of + "'s " + attribute.name + " is an empty list");
        if (const auto* chosen = std::get_if<Enumeration>(&value))
        {
            const auto& items = attribute.enumeration->enumeration_items();
            if (std::find(items.begin(), items.end(), chosen->item) == items.end())
                fail(of + "'s " + attribute.name + " has no item " + std::string(chosen->item));
        }
        std::visit(
            [&](const auto& x)
            {
                if constexpr (!std::is_same_v<std::decay_t<decltype(x)>, std::monostate>)
                    print(x);
            },
            value);
    }

    const IfcParse::schema_definition* schema;
    std::map<std::string, EntityInfo, std::less<>> entities;
    std::map<std::string, TypeInfo, std::less<>> types;
    std::string data;  ///< the instances' lines
    std::uint32_t count = 0;
    std::vector<const Value*> values;  ///< of the instance being written, in the schema's order
};

Builder::Builder(const std::string& schema) : m_impl(std::make_unique<Implementation>(schema)) {}

Builder::~Builder() = default;

Instance Builder::add(std::string_view entity, std::span<const Attribute> attributes)
{
    Implementation& m = *m_impl;
    const EntityInfo& info = m.entity(entity);
    m.values.assign(info.attributes.size(), nullptr);
    for (const Attribute& attribute : attributes)
    {
        const auto it = std::find_if(info.attributes.begin(), info.attributes.end(),
                                     [&](const AttributeInfo& a) { return a.name == attribute.name; });
        if (it == info.attributes.end())
            fail(info.keyword + " has no attribute " + attribute.name);
        m.values[static_cast<std::size_t>(it - info.attributes.begin())] = &attribute.value;
    }

    const Instance instance{++m.count};
    m.print(instance);
    m.data.append("=").append(info.keyword).append("(");
    for (std::size_t i = 0; i < info.attributes.size(); ++i)
    {
        const AttributeInfo& attribute = info.attributes[i];
        if (i > 0)
            m.data += ',';
        if (m.values[i] != nullptr && !isUnset(*m.values[i]))
            m.print(attribute, *m.values[i], info.keyword);
        else if (attribute.isMandatory)
            fail(info.keyword + " lacks its " + attribute.name);
        else
            m.data += attribute.isDerived ? '*' : '$';
    }
    m.data += ");\n";
    return instance;
}

std::string Builder::text(const Header& header) const
{
    IfcParse::IfcFile file(m_impl->schema);  // for its header
    auto& spf = file.header();
    spf.file_description().description({"ViewDefinition [DesignTransferView_V1.0]"});
    spf.file_name().name(header.name);
    spf.file_name().time_stamp(header.timestamp);
    spf.file_name().author({"Not known"});
    spf.file_name().organization({"Not known"});
    spf.file_name().originating_system(header.originatingSystem);
    spf.file_name().authorization("None");
    std::ostringstream out;
    out.imbue(std::locale::classic());
    spf.write(out);
    return std::move(out).str() + m_impl->data + "ENDSEC;\nEND-ISO-10303-21;\n";
}

}  // namespace s2b::ifc
