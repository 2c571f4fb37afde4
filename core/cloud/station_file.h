// SPDX-License-Identifier: GPL-3.0-or-later
/// Files that say where the scanner stood (docs/user_guide.md), and which of their stations a point's id means.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace s2b
{

struct KnownStation
{
    std::optional<int> id;  ///< as the points bear it (LAS: point source id); without one the place in the list counts
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< world coordinates [m]
};

/// Text, one station a line: "id x y z", or "x y z" without ids, separated by blanks, commas, semicolons or tabs; what
/// follows a # and a first line of titles are skipped. Or JSON: a list, or an object whose "stations" is one, of
/// [x, y, z, ...] (the survey simulator's truth) or of objects with x, y, z (or "position": [x, y, z]) and perhaps
/// "id".
/// @throws Error{BadFile} that names the file and the line or entry: not readable, no station, a number missing or not
/// finite, an id given twice or only to some, more than 65534 stations.
[[nodiscard]] std::vector<KnownStation> readStations(const std::string& path);

/// From a point's id to the station's place in the list.
class StationIds
{
public:
    /// @param smallestId  of the points. A list without ids counts from 1, or from 0 when a point bears 0 (in LAS the
    /// latter means "none": a cloud that has both kinds of points has to name its ids).
    StationIds(const std::vector<KnownStation>& stations, int smallestId);

    /// StationView::kUnknown for an id that is not in the list.
    [[nodiscard]] std::uint16_t indexOf(int id) const
    {
        return id >= 0 && id < static_cast<int>(m_index.size()) ? m_index[static_cast<std::size_t>(id)] : m_none;
    }

private:
    std::uint16_t m_none;
    std::vector<std::uint16_t> m_index;  ///< by id
};

}  // namespace s2b
