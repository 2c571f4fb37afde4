// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/cv4aec_json.h"

#include "core/geometry/rectangle.h"
#include "core/validation/extrude.h"
#include "core/validation/json_file.h"
#include "core/validation/statistics.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <regex>
#include <set>

namespace s2b::validation
{

namespace
{

namespace fs = std::filesystem;

constexpr double kSheet_m = 0.01;    ///< thickness of what has none
constexpr double kLong = 1.5;        ///< a door so much wider than deep lies along its wall ...
constexpr double kAlong = 0.7;       ///< ... by this cosine
constexpr double kNearWall_m = 0.3;  ///< a door's middle lies at most so far from its wall's face

struct Part
{
    std::string model;
    std::string floor;
    std::string kind;  ///< "walls", "doors" or "columns"
    fs::path path;
};

std::optional<Part> partOf(const fs::path& path)
{
    static const std::regex kName("(.*)_(.*)_(columns|doors|walls)\\.json");
    std::smatch match;
    const std::string name = path.filename().string();
    if (!std::regex_match(name, match, kName))
        return std::nullopt;
    return Part{match[1], match[2], match[3], path};
}

std::vector<Part> partsIn(const fs::path& folder)
{
    std::vector<Part> parts;
    for (const auto& entry : fs::directory_iterator(folder))
        if (auto part = partOf(entry.path()))
            parts.push_back(std::move(*part));
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.path < b.path; });
    return parts;
}

ElementClass classOf(const std::string& kind)
{
    return kind == "walls" ? ElementClass::Wall : kind == "doors" ? ElementClass::Door : ElementClass::Column;
}

const char* typeOf(ElementClass elementClass)
{
    return elementClass == ElementClass::Wall   ? "IfcWall"
           : elementClass == ElementClass::Door ? "IfcDoor"
                                                : "IfcColumn";
}

Eigen::Vector3d pointAt(const Json& object, const char* key)
{
    const auto at = object.find(key);
    if (at == object.end() || at->is_null())
        return Eigen::Vector3d::Zero();
    return {at->at(0).get<double>(), at->at(1).get<double>(), at->size() > 2 ? at->at(2).get<double>() : 0.0};
}

class Reader
{
public:
    /// @param kind  "walls" ...
    void addList(const std::string& floor, const std::string& kind, const Json& list)
    {
        const int storey = storeyOf(floor);
        int number = 0;
        for (const Json& object : list)
        {
            BimElement element;
            element.elementClass = classOf(kind);
            element.type = typeOf(element.elementClass);
            element.name = floor + " " + className(element.elementClass) + " " + std::to_string(++number);
            element.guid = element.name;
            element.storey = storey;
            if (element.elementClass == ElementClass::Wall)
                takeWall(object, element);
            else
                takeBox(object, element);
            m_bim.elements.push_back(std::move(element));
        }
    }

    Bim finish(const std::string& path)
    {
        m_bim.file = path;
        m_bim.schema = "CV4AEC";
        if (m_bim.elements.empty())
            failToRead(path, "it holds no walls, doors or columns");
        moveToOrigin();
        setElevations();
        for (BimElement& e : m_bim.elements)
            if (e.elementClass == ElementClass::Door)
                putIntoWall(e);
        checkSizes(m_bim);
        addMeshes(m_bim);
        return std::move(m_bim);
    }

private:
    int storeyOf(const std::string& floor)
    {
        for (std::size_t i = 0; i < m_bim.storeys.size(); ++i)
            if (m_bim.storeys[i].name == floor)
                return static_cast<int>(i);
        m_bim.storeys.push_back({floor, floor, 0.0, true});
        return static_cast<int>(m_bim.storeys.size()) - 1;
    }

    static void takePlan(BimElement& element, OrientedRectangle rectangle)
    {
        rectangle.half = rectangle.half.cwiseMax(0.5 * kSheet_m);
        const auto corners = rectangle.corners();
        element.plan.outer.assign(corners.begin(), corners.end());
    }

    static void takeHeights(const Json& object, double low_m, BimElement& element)
    {
        element.low_m = low_m;
        element.high_m = low_m + numberAt(object, "height", 0.0);
    }

    static void takeWall(const Json& object, BimElement& element)
    {
        if (!object.contains("start_pt") || !object.contains("end_pt"))
            throw Error(ErrorCode::BadFile, "a wall has no start_pt and end_pt");
        const Eigen::Vector3d start = pointAt(object, "start_pt");
        const Eigen::Vector3d end = pointAt(object, "end_pt");
        const Eigen::Vector2d along = (end - start).head<2>();
        const double thickness = std::max(numberAt(object, "width", 0.0), kSheet_m);
        OrientedRectangle r;
        r.center = 0.5 * (start + end).head<2>();
        if (along.norm() > 0.0)
            r.axis = along.normalized();
        r.half = {0.5 * along.norm(), 0.5 * thickness};
        takePlan(element, r);
        if (along.norm() > 0.0)
            element.axis = WallAxis{start.head<2>(), end.head<2>(), thickness};
        takeHeights(object, std::min(start.z(), end.z()), element);
    }

    static void takeBox(const Json& object, BimElement& element)
    {
        if (!object.contains("loc"))
            throw Error(ErrorCode::BadFile, "a door or column has no loc");
        const Eigen::Vector3d at = pointAt(object, "loc");
        const double turn = numberAt(object, "rotation", 0.0) * std::numbers::pi / 180.0;
        OrientedRectangle r;
        r.center = at.head<2>();
        r.axis = {std::cos(turn), std::sin(turn)};
        r.half = 0.5 * Eigen::Vector2d(numberAt(object, "width", 0.0), numberAt(object, "depth", 0.0));
        takePlan(element, r);
        takeHeights(object, at.z(), element);
    }

    void moveToOrigin()
    {
        const BimElement& first = m_bim.elements.front();
        m_bim.origin << first.plan.outer.front().array().floor(), std::floor(first.low_m);
        const Eigen::Vector2d shift = m_bim.origin.head<2>();
        for (BimElement& e : m_bim.elements)
        {
            for (Eigen::Vector2d& p : e.plan.outer)
                p -= shift;
            if (e.axis)
            {
                e.axis->start -= shift;
                e.axis->end -= shift;
            }
            e.low_m -= m_bim.origin.z();
            e.high_m -= m_bim.origin.z();
        }
    }

    void setElevations()
    {
        for (std::size_t s = 0; s < m_bim.storeys.size(); ++s)
        {
            std::vector<double> walls;
            std::vector<double> all;
            for (const BimElement& e : m_bim.elements)
                if (e.storey == static_cast<int>(s))
                {
                    all.push_back(e.low_m);
                    if (e.elementClass == ElementClass::Wall)
                        walls.push_back(e.low_m);
                }
            m_bim.storeys[s].elevation_m = medianOf(walls.empty() ? all : walls).value_or(0.0);
        }
        std::vector<int> order(m_bim.storeys.size());
        for (std::size_t s = 0; s < order.size(); ++s)
            order[s] = static_cast<int>(s);
        const auto elevation = [&](int s) { return m_bim.storeys[static_cast<std::size_t>(s)].elevation_m; };
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return elevation(a) < elevation(b); });
        std::vector<BimStorey> sorted;
        std::vector<int> newIndex(order.size());
        for (const int s : order)
        {
            newIndex[static_cast<std::size_t>(s)] = static_cast<int>(sorted.size());
            sorted.push_back(m_bim.storeys[static_cast<std::size_t>(s)]);
        }
        m_bim.storeys = std::move(sorted);
        for (BimElement& e : m_bim.elements)
            e.storey = newIndex[static_cast<std::size_t>(e.storey)];
    }

    /// The nearest wall of the floor that the door's middle lies in, or just beside.
    void putIntoWall(BimElement& door) const
    {
        const OrientedRectangle box = minimumRectangle(door.plan.outer);
        double nearest = kNearWall_m;
        for (std::size_t i = 0; i < m_bim.elements.size(); ++i)
        {
            const BimElement& wall = m_bim.elements[i];
            if (!wall.axis || wall.storey != door.storey)
                continue;
            const Eigen::Vector2d d = wall.axis->end - wall.axis->start;
            const Eigen::Vector2d u = d.normalized();
            if (box.half.x() > kLong * box.half.y() && std::abs(box.axis.dot(u)) < kAlong)
                continue;  // in a corner the other wall may be nearer
            const double along = (box.center - wall.axis->start).dot(u);
            const double across = std::abs((box.center - wall.axis->start).dot(Eigen::Vector2d(-u.y(), u.x())));
            const double gap = across - 0.5 * wall.axis->thickness_m;
            if (!(along >= 0.0 && along <= d.norm()) || gap >= nearest)
                continue;
            nearest = gap;
            door.host = static_cast<int>(i);
        }
        if (door.host < 0)
            return;
        const WallAxis& axis = *m_bim.elements[static_cast<std::size_t>(door.host)].axis;
        OrientedRectangle flush = rectangleAlong(door.plan.outer, axis.end - axis.start);
        flush.center -= flush.across() * flush.across().dot(flush.center - axis.start);
        flush.half.y() = 0.5 * axis.thickness_m;
        takePlan(door, flush);
    }

    Bim m_bim;
};

bool takeObject(Reader& reader, const std::string& floor, const Json& file)
{
    bool isAny = false;
    for (const char* kind : {"walls", "columns", "doors"})
        if (const auto at = file.find(kind); at != file.end() && at->is_array())
        {
            reader.addList(floor, kind, *at);
            isAny = true;
        }
    return isAny;
}

/// What a list without a telling file name holds.
std::string kindOf(const fs::path& path, const Json& list)
{
    for (const char* kind : {"wall", "door", "column"})
        if (path.stem().string().find(kind) != std::string::npos)
            return std::string(kind) + "s";
    if (!list.empty() && list.front().is_object() && list.front().contains("start_pt"))
        return "walls";
    failToRead(path.string(),
               "it is a list, but neither its name (MODEL_FLOOR_walls.json, _doors, _columns) nor its "
               "content says of what; it is no CV4AEC model");
}

}  // namespace

Bim readCv4aec(const std::string& path)
{
    const fs::path file(path);
    std::vector<Part> parts;
    if (fs::is_directory(file))
    {
        parts = partsIn(file);
        std::set<std::string> models;
        for (const Part& p : parts)
            models.insert(p.model);
        if (models.size() != 1)
            failToRead(path, models.empty()
                                 ? "the folder holds no CV4AEC files (MODEL_FLOOR_walls.json, _doors, _columns)"
                                 : "the folder holds several CV4AEC models; give a file of one of them");
    }
    else if (const auto own = partOf(file))
    {
        parts = partsIn(fs::absolute(file).parent_path());
        std::erase_if(parts, [&](const Part& p) { return p.model != own->model; });
    }

    Reader reader;
    std::string current = path;
    try
    {
        for (const Part& part : parts)
        {
            current = part.path.string();
            const Json list = parseJsonFile(current);
            if (!list.is_array())
                failToRead(current, "it is not a list of objects, as CV4AEC files are");
            reader.addList(part.floor, part.kind, list);
        }
        if (parts.empty())
        {
            const Json content = parseJsonFile(path);
            if (content.is_array())
                reader.addList(file.stem().string(), kindOf(file, content), content);
            else if (!takeObject(reader, file.stem().string(), content))
                failToRead(path, "it is JSON, but neither a CV4AEC model nor the truth of a simulated survey");
        }
        return reader.finish(path);
    }
    catch (const Json::exception& e)
    {
        failToRead(current, std::string("it is not a CV4AEC model (") + e.what() + ")");
    }
    catch (const Error& e)
    {
        if (std::string(e.what()).starts_with("can't"))
            throw;
        failToRead(current, e.what());
    }
}

}  // namespace s2b::validation
