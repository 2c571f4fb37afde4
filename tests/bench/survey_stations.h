// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/point_cloud.h"

#include <cstdint>
#include <string>
#include <vector>

namespace s2b
{

/// The stations of a survey, and which of them each point was measured from.
struct SurveyStations
{
    std::vector<Eigen::Vector3d> positions;
    std::vector<std::uint16_t> ofPoint;

    [[nodiscard]] StationView view() const { return {positions, ofPoint.empty() ? nullptr : ofPoint.data()}; }
};

/// @param path     as readStations() reads it; a survey's truth is such a file
/// @param sources  LAS point source id of each point; empty, or all 0: not known which point is whose
[[nodiscard]] SurveyStations surveyStations(const std::string& path, const Eigen::Vector3d& origin,
                                            const std::vector<std::uint16_t>& sources);

}  // namespace s2b
