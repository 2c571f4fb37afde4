// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/visibility.h"

#include "core/geometry/rectangle.h"
#include "core/validation/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace s2b::validation
{

namespace
{

constexpr double kSideFactor = 3.0;  ///< a wall's side, in terms of minimumCoverage: it can be seen as a whole
constexpr double kFacing = 0.9;      ///< cosine
constexpr double kAround_m = 0.4;    ///< of an opening
constexpr double kLeastAround_m2 = 0.1;
constexpr double kLeastBand_m = 0.3;  ///< of a wall or column between floor and ceiling
constexpr double kFloor_m = 0.35;     ///< a storey's floor lies so near to its elevation
constexpr double kLeastFloor_m2 = 1.0;

struct Share
{
    double seen_m2 = 0.0;
    double all_m2 = 0.0;

    void add(const SurfaceSurvey& survey, std::size_t cell)
    {
        const auto area = static_cast<double>(survey.cells[cell].area_m2);
        all_m2 += area;
        seen_m2 += survey.isSeen[cell] != 0 ? area : 0.0;
    }
    [[nodiscard]] double value() const { return all_m2 > 0.0 ? seen_m2 / all_m2 : 0.0; }
};

class Judge
{
public:
    Judge(Bim& truth, const SurfaceSurvey& survey, const ValidationParams& params)
        : m_truth(truth), m_survey(survey), m_least(params.minimumCoverage), m_cells(truth.elements.size())
    {
        for (std::size_t c = 0; c < survey.cells.size(); ++c)
            if (survey.isHidden[c] == 0)
                m_cells[static_cast<std::size_t>(survey.cells[c].element)].push_back(c);
    }

    void run()
    {
        std::vector<bool> isOurs(m_truth.elements.size());
        for (std::size_t e = 0; e < m_truth.elements.size(); ++e)
        {
            isOurs[e] = !m_truth.elements[e].visibility.has_value();
            if (isOurs[e])
                m_truth.elements[e].visibility = judge(e);
        }
        std::vector<bool> isStoreyOurs(m_truth.storeys.size(), true);
        for (std::size_t e = 0; e < m_truth.elements.size(); ++e)
            if (m_truth.elements[e].storey >= 0 && !isOurs[e])
                isStoreyOurs[static_cast<std::size_t>(m_truth.elements[e].storey)] = false;
        for (std::size_t s = 0; s < m_truth.storeys.size(); ++s)
            if (isStoreyOurs[s])
                judgeStorey(static_cast<int>(s));
    }

private:
    [[nodiscard]] Visibility judge(std::size_t e) const
    {
        const BimElement& element = m_truth.elements[e];
        Visibility v;
        if (element.elementClass == ElementClass::Space)
            return v;
        Share whole;
        for (const std::size_t c : m_cells[e])
            whole.add(m_survey, c);
        v.counts = whole.value() >= m_least;
        if (element.elementClass == ElementClass::Wall && element.axis)
        {
            const auto [left, right] = sides(e, *element.axis);
            const double needed = std::min(1.0, kSideFactor * m_least);
            v.counts = std::max(left, right) >= needed;
            v.isBothSidesSeen = std::min(left, right) >= needed;
        }
        else if (element.host >= 0)
        {
            const Share around = shareAround(element);
            v.counts = around.value() >= m_least && around.seen_m2 >= kLeastAround_m2;
        }
        return v;
    }

    [[nodiscard]] std::pair<double, double> sides(std::size_t e, const WallAxis& axis) const
    {
        const Eigen::Vector2d u = (axis.end - axis.start).normalized();
        const Eigen::Vector2d normal(-u.y(), u.x());
        Share left;
        Share right;
        for (const std::size_t c : m_cells[e])
        {
            const double facing = m_survey.cells[c].normal.head<2>().cast<double>().dot(normal);
            if (std::abs(facing) > kFacing)
                (facing > 0.0 ? left : right).add(m_survey, c);
        }
        return {left.value(), right.value()};
    }

    /// Of the wall that a door or window is in.
    [[nodiscard]] Share shareAround(const BimElement& opening) const
    {
        const auto host = static_cast<std::size_t>(opening.host);
        OrientedRectangle plan = minimumRectangle(opening.plan.outer);
        if (m_truth.elements[host].axis)
            plan = rectangleAlong(opening.plan.outer,
                                  m_truth.elements[host].axis->end - m_truth.elements[host].axis->start);
        Share share;
        for (const std::size_t c : m_cells[host])
        {
            const Eigen::Vector3d p = m_survey.cells[c].center.cast<double>();
            if (plan.contains(p.head<2>(), kAround_m) && p.z() > opening.low_m - kAround_m &&
                p.z() < opening.high_m + kAround_m)
                share.add(m_survey, c);
        }
        return share;
    }

    void judgeStorey(int storey)
    {
        bool isSurveyed = false;
        bool hasBody = false;
        std::vector<double> lows;
        std::vector<double> highs;
        for (std::size_t e = 0; e < m_truth.elements.size(); ++e)
        {
            const BimElement& element = m_truth.elements[e];
            const bool isBody =
                element.elementClass == ElementClass::Wall || element.elementClass == ElementClass::Column;
            if (element.storey != storey || !isBody)
                continue;
            hasBody = true;
            if (!element.visibility->counts)
                continue;
            isSurveyed = true;
            if (const auto reach = reachOf(e))
            {
                lows.push_back(reach->first);
                highs.push_back(reach->second);
            }
        }
        if (const Share floor = floorOf(storey); floor.all_m2 >= kLeastFloor_m2)
            isSurveyed = floor.value() >= m_least || wallsOf(storey).value() >= kSideFactor * m_least;
        else if (!hasBody)
            isSurveyed = true;
        m_truth.storeys[static_cast<std::size_t>(storey)].isSurveyed &= isSurveyed;
        const auto low = medianOf(std::move(lows));
        const auto high = medianOf(std::move(highs));
        if (!low || !high)
            return;
        for (BimElement& element : m_truth.elements)
        {
            if (element.storey != storey ||
                (element.elementClass != ElementClass::Wall && element.elementClass != ElementClass::Column))
                continue;
            element.visibility->bandLow_m = low;
            element.visibility->bandHigh_m = high;
            if (std::min(element.high_m, *high) - std::max(element.low_m, *low) < kLeastBand_m)
                element.visibility->counts = false;
        }
    }

    /// What slabs show upwards at a storey's elevation.
    [[nodiscard]] Share floorOf(int storey) const
    {
        const double elevation = m_truth.storeys[static_cast<std::size_t>(storey)].elevation_m;
        Share share;
        for (std::size_t e = 0; e < m_truth.elements.size(); ++e)
            if (m_truth.elements[e].elementClass == ElementClass::Slab)
                for (const std::size_t c : m_cells[e])
                    if (static_cast<double>(m_survey.cells[c].normal.z()) > kFacing &&
                        std::abs(static_cast<double>(m_survey.cells[c].center.z()) - elevation) < kFloor_m)
                        share.add(m_survey, c);
        return share;
    }

    /// All upright faces of its walls.
    [[nodiscard]] Share wallsOf(int storey) const
    {
        Share share;
        for (std::size_t e = 0; e < m_truth.elements.size(); ++e)
            if (m_truth.elements[e].storey == storey && m_truth.elements[e].elementClass == ElementClass::Wall)
                for (const std::size_t c : m_cells[e])
                    if (std::abs(m_survey.cells[c].normal.z()) < 0.5F)
                        share.add(m_survey, c);
        return share;
    }

    /// Where the points on an upright element typically begin and end, column of cells by column of cells.
    [[nodiscard]] std::optional<std::pair<double, double>> reachOf(std::size_t e) const
    {
        std::map<int, std::pair<double, double>> columns;
        for (const std::size_t c : m_cells[e])
        {
            if (m_survey.isSeen[c] == 0 || std::abs(m_survey.cells[c].normal.z()) > 0.5F)
                continue;
            constexpr double kInfinite = std::numeric_limits<double>::infinity();
            auto& reach = columns.try_emplace(m_survey.cells[c].column, kInfinite, -kInfinite).first->second;
            reach.first = std::min(reach.first, static_cast<double>(m_survey.lowest_m[c]));
            reach.second = std::max(reach.second, static_cast<double>(m_survey.highest_m[c]));
        }
        std::vector<double> lows;
        std::vector<double> highs;
        for (const auto& [column, reach] : columns)
        {
            lows.push_back(reach.first);
            highs.push_back(reach.second);
        }
        const auto low = medianOf(std::move(lows));
        const auto high = medianOf(std::move(highs));
        if (!low || !high)
            return std::nullopt;
        return std::pair(*low, *high);
    }

    Bim& m_truth;
    const SurfaceSurvey& m_survey;
    double m_least;
    std::vector<std::vector<std::size_t>> m_cells;  ///< visible ones, by element
};

}  // namespace

void judgeVisibility(Bim& truth, const SurfaceSurvey& survey, const ValidationParams& params)
{
    Judge(truth, survey, params).run();
}

}  // namespace s2b::validation
