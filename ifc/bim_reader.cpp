// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc/bim_reader.h"

#include "core/base/error.h"
#include "core/geometry/polygon.h"
#include "core/geometry/rectangle.h"
#include "core/validation/extrude.h"
#include "ifc/ifc_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace s2b::ifc
{

namespace
{

using validation::Bim;
using validation::BimElement;
using validation::ElementClass;

constexpr double kStraightFill = 0.85;         ///< share of the rectangle from which a wall is straight
constexpr double kRoundFill[] = {0.74, 0.83};  ///< of a circle in its square: pi / 4 = 0.785
constexpr std::size_t kRoundCorners = 9;
constexpr double kSameFloor_m = 0.5;  ///< an element that begins so far below a storey is still in it
constexpr double kWhole = 0.9;
constexpr double kPrism = 1e-3;      ///< of its volume: a body that fills its plan from low to high
constexpr double kThrough_m = 1e-3;  ///< what an opening may leave of a wall's thickness
constexpr double kSheet_m = 0.01;    ///< given to plans without a width

const std::vector<std::string> kBodies{"IfcWall", "IfcColumn", "IfcSlab", "IfcSpace", "IfcDoor", "IfcWindow"};

std::optional<ElementClass> classOf(const std::string& type)
{
    const std::pair<const char*, ElementClass> known[] = {
        {"IfcWall", ElementClass::Wall},     {"IfcDoor", ElementClass::Door}, {"IfcWindow", ElementClass::Window},
        {"IfcColumn", ElementClass::Column}, {"IfcSlab", ElementClass::Slab}, {"IfcSpace", ElementClass::Space}};
    for (const auto& [prefix, elementClass] : known)
        for (const char* suffix : {"", "StandardCase", "ElementedCase"})
            if (type == std::string(prefix) + suffix)
                return elementClass;
    return std::nullopt;
}

Polygon planOf(OrientedRectangle rectangle)
{
    rectangle.half = rectangle.half.cwiseMax(0.5 * kSheet_m);
    const auto corners = rectangle.corners();
    return {{corners.begin(), corners.end()}, {}};
}

double areaOf(const std::vector<Polygon>& polygons)
{
    double sum = 0.0;
    for (const Polygon& p : polygons)
        sum += area(p);
    return sum;
}

class Reader
{
public:
    Reader(const std::string& path, const BimReadOptions& options) : m_path(path), m_options(options) {}

    Bim read()
    {
        ReadOptions whole;
        whole.subtractOpenings = false;
        whole.types = kBodies;
        whole.types.emplace_back("IfcOpeningElement");
        whole.types.emplace_back("IfcBuildingElementPart");
        m_model = readIfc(m_path, whole);
        m_bim.file = m_path;
        m_bim.schema = m_model.schema;
        joinParts();
        place();
        storeys();
        for (const MeshElement& e : m_model.elements)
            if (e.type == "IfcOpeningElement" || e.type == "IfcOpeningStandardCase")
                m_openings[e.guid] = &e;
        for (const char* host : {"host", "filling"})  // walls first: doors and windows are drawn flush with them
            for (const MeshElement& e : m_model.elements)
                if (const auto c = classOf(e.type); c && isFilling(*c) == (std::string(host) == "filling"))
                    take(e, *c);
        if (m_bim.elements.empty())
            fail("it holds no walls, doors, windows, columns, slabs or spaces with geometry");
        checkSizes(m_bim);
        if (m_options.withMeshes)
            cutOpenings();
        return std::move(m_bim);
    }

private:
    [[noreturn]] void fail(const std::string& reason) const
    {
        throw Error(ErrorCode::BadFile, "can't use " + m_path + ": " + reason);
    }

    static bool isFilling(ElementClass c) { return c == ElementClass::Door || c == ElementClass::Window; }

    /// Elements that have no body of their own get that of their parts: layers of a wall, for example.
    void joinParts()
    {
        std::map<std::string, std::size_t> index;
        for (std::size_t i = 0; i < m_model.elements.size(); ++i)
            index[m_model.elements[i].guid] = i;
        const std::size_t count = m_model.elements.size();
        for (std::size_t i = 0; i < count; ++i)
        {
            const MeshElement part = m_model.elements[i];
            if (part.type != "IfcBuildingElementPart" || !classOf(part.whole.type))
                continue;
            const auto [at, isNew] = index.try_emplace(part.whole.guid, m_model.elements.size());
            if (isNew)
            {
                MeshElement joined;
                joined.guid = part.whole.guid;
                joined.type = part.whole.type;
                joined.name = part.whole.name;
                joined.storeyGuid = part.storeyGuid;
                m_model.elements.push_back(std::move(joined));
            }
            else if (at->second < count)
                continue;  // it has its own
            MeshElement& joined = m_model.elements[at->second];
            const auto first = static_cast<std::uint32_t>(joined.vertices.size());
            joined.vertices.insert(joined.vertices.end(), part.vertices.begin(), part.vertices.end());
            for (const auto& t : part.triangles)
                joined.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        }
    }

    /// Decides for the model's or the map's coordinates, and for an origin near the elements.
    void place()
    {
        const MeshElement* first = nullptr;
        for (const ElementClass c : {ElementClass::Wall, ElementClass::Column, ElementClass::Slab})
            for (const MeshElement& e : m_model.elements)
                if (first == nullptr && classOf(e.type) == c)
                    first = &e;
        if (first == nullptr)
            first = &m_model.elements.front();
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& v : first->vertices)
            middle += v / static_cast<double>(first->vertices.size());
        if (m_model.mapConversion && m_options.near &&
            (m_model.mapConversion->toMap(middle) - *m_options.near).norm() < (middle - *m_options.near).norm())
        {
            m_toMap = m_model.mapConversion;
            middle = m_toMap->toMap(middle);
        }
        m_bim.origin = middle.array().floor();  // whole metres: differences to it are exact
    }

    [[nodiscard]] Eigen::Vector3d local(const Eigen::Vector3d& p) const
    {
        return (m_toMap ? m_toMap->toMap(p) : p) - m_bim.origin;
    }

    void storeys()
    {
        for (const StoreyInfo& s : m_model.storeys)
        {
            m_storey[s.guid] = static_cast<int>(m_bim.storeys.size());
            m_bim.storeys.push_back({s.guid, s.name, local({0.0, 0.0, s.elevation_m}).z(), true});
        }
    }

    struct Points
    {
        std::vector<Eigen::Vector2d> plan;
        double low_m = std::numeric_limits<double>::infinity();
        double high_m = -std::numeric_limits<double>::infinity();
    };
    [[nodiscard]] Points points(const MeshElement& e) const
    {
        Points result;
        for (const Eigen::Vector3d& v : e.vertices)
        {
            const Eigen::Vector3d p = local(v);
            result.plan.emplace_back(p.head<2>());
            result.low_m = std::min(result.low_m, p.z());
            result.high_m = std::max(result.high_m, p.z());
        }
        return result;
    }

    /// What the body covers in plan.
    static std::vector<Polygon> outline(const MeshElement& e, const Points& points)
    {
        std::vector<Polygon> triangles;
        for (const auto& t : e.triangles)
        {
            Polygon triangle{{points.plan[t[0]], points.plan[t[1]], points.plan[t[2]]}, {}};
            if (std::abs(signedArea(triangle.outer)) > 1e-6)
                triangles.push_back(std::move(triangle));
        }
        return unite(triangles);
    }

    void take(const MeshElement& source, ElementClass elementClass)
    {
        const auto opening = m_openings.find(source.openingGuid);
        const MeshElement& shape = opening != m_openings.end() ? *opening->second : source;
        const Points p = points(shape);
        if (p.plan.empty())
            return;
        BimElement element;
        element.elementClass = elementClass;
        element.guid = source.guid;
        element.name = source.name;
        element.type = source.type;
        element.low_m = p.low_m;
        element.high_m = p.high_m;
        if (const auto storey = m_storey.find(source.storeyGuid); storey != m_storey.end())
            element.storey = storey->second;
        else
            element.storey = validation::storeyAt(m_bim, p.low_m + kSameFloor_m);
        const OrientedRectangle rectangle = minimumRectangle(p.plan);
        element.plan = planOf(rectangle);
        if (elementClass == ElementClass::Wall)
            takeWall(element, shape, p, rectangle);
        else if (elementClass == ElementClass::Column)
            takeColumn(element, p, rectangle);
        else if (elementClass == ElementClass::Space)
            takeSpace(element, shape, p);
        else if (isFilling(elementClass))
            takeFilling(element, source);
        if (m_options.withMeshes)
            takeMesh(element, source);
        m_index[element.guid] = static_cast<int>(m_bim.elements.size());
        m_bim.elements.push_back(std::move(element));
    }

    static double volumeOf(const MeshElement& e) { return validation::volumeOf({e.vertices, e.triangles}); }

    static void takeWall(BimElement& element, const MeshElement& e, const Points& p, const OrientedRectangle& rectangle)
    {
        const std::vector<Polygon> covered = outline(e, p);
        if (covered.empty())  // a sheet
            return;
        const double rectangle_m2 = rectangle.area();
        // A closed body is no larger than its outline swept up: an open one may lack its lower and upper face.
        const bool isWhole = areaOf(covered) * (p.high_m - p.low_m) > kWhole * std::abs(volumeOf(e));
        if (isWhole && covered.size() == 1 && area(covered.front()) < kStraightFill * rectangle_m2)
        {
            element.plan = covered.front();
            return;
        }
        if (isWhole && areaOf(covered) < 0.999 * rectangle_m2)
            element.footprint = covered;
        const Eigen::Vector2d half = rectangle.axis * rectangle.half.x();
        element.axis = validation::WallAxis{rectangle.center - half, rectangle.center + half, 2.0 * rectangle.half.y()};
    }

    static void takeColumn(BimElement& element, const Points& p, const OrientedRectangle& rectangle)
    {
        const std::vector<Eigen::Vector2d> hull = convexHull(p.plan);
        const double fill = signedArea(hull) / std::max(rectangle.area(), 1e-12);
        if (fill > kRoundFill[0] && fill < kRoundFill[1] && hull.size() >= kRoundCorners)
            element.plan.outer = hull;
    }

    static void takeSpace(BimElement& element, const MeshElement& e, const Points& p)
    {
        const std::vector<Polygon> covered = outline(e, p);
        if (covered.size() == 1)
            element.plan = covered.front();
    }

    void takeFilling(BimElement& element, const MeshElement& source)
    {
        const auto host = m_index.find(source.hostGuid);
        if (host == m_index.end() ||
            m_bim.elements[static_cast<std::size_t>(host->second)].elementClass != ElementClass::Wall)
            return;
        element.host = host->second;
        const Polygon& wall = m_bim.elements[static_cast<std::size_t>(host->second)].plan;
        const std::vector<Polygon> flush = intersect(std::span(&wall, 1), std::span(&element.plan, 1));
        if (flush.size() == 1 && area(flush.front()) > 1e-4)
            element.plan = planOf(minimumRectangle(flush.front().outer));
    }

    void takeMesh(BimElement& element, const MeshElement& source) const
    {
        element.mesh.vertices.clear();
        for (const Eigen::Vector3d& v : source.vertices)
            element.mesh.vertices.push_back(local(v));
        element.mesh.triangles = source.triangles;
    }

    /// Whether a mesh fills its plan from low to high.
    static bool isPrism(const BimElement& e)
    {
        const double whole = area(e.plan) * (e.high_m - e.low_m);
        return std::abs(std::abs(validation::volumeOf(e.mesh)) - whole) < kPrism * whole;
    }

    /// An opening as a box along its wall, when it is one that cuts through the whole thickness.
    [[nodiscard]] std::optional<BimElement> holeOf(const MeshElement& opening, const BimElement& wall) const
    {
        const Points p = points(opening);
        BimElement hole;
        hole.low_m = p.low_m;
        hole.high_m = p.high_m;
        const OrientedRectangle r = rectangleAlong(p.plan, wall.axis->end - wall.axis->start);
        hole.plan = planOf(r);
        takeMesh(hole, opening);
        const double aside = std::abs(r.across().dot(r.center - wall.axis->start));
        if (!isPrism(hole) || r.half.y() - aside < 0.5 * wall.axis->thickness_m - kThrough_m)
            return std::nullopt;
        return hole;
    }

    /// Cuts boxes out of straight walls; any other element with openings is read once more, for OpenCASCADE to cut
    /// them.
    void cutOpenings()
    {
        std::map<int, std::vector<const MeshElement*>> openings;
        for (const auto& [guid, opening] : m_openings)
            if (const auto host = m_index.find(opening->hostGuid); host != m_index.end())
                openings[host->second].push_back(opening);
        ReadOptions options;
        for (const auto& [host, sources] : openings)
        {
            BimElement& element = m_bim.elements[static_cast<std::size_t>(host)];
            std::vector<BimElement> holes;
            if (element.elementClass == ElementClass::Wall && element.axis && isPrism(element))
                for (const MeshElement* source : sources)
                    if (auto hole = holeOf(*source, element))
                        holes.push_back(std::move(*hole));
            if (holes.size() < sources.size())
            {
                options.guids.insert(element.guid);
                continue;
            }
            std::vector<const BimElement*> all;
            for (const BimElement& hole : holes)
                all.push_back(&hole);
            element.mesh = validation::wallMesh(element, all);
        }
        if (options.guids.empty())
            return;
        const IfcModel cut = readIfc(m_path, options);
        for (const MeshElement& e : cut.elements)
            if (const auto at = m_index.find(e.guid); at != m_index.end())
                takeMesh(m_bim.elements[static_cast<std::size_t>(at->second)], e);
    }

    std::string m_path;
    BimReadOptions m_options;
    IfcModel m_model;
    std::optional<MapConversion> m_toMap;
    Bim m_bim;
    std::map<std::string, const MeshElement*> m_openings;
    std::map<std::string, int> m_storey;
    std::map<std::string, int> m_index;  ///< of elements, by GUID
};

}  // namespace

validation::Bim readBim(const std::string& path, const BimReadOptions& options)
{
    return Reader(path, options).read();
}

}  // namespace s2b::ifc
