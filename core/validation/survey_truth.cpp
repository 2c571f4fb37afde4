// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/survey_truth.h"

#include "core/geometry/polygon.h"
#include "core/geometry/rectangle.h"
#include "core/validation/extrude.h"
#include "core/validation/json_file.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace s2b::validation
{

namespace
{

constexpr double kSeenShare = 0.10;
constexpr double kSeenSide = 0.3;
constexpr double kSeenColumn = 0.15;
constexpr double kSeenPoints = 200.0;
constexpr double kLeastBand_m = 0.3;

struct Box
{
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    Eigen::Vector3d half = Eigen::Vector3d::Zero();
    double yaw_rad = 0.0;

    [[nodiscard]] Polygon plan() const
    {
        OrientedRectangle r;
        r.center = center.head<2>();
        r.axis = {std::cos(yaw_rad), std::sin(yaw_rad)};
        r.half = half.head<2>();
        const auto corners = r.corners();
        return {{corners.begin(), corners.end()}, {}};
    }
};

std::optional<ElementClass> classOf(const std::string& type)
{
    const std::pair<const char*, ElementClass> known[] = {{"IfcWall", ElementClass::Wall},
                                                          {"IfcDoor", ElementClass::Door},
                                                          {"IfcWindow", ElementClass::Window},
                                                          {"IfcColumn", ElementClass::Column},
                                                          {"IfcSlab", ElementClass::Slab}};
    for (const auto& [prefix, elementClass] : known)
        if (type.starts_with(prefix))
            return elementClass;
    return std::nullopt;
}

class Reader
{
public:
    explicit Reader(const Json& file) : m_file(file)
    {
        for (const Json& e : file.at("elements"))
            m_byGuid[textAt(e, "GlobalId")] = &e;
        // A round number near the elements: differences to it are exact.
        for (const Json& e : file.at("elements"))
            if (e.contains("obb"))
            {
                const auto c = e["obb"]["center"].get<std::array<double, 3>>();
                m_bim.origin = {std::floor(c[0]), std::floor(c[1]), std::floor(c[2])};
                break;
            }
    }

    Bim read()
    {
        m_bim.schema = "survey";
        storeys();
        for (const Json& e : m_file.at("elements"))
            element(e);
        for (std::size_t i = 0; i < m_bim.elements.size(); ++i)
            if (const auto host = m_index.find(m_hosts[i]); host != m_index.end())
                m_bim.elements[i].host = host->second;
        if (m_file.contains("spaces"))
            for (const Json& s : m_file["spaces"])
                space(s);
        addMeshes(m_bim);
        return std::move(m_bim);
    }

private:
    [[nodiscard]] Eigen::Vector2d point(const Json& p) const
    {
        return Eigen::Vector2d(p.at(0).get<double>(), p.at(1).get<double>()) - m_bim.origin.head<2>();
    }
    [[nodiscard]] double height(const Json& object, const char* key) const
    {
        return object.at(key).get<double>() - m_bim.origin.z();
    }
    [[nodiscard]] Box box(const Json& o) const
    {
        const auto c = o.at("center").get<std::array<double, 3>>();
        const auto h = o.at("half").get<std::array<double, 3>>();
        return {Eigen::Vector3d(c[0], c[1], c[2]) - m_bim.origin, {h[0], h[1], h[2]}, o.at("yaw").get<double>()};
    }
    [[nodiscard]] Polygon ring(const Json& points) const
    {
        Polygon polygon;
        for (const Json& p : points)
            polygon.outer.push_back(point(p));
        return polygon;
    }
    [[nodiscard]] std::vector<Polygon> footprint(const Json& e) const
    {
        std::vector<Polygon> rings;
        if (const auto at = e.find("footprint"); at != e.end() && at->is_array())
            for (const Json& r : *at)
                if (r.size() >= 3)
                    rings.push_back(ring(r));
        return unite(rings);
    }
    [[nodiscard]] const Json* hostOf(const Json& e) const
    {
        const auto at = m_byGuid.find(textAt(e, "host"));
        return at == m_byGuid.end() ? nullptr : at->second;
    }
    [[nodiscard]] static bool isCurved(const Json& wall)
    {
        const auto at = wall.find("curved");
        return at != wall.end() && at->is_boolean() && at->get<bool>();
    }

    void storeys()
    {
        for (const Json& s : m_file.at("storeys"))
        {
            BimStorey storey;
            storey.guid = textAt(s, "GlobalId");
            storey.name = textAt(s, "name");
            storey.elevation_m = numberAt(s, "floor_z", numberAt(s, "elevation", 0.0)) - m_bim.origin.z();
            storey.isSurveyed = s.at("scanned").get<bool>();
            m_bim.storeys.push_back(storey);
            m_band[storey.guid] = {numberAt(s, "floor_z", NAN), numberAt(s, "ceiling_z", NAN)};
        }
        std::stable_sort(m_bim.storeys.begin(), m_bim.storeys.end(),
                         [](const BimStorey& a, const BimStorey& b) { return a.elevation_m < b.elevation_m; });
        for (std::size_t i = 0; i < m_bim.storeys.size(); ++i)
            m_storey[m_bim.storeys[i].guid] = static_cast<int>(i);
    }
    [[nodiscard]] int storeyOf(const Json& object) const
    {
        const auto at = m_storey.find(textAt(object, "storey"));
        return at == m_storey.end() ? -1 : at->second;
    }

    /// The opening of a door or window, flush with its wall.
    void takeOpening(const Json& e, BimElement& element) const
    {
        Box o = box(e["opening"]);
        const Json* host = hostOf(e);
        if (host != nullptr && !isCurved(*host) && host->contains("thickness"))
        {
            const Eigen::Vector2d a = point(host->at("axis").at(0));
            const Eigen::Vector2d d = point(host->at("axis").at(1)) - a;
            const Eigen::Vector2d u = d / std::max(d.norm(), 1e-9);
            const Eigen::Vector2d n(-u.y(), u.x());
            o.center.head<2>() += n * n.dot(a - o.center.head<2>());
            o.half.y() = host->at("thickness").get<double>() / 2.0;
            o.yaw_rad = std::atan2(u.y(), u.x());
        }
        element.plan = o.plan();
        element.low_m = o.center.z() - o.half.z();
        element.high_m = o.center.z() + o.half.z();
    }

    void element(const Json& e)
    {
        const auto elementClass = classOf(textAt(e, "type"));
        if (!elementClass || !e.contains("obb"))
            return;
        BimElement element;
        element.elementClass = *elementClass;
        element.guid = textAt(e, "GlobalId");
        element.name = textAt(e, "name");
        element.type = textAt(e, "type");
        element.storey = storeyOf(e);
        const bool isFilling = *elementClass == ElementClass::Door || *elementClass == ElementClass::Window;
        if (isFilling && e.contains("opening") && e["opening"].is_object())
            takeOpening(e, element);
        else
        {
            const Box o = box(e["obb"]);
            element.plan = o.plan();
            element.low_m = isFilling ? o.center.z() - o.half.z() : height(e, "z_min");
            element.high_m = isFilling ? o.center.z() + o.half.z() : height(e, "z_max");
        }
        takeOutline(e, element);
        element.visibility = visibility(e, element);
        m_index[element.guid] = static_cast<int>(m_bim.elements.size());
        m_hosts.push_back(isFilling ? textAt(e, "host") : std::string());
        m_bim.elements.push_back(std::move(element));
    }

    void takeOutline(const Json& e, BimElement& element) const
    {
        element.footprint = footprint(e);
        const bool isWall = element.elementClass == ElementClass::Wall;
        const bool isRound = element.elementClass == ElementClass::Column && textAt(e, "section") == "round";
        if (((isWall && isCurved(e)) || isRound) && !element.footprint.empty())
            element.plan = *std::max_element(element.footprint.begin(), element.footprint.end(),
                                             [](const Polygon& a, const Polygon& b) { return area(a) < area(b); });
        if (isWall && !isCurved(e) && e.contains("axis") && e.contains("thickness"))
            element.axis = WallAxis{point(e["axis"].at(0)), point(e["axis"].at(1)), e["thickness"].get<double>()};
        const Json* host = element.elementClass == ElementClass::Door || element.elementClass == ElementClass::Window
                               ? hostOf(e)
                               : nullptr;
        if (host == nullptr || !isCurved(*host))
            return;
        const std::vector<Polygon> flush = intersect(footprint(*host), std::span(&element.plan, 1));
        if (flush.size() == 1 && area(flush.front()) > 1e-4)
        {
            const auto corners = minimumRectangle(flush.front().outer).corners();
            element.plan.outer.assign(corners.begin(), corners.end());
        }
    }

    [[nodiscard]] Visibility visibility(const Json& e, const BimElement& element) const
    {
        Visibility v;
        const double seen = numberAt(e, "visible_fraction", 0.0);
        const double points = numberAt(e, "points", 0.0);
        const double left = numberAt(e, "visible_side_pos", NAN);
        const double right = numberAt(e, "visible_side_neg", NAN);
        const bool hasSides = element.elementClass == ElementClass::Wall && !std::isnan(left) && !std::isnan(right);
        v.counts = seen >= kSeenShare && points >= kSeenPoints;
        if (hasSides)
        {
            v.counts = std::max(left, right) >= kSeenSide && points >= kSeenPoints;
            v.isBothSidesSeen = std::min(left, right) >= kSeenSide;
        }
        else if (element.elementClass == ElementClass::Column)
            v.counts = seen >= kSeenColumn;
        else if (element.elementClass == ElementClass::Door || element.elementClass == ElementClass::Window)
            v.counts = e.contains("host_points_near") ? numberAt(e, "host_points_near", 0.0) >= kSeenPoints : v.counts;
        const bool isSurveyed =
            element.storey >= 0 && m_bim.storeys[static_cast<std::size_t>(element.storey)].isSurveyed;
        v.counts = v.counts && isSurveyed;
        const auto band = m_band.find(textAt(e, "storey"));
        if ((element.elementClass == ElementClass::Wall || element.elementClass == ElementClass::Column) &&
            band != m_band.end() && !std::isnan(band->second.first) && !std::isnan(band->second.second))
        {
            v.bandLow_m = band->second.first - m_bim.origin.z();
            v.bandHigh_m = band->second.second - m_bim.origin.z();
            if (std::min(element.high_m, *v.bandHigh_m) - std::max(element.low_m, *v.bandLow_m) < kLeastBand_m)
                v.counts = false;
        }
        return v;
    }

    void space(const Json& s)
    {
        if (!s.contains("polygon") || s["polygon"].size() < 3 || !s.contains("z_min") || !s.contains("z_max"))
            return;
        BimElement element;
        element.elementClass = ElementClass::Space;
        element.guid = textAt(s, "GlobalId");
        element.name = textAt(s, "name");
        element.type = "IfcSpace";
        element.storey = storeyOf(s);
        element.plan = ring(s["polygon"]);
        element.low_m = height(s, "z_min");
        element.high_m = height(s, "z_max");
        element.visibility = Visibility{};
        element.visibility->counts =
            element.storey >= 0 && m_bim.storeys[static_cast<std::size_t>(element.storey)].isSurveyed;
        m_bim.elements.push_back(std::move(element));
    }

    const Json& m_file;
    Bim m_bim;
    std::map<std::string, const Json*> m_byGuid;
    std::map<std::string, int> m_storey;
    std::map<std::string, std::pair<double, double>> m_band;  ///< by the storey's GUID, world
    std::map<std::string, int> m_index;
    std::vector<std::string> m_hosts;  ///< GUID of the host, of each element
};

}  // namespace

Bim readSurveyTruth(const std::string& path)
{
    const Json file = parseJsonFile(path);
    try
    {
        Bim bim = Reader(file).read();
        bim.file = path;
        if (bim.elements.empty())
            failToRead(path, "it holds no walls, doors, windows, columns or slabs");
        checkSizes(bim);
        return bim;
    }
    catch (const Json::exception& e)
    {
        failToRead(path, std::string("it is not the truth of a simulated survey (") + e.what() + ")");
    }
}

bool isSurveyTruth(const std::string& path)
{
    const Json file = parseJsonFile(path);
    return file.is_object() && file.contains("elements") && file.contains("storeys");
}

}  // namespace s2b::validation
