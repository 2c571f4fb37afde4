// SPDX-License-Identifier: GPL-3.0-or-later
/// A reconstruction (or any BIM) measured against a ground-truth BIM and against the points; definitions with their
/// sources in docs/validation.md.
#pragma once

#include "core/base/context.h"
#include "core/cloud/point_cloud.h"
#include "core/validation/bim.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace s2b::validation
{

/// Accuracy bands of the USIBD Level of Accuracy specification: the best band whose limit a deviation keeps.
enum class LoaBand
{
    NoData,
    Beyond,  ///< worse than LOA10
    Loa10,
    Loa20,
    Loa30,
    Loa40,
    Loa50
};

[[nodiscard]] const char* loaName(LoaBand band);

struct ValidationParams
{
    double deviationRange_m = 0.20;  ///< points farther from every element are not of the building (D3.6, 6.3)
    double minimumCoverage = 0.10;   ///< share of an element's surface with points from which it counts as seen
    double minimumMatch = 0.25;      ///< IoU from which a pair is a match in deviations of position and size
    int tolerance = 30;              ///< the LOA that an element has to keep: 10, 20, 30, 40 or 50
    std::array<double, 5> loaLimit_m{0.15, 0.05, 0.015, 0.005, 0.001};  ///< LOA10 ... LOA50, 95 % (USIBD C120)
    bool operator==(const ValidationParams&) const = default;
};

/// What became of a truth element, or of a result element.
enum class Outcome
{
    Matched,        ///< IoU at least minimumMatch
    Missed,         ///< of the truth: seen, but nothing stands there
    NotSeen,        ///< of the truth: the cloud has too few points on it; asked of nobody
    FalsePositive,  ///< of the result: no truth there
    Excused         ///< of the result: stands where the truth has an element that was not seen enough
};

enum class Verdict
{
    Within,
    OutOfTolerance,
    NoData
};

/// One pair, or one element without a partner.
struct ElementResult
{
    ElementClass elementClass = ElementClass::Wall;
    Outcome outcome = Outcome::Matched;
    int truth = -1;   ///< index in the truth's elements, -1 for none
    int result = -1;  ///< index in the result's elements, -1 for none
    double iou = 0.0;
    std::optional<double> centroid_m;        ///< distance of the centres
    std::optional<double> thicknessError_m;  ///< result - truth
    std::optional<double> heightError_m;     ///< result - truth
    std::optional<double> axisEnd_m;         ///< the larger distance of the axes' ends
};

struct Rates
{
    double precision = 0.0;
    double recall = 0.0;
    double f1 = 0.0;
};

/// Of one class.
struct ClassScore
{
    int truthCount = 0;   ///< that counts
    int resultCount = 0;  ///< without the excused
    int notSeenCount = 0;
    std::optional<double> iou;           ///< mean over the truth, an element without a partner counts 0 (D3.6, 4.3)
    double iouMatched = 0.0;             ///< mean over the pairs
    std::optional<double> iouFull;       ///< as iou, over the whole modelled heights
    std::optional<double> iouNearest;    ///< as iou, the partner being the result with the nearest centre
    std::optional<double> iouBothSides;  ///< walls seen from both sides
    int bothSidesCount = 0;
    Rates at25;  ///< at IoU 0.25
    Rates at50;
    std::optional<double> volumetricIou;     ///< walls: union of all against union of all
    std::optional<double> centroid_m;        ///< mean of the matched pairs
    std::optional<double> thicknessError_m;  ///< median absolute, walls seen from both sides
    std::optional<double> heightError_m;     ///< median absolute
    std::optional<double> axisEnd_m;         ///< median
    std::map<int, Rates> cornersAt;          ///< CV4AEC: by distance in cm (5, 10, 20), of walls only
};

/// How the points lie about the surfaces of one BIM's elements.
struct Deviation
{
    int element = -1;             ///< index in the elements of the BIM that was measured
    std::uint64_t points = 0;     ///< whose nearest surface it is, within deviationRange_m
    double meanAbsolute_m = 0.0;  ///< D3.6, 6.3
    double meanSigned_m = 0.0;    ///< > 0: points outside the element
    double median_m = 0.0;        ///< of the absolute distances
    double rms_m = 0.0;
    double p95_m = 0.0;
    double coverage = 0.0;  ///< [0, 1] share of its visible surface with points
    LoaBand band = LoaBand::NoData;
    Verdict verdict = Verdict::NoData;
};

struct CloudDeviation
{
    std::vector<Deviation> elements;                ///< one per element of the BIM, in its order
    std::map<ElementClass, double> meanAbsolute_m;  ///< by class, points weighted
    double wallMeanAbsolute_m = 0.0;                ///< the figure of D3.6, 6.3
    std::vector<float> distance_m;      ///< one per point, signed; NaN beyond the range. Empty where not asked for
    std::vector<std::int32_t> element;  ///< one per point: index of the nearest element, -1 for none. Empty likewise
    std::array<std::uint64_t, 64> histogram{};  ///< of signed distances over [-range, range]
};

struct StoreyError
{
    int truth = -1;
    int result = -1;       ///< -1: missed
    double error_m = 0.0;  ///< absolute
};

struct Validation
{
    std::map<ElementClass, ClassScore> scores;
    std::vector<ElementResult> elements;  ///< truth in its order, then result elements without a partner
    std::optional<double> meanIou;        ///< mean of the wall, door and column IoU that there are
    std::vector<StoreyError> storeys;
    int extraStoreys = 0;
    std::optional<CloudDeviation> cloudToTruth;
    std::optional<CloudDeviation> cloudToResult;
};

/// Compares a result with the truth, and both with the points when there are any.
///
/// @param cloud  may be null: then nothing is said of deviations, and truth without a Visibility counts as seen.
/// @throws Error{BadFile} when the two do not overlap (names both files and the distance); Cancelled.
/// Cost: see docs/validation.md; twice that of measureDeviation.
/// Deterministic for any number of threads.
[[nodiscard]] Validation validate(const Bim& truth, const Bim& result, const CloudView* cloud,
                                  const ValidationParams& params, const Context& context);

/// The points' distances to one BIM's surfaces (D3.6, 6.3), also without a truth.
///
/// With labels, points are compared with elements of their own class, and of classes that the labels don't tell apart.
/// Deterministic for any number of threads. A stop is looked for every 16384 points.
/// Cost: some 0.3 us of processor time per point; 14 bytes per point beyond the cloud, 8 more for perPoint.
/// @throws Error{BadParameter}; Cancelled.
[[nodiscard]] CloudDeviation measureDeviation(const Bim& bim, const CloudView& cloud, const ValidationParams& params,
                                              bool perPoint, const Context& context);

}  // namespace s2b::validation
