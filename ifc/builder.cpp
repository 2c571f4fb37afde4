// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc/builder.h"

#include "core/base/error.h"

#include <ifcparse/IfcFile.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <map>
#include <sstream>
#include <type_traits>

namespace s2b::ifc
{
namespace
{

/// What is looked up once per entity.
struct EntityInfo
{
    const IfcParse::entity* entity = nullptr;
    std::map<std::string, std::size_t, std::less<>> index;
    std::vector<std::size_t> mandatory;
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

/// The enumeration behind a named type.
const IfcParse::enumeration_type* enumerationOf(const IfcParse::entity* entity, std::size_t index)
{
    const auto* named = entity->attribute_by_index(index)->type_of_attribute()->as_named_type();
    return named == nullptr ? nullptr : named->declared_type()->as_enumeration_type();
}

void checkFinite(double value, const std::string& where)
{
    if (!std::isfinite(value))
        fail(where + " is not a finite number");
}

}  // namespace

struct Builder::Implementation
{
    explicit Implementation(const std::string& name) : schema(schemaOf(name)) {}

    /// IfcFile::addEntity would also record who refers to whom, which a file that is only written doesn't need and
    /// which takes most of the time.
    Instance keep(Instance instance)
    {
        instances.emplace_back(instance);
        return instance;
    }

    const EntityInfo& info(std::string_view name)
    {
        if (const auto it = entities.find(name); it != entities.end())
            return it->second;
        EntityInfo result;
        result.entity = schema->declaration_by_name(std::string(name))->as_entity();
        if (result.entity == nullptr || result.entity->is_abstract())
            fail(std::string(name) + " is no entity that can be made");
        const auto all = result.entity->all_attributes();
        const auto& derived = result.entity->derived();
        for (std::size_t i = 0; i < all.size(); ++i)
        {
            result.index.emplace(all[i]->name(), i);
            if (!all[i]->optional() && !derived[i])
                result.mandatory.push_back(i);
        }
        return entities.emplace(std::string(name), std::move(result)).first->second;
    }

    Instance typed(const TypedValue& value)
    {
        const auto* declaration = schema->declaration_by_name(std::string(value.type));
        Instance instance = keep(schema->instantiate(declaration, IfcEntityInstanceData(storage_t(1))));
        std::visit(
            [&](const auto& x)
            {
                if constexpr (std::is_same_v<std::decay_t<decltype(x)>, double>)
                    checkFinite(x, std::string(value.type));
                instance->set_attribute_value(0, x);
            },
            value.value);
        return instance;
    }

    void set(Instance instance, const EntityInfo& info, std::size_t index, const std::string& where,
             const Builder::Value& value)
    {
        std::visit(
            [&](const auto& x)
            {
                using T = std::decay_t<decltype(x)>;
                if constexpr (std::is_same_v<T, Instance>)
                {
                    if (x != nullptr)
                        instance->set_attribute_value<Instance>(index, x);
                }
                else if constexpr (std::is_same_v<T, InstanceList> || std::is_same_v<T, TypedList>)
                {
                    if (x.empty())
                        fail(where + " is an empty list");
                    aggregate_of_instance::ptr list(new aggregate_of_instance);
                    for (const auto& item : x)
                        if constexpr (std::is_same_v<T, TypedList>)
                            list->push(typed(item));
                        else
                            list->push(item);
                    instance->set_attribute_value(index, list);
                }
                else if constexpr (std::is_same_v<T, Enumeration>)
                {
                    const auto* enumeration = enumerationOf(info.entity, index);
                    if (enumeration == nullptr)
                        fail(where + " takes no enumeration");
                    const auto item = enumeration->lookup_enum_offset(std::string(x.item));
                    instance->set_attribute_value(index, EnumerationReference(enumeration, item));
                }
                else if constexpr (std::is_same_v<T, TypedValue>)
                    instance->set_attribute_value<Instance>(index, typed(x));
                else if constexpr (!std::is_same_v<T, std::monostate>)
                {
                    if constexpr (std::is_same_v<T, double>)
                        checkFinite(x, where);
                    if constexpr (std::is_same_v<T, std::vector<double>>)
                        for (const double d : x)
                            checkFinite(d, where);
                    if constexpr (std::is_same_v<T, std::vector<std::vector<double>>>)
                        for (const auto& row : x)
                            for (const double d : row)
                                checkFinite(d, where);
                    instance->set_attribute_value(index, x);
                }
            },
            value);
    }

    const IfcParse::schema_definition* schema;
    std::vector<std::unique_ptr<IfcUtil::IfcBaseClass>> instances;  // entities, and typed values, which have id 0
    std::uint32_t entityCount = 0;
    std::map<std::string, EntityInfo, std::less<>> entities;
};

Builder::Builder(const std::string& schema) : m_impl(std::make_unique<Implementation>(schema)) {}

Builder::~Builder() = default;

Instance Builder::add(std::string_view entity, std::span<const Attribute> attributes)
{
    const EntityInfo& info = m_impl->info(entity);
    Instance instance = m_impl->keep(
        m_impl->schema->instantiate(info.entity, IfcEntityInstanceData(storage_t(info.entity->attribute_count()))));
    static_cast<IfcUtil::IfcBaseEntity*>(instance)->populate_derived();
    for (const Attribute& attribute : attributes)
    {
        const auto it = info.index.find(std::string_view(attribute.name));
        if (it == info.index.end())
            fail(std::string(entity) + " has no attribute " + attribute.name);
        m_impl->set(instance, info, it->second, it->first, attribute.value);
    }
    for (const std::size_t index : info.mandatory)
        if (instance->data().get_attribute_value(index).isNull())
            fail(std::string(entity) + " lacks its " + info.entity->attribute_by_index(index)->name());
    instance->id_ = ++m_impl->entityCount;
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
    for (const auto& instance : m_impl->instances)
        if (instance->id() != 0)
        {
            instance->toString(out, true);
            out << ";\n";
        }
    out << "ENDSEC;\nEND-ISO-10303-21;\n";
    return std::move(out).str();
}

}  // namespace s2b::ifc
