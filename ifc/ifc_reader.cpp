// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc/ifc_reader.h"

#include "core/base/error.h"
#include "ifc/relations.h"

#include <ifcgeom/Iterator.h>
#include <ifcparse/IfcFile.h>
#include <ifcparse/IfcLogger.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <system_error>

namespace s2b::ifc
{
namespace
{

namespace settings = ifcopenshell::geometry::settings;
using ifcopenshell::geometry::Settings;
namespace taxonomy = ifcopenshell::geometry::taxonomy;

constexpr double kGlass = 0.05;  // the least transparency of a style that lets light through

[[noreturn]] void fail(const std::string& path, const std::string& reason)
{
    throw Error(ErrorCode::BadFile, "can't read " + path + ": " + reason);
}

/// What IfcOpenShell would read half-way, or crash on, is refused from the file's first and last bytes.
void checkEnds(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    std::string head(256, '\0');
    if (!in || !in.read(head.data(), 1))
        fail(path, "the file does not exist, is empty or may not be read");
    in.clear();
    in.seekg(0);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    if (head.find("ISO-10303-21") == std::string::npos)
        fail(path, "it is not an IFC file in STEP format (.ifc)");
    in.clear();
    in.seekg(0, std::ios::end);
    const auto size = static_cast<std::streamoff>(in.tellg());
    std::string tail(static_cast<std::size_t>(std::min<std::streamoff>(size, 1024)), '\0');
    in.seekg(size - static_cast<std::streamoff>(tail.size()));
    in.read(tail.data(), static_cast<std::streamsize>(tail.size()));
    if (tail.find("END-ISO-10303-21") == std::string::npos)
        fail(path, "the file is truncated: its end is missing; get a complete copy");
}

/// Catches IfcOpenShell's log, which otherwise goes to the console.
class Quiet
{
public:
    Quiet() { Logger::SetOutput(static_cast<std::ostream*>(nullptr), &m_log); }
    ~Quiet() { Logger::SetOutput(static_cast<std::ostream*>(nullptr), static_cast<std::ostream*>(nullptr)); }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;
    [[nodiscard]] std::string text() const { return m_log.str(); }

private:
    std::ostringstream m_log;
};

/// Whether shapes and places rest on what this instance refers to.
bool isBearing(const IfcUtil::IfcBaseClass& instance, std::size_t attribute)
{
    const IfcParse::declaration& kind = instance.declaration();
    if (kind.is("IfcStyledItem") || kind.as_entity()->attribute_by_index(attribute)->name() == "OwnerHistory")
        return false;
    const char* const kBearing[] = {"IfcProject",
                                    "IfcUnitAssignment",
                                    "IfcProduct",
                                    "IfcObjectPlacement",
                                    "IfcProductRepresentation",
                                    "IfcRepresentation",
                                    "IfcRepresentationItem",
                                    "IfcProfileDef",
                                    "IfcRelVoidsElement",
                                    "IfcRelAggregates",
                                    "IfcRelContainedInSpatialStructure"};
    return std::any_of(std::begin(kBearing), std::end(kBearing), [&](const char* name) { return kind.is(name); });
}

/// A file that was cut and closed again reads without an error, but its elements are not where and what they were.
/// @param log  IfcOpenShell's, which tells of instances that are referred to and not there.
void checkReferences(IfcParse::IfcFile& file, const std::string& log, const std::string& path)
{
    static const std::regex kMissing(
        "Instance reference #(\\d+) used by instance #(\\d+) at attribute index (\\d+) not");
    for (std::sregex_iterator at(log.begin(), log.end(), kMissing), end; at != end; ++at)
    {
        const IfcUtil::IfcBaseClass* user = file.instance_by_id(std::stoi((*at)[2]));
        if (user != nullptr && user->declaration().as_entity() != nullptr && isBearing(*user, std::stoul((*at)[3])))
            fail(path, "it is damaged: #" + (*at)[1].str() + ", which its #" + (*at)[2].str() + " (" +
                           user->declaration().name() + ") refers to, is missing; get a complete copy");
    }
}

Settings settingsOf(const ReadOptions& options)
{
    Settings result;
    result.get<settings::WeldVertices>().value = true;
    result.get<settings::DontEmitNormals>().value = true;
    result.get<settings::DisableOpeningSubtractions>().value = !options.subtractOpenings;
    return result;
}

/// Mesh of an element in metres, its vertices taken to the world.
void takeMesh(const IfcGeom::TriangulationElement& source, const std::optional<MapConversion>& toMap,
              MeshElement& element)
{
    const auto& mesh = source.geometry();
    const Eigen::Matrix4d transform = source.transformation().data()->ccomponents();
    const auto& coordinates = mesh.verts();
    element.vertices.reserve(coordinates.size() / 3);
    for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
    {
        const Eigen::Vector3d local(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
        const Eigen::Vector3d world = transform.topLeftCorner<3, 3>() * local + transform.topRightCorner<3, 1>();
        element.vertices.push_back(toMap ? toMap->toMap(world) : world);
    }
    const auto& materials = mesh.materials();
    const auto& materialOf = mesh.material_ids();
    const auto isGlass = [&](std::size_t triangle)
    {
        const int id = triangle < materialOf.size() ? materialOf[triangle] : -1;
        if (id < 0 || static_cast<std::size_t>(id) >= materials.size())
            return false;
        const auto& style = materials[static_cast<std::size_t>(id)];
        return style && style->has_transparency() && style->transparency >= kGlass;
    };
    const auto& faces = mesh.faces();
    for (std::size_t i = 0; i + 2 < faces.size(); i += 3)
    {
        element.triangles.push_back({static_cast<std::uint32_t>(faces[i]), static_cast<std::uint32_t>(faces[i + 1]),
                                     static_cast<std::uint32_t>(faces[i + 2])});
        element.triangleIsTransparent.push_back(isGlass(i / 3));
        element.isTransparent = element.isTransparent || element.triangleIsTransparent.back();
    }
}

std::string guidOf(const IfcUtil::IfcBaseClass* instance)
{
    return instance == nullptr ? std::string() : attributeText(instance, "GlobalId");
}

/// Whether a product is asked for.
bool isWanted(const IfcUtil::IfcBaseClass* product, const ReadOptions& options)
{
    const auto& schema = *product->declaration().schema();
    const auto isOf = [&](const std::string& type)
    {
        try
        {
            return product->declaration().is(*schema.declaration_by_name(type));
        }
        catch (const IfcParse::IfcException&)  // the schema has no such entity
        {
            return false;
        }
    };
    return (options.types.empty() || std::any_of(options.types.begin(), options.types.end(), isOf)) &&
           (options.guids.empty() || options.guids.contains(guidOf(product)));
}

/// The meshes by instance number. Of several representations of a product the one in the Body context counts.
std::map<int, MeshElement> readMeshes(IfcParse::IfcFile& file, const ReadOptions& options, const Relations& relations,
                                      const std::optional<MapConversion>& toMap)
{
    std::map<int, MeshElement> elements;
    std::map<int, std::string> contexts;
    const std::vector<IfcGeom::filter_t> filters{[&](IfcUtil::IfcBaseEntity* product)
                                                 { return isWanted(product, options); }};
    IfcGeom::Iterator iterator("opencascade", settingsOf(options), &file, filters, 1);
    if (!iterator.initialize())
        return elements;
    do
    {
        const auto* source = dynamic_cast<const IfcGeom::TriangulationElement*>(iterator.get());
        if (source == nullptr || source->geometry().faces().empty())
            continue;
        const auto [context, isNew] = contexts.try_emplace(source->id(), source->context());
        if (!isNew && (context->second == "Body" || source->context() != "Body"))
            continue;
        context->second = source->context();

        const IfcUtil::IfcBaseClass* product = source->product();
        MeshElement element;
        element.guid = source->guid();
        element.type = source->type();
        element.name = source->name();
        element.predefinedType = attributeText(product, "PredefinedType");
        element.storeyGuid = guidOf(relations.storeyOf(product));
        element.hostGuid = guidOf(relations.hostOf(product));
        element.openingGuid = guidOf(relations.openingOf(product));
        if (const IfcUtil::IfcBaseClass* whole = relations.wholeOf(product))
            element.whole = {guidOf(whole), whole->declaration().name(), attributeText(whole, "Name")};
        takeMesh(*source, toMap, element);
        elements[source->id()] = std::move(element);
    } while (iterator.next());
    return elements;
}

std::vector<StoreyInfo> readStoreys(IfcParse::IfcFile& file, ifcopenshell::geometry::abstract_mapping& mapping,
                                    const std::optional<MapConversion>& toMap)
{
    std::vector<StoreyInfo> storeys;
    const auto instances = file.instances_by_type("IfcBuildingStorey");
    if (!instances)
        return storeys;
    for (const IfcUtil::IfcBaseClass* instance : *instances)
    {
        StoreyInfo storey = {guidOf(instance), attributeText(instance, "Name"), 0.0};
        if (attributeInstance(instance, "ObjectPlacement") != nullptr)
        {
            const auto item = taxonomy::dcast<taxonomy::geom_item>(mapping.map(instance));
            if (item && item->matrix)
            {
                const Eigen::Vector3d origin = item->matrix->ccomponents().topRightCorner<3, 1>();
                storey.elevation_m = toMap ? toMap->toMap(origin).z() : origin.z();
            }
        }
        else
            storey.elevation_m = attributeNumber(instance, "Elevation").value_or(0.0) * mapping.get_length_unit();
        storeys.push_back(std::move(storey));
    }
    std::stable_sort(storeys.begin(), storeys.end(),
                     [](const StoreyInfo& a, const StoreyInfo& b) { return a.elevation_m < b.elevation_m; });
    return storeys;
}

/// Elements that have a body in the file but none in the result.
std::vector<std::string> missingMeshes(IfcParse::IfcFile& file, const ReadOptions& options,
                                       const std::map<int, MeshElement>& elements)
{
    std::map<int, std::string> missing;
    for (const char* kind : {"IfcElement"})
        if (const auto instances = file.instances_by_type(kind))
            for (const IfcUtil::IfcBaseClass* instance : *instances)
                if (attributeInstance(instance, "Representation") != nullptr && isWanted(instance, options) &&
                    !elements.contains(static_cast<int>(instance->id())))
                    missing[static_cast<int>(instance->id())] = instance->declaration().name() + ' ' + guidOf(instance);
    std::vector<std::string> names;
    for (auto& [id, name] : missing)
        names.push_back(std::move(name));
    return names;
}

IfcModel readOpened(IfcParse::IfcFile& file, const ReadOptions& options)
{
    IfcModel model;
    model.schema = file.schema()->name();
    Settings mappingSettings = settingsOf(options);
    const std::unique_ptr<ifcopenshell::geometry::abstract_mapping> mapping(
        ifcopenshell::geometry::impl::mapping_implementations().construct(&file, mappingSettings));
    mapping->initialize_settings();  // finds the units
    model.mapConversion = mapConversionOf(file, mapping->get_length_unit());
    const auto toMap = options.applyMapConversion ? model.mapConversion : std::nullopt;
    model.storeys = readStoreys(file, *mapping, toMap);
    std::map<int, MeshElement> elements = readMeshes(file, options, Relations(file), toMap);
    model.withoutMesh = missingMeshes(file, options, elements);
    for (auto& [id, element] : elements)
        model.elements.push_back(std::move(element));
    return model;
}

}  // namespace

IfcModel readIfc(const std::string& path, const ReadOptions& options)
{
    checkEnds(path);
    const Quiet quiet;
    IfcModel model;
    try
    {
        IfcParse::IfcFile file(path);
        if (!file.good())
            fail(path, file.good().value() == IfcParse::file_open_status::UNSUPPORTED_SCHEMA
                           ? "its schema is not supported; IFC2X3, IFC4 and IFC4X3 are"
                           : "it is damaged");
        checkReferences(file, quiet.text(), path);
        model = readOpened(file, options);
    }
    catch (const Error&)
    {
        throw;
    }
    catch (const std::exception& e)
    {
        fail(path, std::string("it is damaged (") + e.what() + ")");
    }
    catch (...)  // OpenCASCADE's and IfcOpenShell's own kinds
    {
        fail(path, "it is damaged, or holds geometry that can't be converted");
    }
    if (model.elements.empty())
        fail(path, options.types.empty() && options.guids.empty() ? "it holds no geometry"
                                                                  : "it holds no geometry of the elements asked for");
    return model;
}

}  // namespace s2b::ifc
