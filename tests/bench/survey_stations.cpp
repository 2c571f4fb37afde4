// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/survey_stations.h"

#include "core/cloud/station_file.h"

#include <algorithm>

namespace s2b
{

SurveyStations surveyStations(const std::string& path, const Eigen::Vector3d& origin,
                              const std::vector<std::uint16_t>& sources)
{
    SurveyStations result;
    const std::vector<KnownStation> known = readStations(path);
    for (const KnownStation& s : known)
        result.positions.push_back(s.position - origin);
    if (std::ranges::all_of(sources, [](std::uint16_t s) { return s == 0; }))  // LAS: none
        return result;
    const StationIds ids(known, *std::min_element(sources.begin(), sources.end()));
    result.ofPoint.reserve(sources.size());
    for (const std::uint16_t s : sources)
        result.ofPoint.push_back(ids.indexOf(s));
    return result;
}

}  // namespace s2b
