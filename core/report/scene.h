// SPDX-License-Identifier: GPL-3.0-or-later
/// Both models side by side in one frame, and what the report says of each element: what all its parts are made from.
#pragma once

#include "core/report/report.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <vector>

namespace s2b::report
{

/// How a plan draws an element: one style per row, told apart by colour and by pattern.
enum class Style
{
    Within,
    OutOfTolerance,
    Missed,
    FalsePositive,
    NoData,
    NotSeen
};

/// One row of the report: a pair, or an element without a partner.
struct Row
{
    int number = 0;  ///< 1 is the worst
    validation::ElementResult pair;
    const validation::BimElement* truth = nullptr;
    const validation::BimElement* result = nullptr;
    const validation::Deviation* toTruth = nullptr;   ///< null without points
    const validation::Deviation* toResult = nullptr;  ///< null without points or without a result element
    validation::Verdict verdict = validation::Verdict::NoData;
    validation::LoaBand band = validation::LoaBand::NoData;
    std::optional<double> error_m;  ///< what the verdict was made from: p95 of the points, or the largest error in size
                                    ///< and place
    std::string reason;             ///< of the verdict, for people
    std::string id;                 ///< GUID, or "wall 12 of truth.json" where the file has none
    std::string name;
    std::string storey;
    int level = -1;  ///< in Scene::levels
    Style style = Style::Within;

    /// The result's element where there is one, else the truth's.
    [[nodiscard]] const validation::BimElement& element() const { return result ? *result : *truth; }
};

/// A storey of the truth and the result's that goes with it.
struct Level
{
    std::string name;
    double elevation_m = 0.0;  ///< in the scene's frame
    double ceiling_m = 0.0;    ///< of its walls: the median of their tops
    int truth = -1;
    int result = -1;
    bool isSurveyed = true;
    std::vector<std::size_t> rows;
};

struct Scene
{
    Eigen::Vector3d base = Eigen::Vector3d::Zero();         ///< world coordinates of the scene's zero
    Eigen::Vector3d truthShift = Eigen::Vector3d::Zero();   ///< adds to the truth's coordinates
    Eigen::Vector3d resultShift = Eigen::Vector3d::Zero();  ///< adds to the result's
    std::vector<Level> levels;
    std::vector<Row> rows;          ///< worst first
    std::vector<int> rowOfResult;   ///< by element of the result; -1 for none
    double toleranceLimit_m = 0.0;  ///< of the LOA to keep
    double colorRange_m = 0.0;      ///< the ends of the colour scale
    bool hasPoints = false;         ///< deviations were measured
    bool hasTruth = false;

    [[nodiscard]] Eigen::Vector3d shiftOf(const Row& row) const { return row.result ? resultShift : truthShift; }
};

/// "out of tolerance" ...
[[nodiscard]] const char* verdictName(validation::Verdict verdict);
/// "false positive" ...
[[nodiscard]] const char* outcomeName(validation::Outcome outcome);
/// "wall" -> "Walls"
[[nodiscard]] std::string pluralName(validation::ElementClass elementClass);

/// Index in ValidationParams::loaLimit_m of the LOA that has to be kept.
[[nodiscard]] std::size_t toleranceIndex(const validation::ValidationParams& params);
/// The best band whose limit this keeps.
[[nodiscard]] validation::LoaBand bandOf(double error_m, const validation::ValidationParams& params);

/// Rows, worst first. The verdict of a row is that of the points where there are any, else of the errors against the
/// truth; an element that is missed or that has no truth is out of tolerance.
[[nodiscard]] Scene makeScene(const ReportInput& input);

}  // namespace s2b::report
