// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/station_file.h"

#include "core/base/error.h"
#include "core/cloud/point_cloud.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string_view>

namespace s2b
{
namespace
{

using Json = nlohmann::json;

constexpr int kLargestId = 65535;  // LAS keeps 16 bits

[[noreturn]] void fail(const std::string& path, const std::string& what)
{
    throw Error(ErrorCode::BadFile, "the stations' file '" + path + "' can't be used: " + what);
}

std::vector<std::string_view> fieldsOf(std::string_view line)
{
    line = line.substr(0, line.find('#'));
    std::vector<std::string_view> fields;
    constexpr std::string_view kSeparators = " \t,;\r";
    for (std::size_t i = line.find_first_not_of(kSeparators); i != std::string_view::npos;)
    {
        const std::size_t end = std::min(line.size(), line.find_first_of(kSeparators, i));
        fields.push_back(line.substr(i, end - i));
        i = line.find_first_not_of(kSeparators, end);
    }
    return fields;
}

std::optional<double> numberOf(std::string_view text)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

int idOf(double value, const std::string& path, const std::string& place)
{
    if (value != std::floor(value) || value < 0 || value > kLargestId)
        fail(path, place + " has an id that is not a whole number from 0 to 65535");
    return static_cast<int>(value);
}

std::vector<KnownStation> readText(const std::string& text, const std::string& path)
{
    std::vector<KnownStation> stations;
    std::istringstream in(text);
    bool isFirst = true;
    std::string line;
    for (int number = 1; std::getline(in, line); ++number)
    {
        const std::vector<std::string_view> fields = fieldsOf(line);
        if (fields.empty())
            continue;
        std::vector<double> values;
        for (const std::string_view f : fields)
            if (const auto v = numberOf(f))
                values.push_back(*v);
        const std::string place = "line " + std::to_string(number);
        if (isFirst && values.empty())  // titles
        {
            isFirst = false;
            continue;
        }
        isFirst = false;
        if (values.size() != fields.size() || values.size() < 3 || values.size() > 4)
            fail(path, place + " is not 'id x y z' or 'x y z'");
        KnownStation station;
        if (values.size() == 4)
            station.id = idOf(values.front(), path, place);
        station.position = Eigen::Map<const Eigen::Vector3d>(values.data() + values.size() - 3);
        stations.push_back(station);
    }
    return stations;
}

Eigen::Vector3d positionOf(const Json& values, const std::string& path, const std::string& place)
{
    if (!values.is_array() || values.size() < 3 ||
        !std::all_of(values.begin(), values.begin() + 3, [](const Json& v) { return v.is_number(); }))
        fail(path, place + " has no three coordinates");
    return {values[0].get<double>(), values[1].get<double>(), values[2].get<double>()};
}

std::vector<KnownStation> readJson(const std::string& text, const std::string& path)
{
    Json root = Json::parse(text, nullptr, false);
    if (root.is_discarded())
        fail(path, "it is not JSON");
    if (root.is_object())
        root = root.value("stations", Json());
    if (!root.is_array())
        fail(path, "it has no list 'stations'");
    std::vector<KnownStation> stations;
    for (const Json& entry : root)
    {
        const std::string place = "station " + std::to_string(stations.size() + 1);
        KnownStation station;
        if (entry.is_object())
        {
            station.position =
                positionOf(entry.contains("position")
                               ? entry["position"]
                               : Json{entry.value("x", Json()), entry.value("y", Json()), entry.value("z", Json())},
                           path, place);
            if (entry.contains("id"))
            {
                if (!entry["id"].is_number())
                    fail(path, place + " has an id that is not a whole number from 0 to 65535");
                station.id = idOf(entry["id"].get<double>(), path, place);
            }
        }
        else
            station.position = positionOf(entry, path, place);
        stations.push_back(station);
    }
    return stations;
}

}  // namespace

std::vector<KnownStation> readStations(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file)
        fail(path, "it can't be opened");
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    const bool isJson = first != std::string::npos && (text[first] == '{' || text[first] == '[');
    std::vector<KnownStation> stations = isJson ? readJson(text, path) : readText(text, path);
    if (stations.empty())
        fail(path, "it has no station");
    if (stations.size() >= StationView::kUnknown)
        fail(path, "it has more than 65534 stations");
    std::set<int> ids;
    for (const KnownStation& s : stations)
    {
        if (s.id.has_value() != stations.front().id.has_value())
            fail(path, "some stations have ids and some have none");
        if (s.id && !ids.insert(*s.id).second)
            fail(path, "the id " + std::to_string(*s.id) + " is given twice");
        if (!s.position.allFinite())
            fail(path, "a coordinate is not a finite number");
    }
    return stations;
}

StationIds::StationIds(const std::vector<KnownStation>& stations, int smallestId) : m_none(StationView::kUnknown)
{
    const int base = smallestId == 0 ? 0 : 1;
    for (std::size_t i = 0; i < stations.size(); ++i)
    {
        const auto id = static_cast<std::size_t>(stations[i].id.value_or(static_cast<int>(i) + base));
        if (id >= m_index.size())
            m_index.resize(id + 1, m_none);
        m_index[id] = static_cast<std::uint16_t>(i);
    }
}

}  // namespace s2b
