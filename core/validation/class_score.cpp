// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/class_score.h"

#include "core/geometry/rectangle.h"
#include "core/validation/corners.h"
#include "core/validation/matching.h"
#include "core/validation/prism.h"
#include "core/validation/statistics.h"
#include "core/validation/union_volume.h"

#include <cmath>
#include <limits>

namespace s2b::validation
{

namespace
{

/// From these shares on, a result without a partner is taken for a truth element that was not seen enough.
constexpr double kSameElement = 0.25;  // IoU
constexpr double kInside = 0.5;        // of the smaller one's volume

/// Elements of one class in the truth's frame.
struct Group
{
    std::vector<int> index;  ///< in Bim::elements
    std::vector<Prism> prisms;

    void add(const Bim& bim, int element, const Eigen::Vector3d& shift)
    {
        index.push_back(element);
        prisms.push_back(prismOf(bim.elements[static_cast<std::size_t>(element)], shift));
    }
    [[nodiscard]] std::size_t size() const { return index.size(); }
};

double shortSide(const Polygon& plan)
{
    return 2.0 * minimumRectangle(plan.outer).half.y();
}

/// A pair with its scores.
struct Pair
{
    int truth = 0;  ///< in the groups
    int result = 0;
    double iou = 0.0;
    double fullIou = 0.0;
};

/// The CV4AEC challenge's files hold nothing but walls, doors and columns: whatever else a result has is not wrong.
bool isKnownTo(const Bim& truth, ElementClass elementClass)
{
    return truth.schema != "CV4AEC" || elementClass == ElementClass::Wall || elementClass == ElementClass::Door ||
           elementClass == ElementClass::Column;
}

class Comparison
{
public:
    Comparison(ElementClass elementClass, const Bim& truth, const Bim& result, const ValidationParams& params)
        : m_class(elementClass), m_truth(truth), m_result(result), m_params(params)
    {
        const Eigen::Vector3d shift = result.origin - truth.origin;
        for (int i = 0; i < static_cast<int>(truth.elements.size()); ++i)
        {
            const BimElement& e = truth.elements[static_cast<std::size_t>(i)];
            if (e.elementClass == elementClass)
                (isAskedFor(truth, e) ? m_counted : m_ignored).add(truth, i, Eigen::Vector3d::Zero());
        }
        Group all;
        for (int i = 0; i < static_cast<int>(result.elements.size()); ++i)
            if (result.elements[static_cast<std::size_t>(i)].elementClass == elementClass)
                all.add(result, i, shift);
        dropExcused(std::move(all));
        match();
    }

    [[nodiscard]] ClassComparison take()
    {
        score();
        list();
        return std::move(m_comparison);
    }

private:
    /// Results that are nothing of the counted truth but are, or are part of, something that was not seen enough.
    void dropExcused(Group&& all)
    {
        const std::vector<Overlap> counted = overlapsOf(m_counted.prisms, all.prisms);
        const std::vector<Overlap> ignored = overlapsOf(m_ignored.prisms, all.prisms);
        std::vector<bool> isOne(all.size(), false);
        std::vector<bool> isExcused(all.size(), !isKnownTo(m_truth, m_class));
        for (std::size_t j = 0; j < all.size(); ++j)
            if (const int storey = storeyAt(m_truth, all.prisms[j].center.z()); storey >= 0)
                isExcused[j] = isExcused[j] || !m_truth.storeys[static_cast<std::size_t>(storey)].isChosen;
        for (const Overlap& o : counted)
        {
            const auto j = static_cast<std::size_t>(o.result);
            if (fullIou(m_counted.prisms[static_cast<std::size_t>(o.truth)], all.prisms[j], o.area_m2) >= kSameElement)
                isOne[j] = true;
        }
        for (const Overlap& o : ignored)
        {
            const auto j = static_cast<std::size_t>(o.result);
            const Prism& a = m_ignored.prisms[static_cast<std::size_t>(o.truth)];
            const Prism& b = all.prisms[j];
            if (!isOne[j] && (fullIou(a, b, o.area_m2) >= kSameElement || shareInside(b, a, o.area_m2) >= kInside ||
                              shareInside(a, b, o.area_m2) >= kInside))
                isExcused[j] = true;
        }
        std::vector<int> kept(all.size(), -1);
        for (std::size_t j = 0; j < all.size(); ++j)
        {
            if (isExcused[j])
            {
                m_excused.push_back(all.index[j]);
                continue;
            }
            kept[j] = static_cast<int>(m_found.size());
            m_found.index.push_back(all.index[j]);
            m_found.prisms.push_back(std::move(all.prisms[j]));
        }
        for (Overlap o : counted)
        {
            o.result = kept[static_cast<std::size_t>(o.result)];
            if (o.result >= 0)
                m_overlaps.push_back(o);
        }
    }

    [[nodiscard]] const Prism& truthPrism(int i) const { return m_counted.prisms[static_cast<std::size_t>(i)]; }
    [[nodiscard]] const Prism& resultPrism(int j) const { return m_found.prisms[static_cast<std::size_t>(j)]; }
    [[nodiscard]] const BimElement& truthElement(int i) const
    {
        return m_truth.elements[static_cast<std::size_t>(m_counted.index[static_cast<std::size_t>(i)])];
    }
    [[nodiscard]] const BimElement& resultElement(int j) const
    {
        return m_result.elements[static_cast<std::size_t>(m_found.index[static_cast<std::size_t>(j)])];
    }

    void match()
    {
        std::vector<Candidate> candidates;
        for (const Overlap& o : m_overlaps)
        {
            const double iou = seenIou(truthPrism(o.truth), resultPrism(o.result), o.area_m2);
            if (iou > 0.0)
                candidates.push_back({o.truth, o.result, iou});
        }
        for (const auto& [i, j] : assign(candidates))
            for (const Overlap& o : m_overlaps)
                if (o.truth == i && o.result == j)
                    m_pairs.push_back({i, j, seenIou(truthPrism(i), resultPrism(j), o.area_m2),
                                       fullIou(truthPrism(i), resultPrism(j), o.area_m2)});
    }

    /// Mean IoU when the partner is the result with the nearest centre.
    [[nodiscard]] double nearestIou() const
    {
        double sum = 0.0;
        for (int i = 0; i < static_cast<int>(m_counted.size()); ++i)
        {
            int nearest = 0;
            double best = std::numeric_limits<double>::infinity();
            for (int j = 0; j < static_cast<int>(m_found.size()); ++j)
            {
                const double d = (truthPrism(i).center - resultPrism(j).center).norm();
                if (d < best)
                {
                    best = d;
                    nearest = j;
                }
            }
            for (const Overlap& o : m_overlaps)
                if (o.truth == i && o.result == nearest)
                    sum += seenIou(truthPrism(i), resultPrism(nearest), o.area_m2);
        }
        return sum / static_cast<double>(m_counted.size());
    }

    [[nodiscard]] bool isBothSidesSeen(int i) const
    {
        const BimElement& e = truthElement(i);
        return m_class == ElementClass::Wall && (!e.visibility || e.visibility->isBothSidesSeen);
    }

    void score()
    {
        ClassScore& s = m_comparison.score;
        const auto truths = static_cast<double>(m_counted.size());
        s.truthCount = static_cast<int>(m_counted.size());
        s.resultCount = static_cast<int>(m_found.size());
        s.notSeenCount = static_cast<int>(m_ignored.size());
        std::vector<double> ious, heights, centers, thicknesses, ends;
        std::size_t at25 = 0, at50 = 0;
        double sumFull = 0.0, sumBoth = 0.0;
        for (const Pair& p : m_pairs)
        {
            const ElementResult r = resultOf(p);
            ious.push_back(p.iou);
            sumFull += p.fullIou;
            at25 += p.iou >= 0.25 ? 1 : 0;
            at50 += p.iou >= 0.5 ? 1 : 0;
            heights.push_back(std::abs(*r.heightError_m));
            const bool both = isBothSidesSeen(p.truth);
            sumBoth += both ? p.iou : 0.0;
            if (p.iou < m_params.minimumMatch)
                continue;
            centers.push_back(*r.centroid_m);
            if (both && r.thicknessError_m)
                thicknesses.push_back(std::abs(*r.thicknessError_m));
            if (r.axisEnd_m)
                ends.push_back(*r.axisEnd_m);
        }
        for (int i = 0; i < s.truthCount; ++i)
            s.bothSidesCount += isBothSidesSeen(i) ? 1 : 0;
        s.iouMatched = meanOf(ious).value_or(0.0);
        if (s.truthCount > 0)
        {
            s.iou = s.iouMatched * static_cast<double>(ious.size()) / truths;
            s.iouFull = sumFull / truths;
            if (s.resultCount > 0)
                s.iouNearest = nearestIou();
        }
        if (s.bothSidesCount > 0)
            s.iouBothSides = sumBoth / s.bothSidesCount;
        s.at25 = ratesOf(at25, m_counted.size(), m_found.size());
        s.at50 = ratesOf(at50, m_counted.size(), m_found.size());
        s.centroid_m = meanOf(centers);
        s.heightError_m = medianOf(heights);
        s.thicknessError_m = medianOf(thicknesses);
        s.axisEnd_m = medianOf(ends);
        if (m_class == ElementClass::Wall)
        {
            s.volumetricIou = unionIou(bodies(m_truth, m_counted), bodies(m_result, m_found));
            s.cornersAt = cornerRates(m_counted.prisms, m_found.prisms);
        }
    }

    /// With their real outlines where they are known.
    [[nodiscard]] std::vector<Body> bodies(const Bim& bim, const Group& group) const
    {
        const Eigen::Vector3d shift = bim.origin - m_truth.origin;
        std::vector<Body> result;
        for (std::size_t i = 0; i < group.size(); ++i)
        {
            const BimElement& e = bim.elements[static_cast<std::size_t>(group.index[i])];
            Body body;
            body.low_m = group.prisms[i].low_m;
            body.high_m = group.prisms[i].high_m;
            for (const Polygon& p : e.footprint)
                body.plan.push_back(moved(p, shift.head<2>()));
            if (body.plan.empty())
                body.plan.push_back(group.prisms[i].plan);
            result.push_back(std::move(body));
        }
        return result;
    }

    [[nodiscard]] ElementResult resultOf(const Pair& pair) const
    {
        const BimElement& a = truthElement(pair.truth);
        const BimElement& b = resultElement(pair.result);
        ElementResult r;
        r.elementClass = m_class;
        r.outcome = pair.iou >= m_params.minimumMatch ? Outcome::Matched : Outcome::Missed;
        r.truth = m_counted.index[static_cast<std::size_t>(pair.truth)];
        r.result = m_found.index[static_cast<std::size_t>(pair.result)];
        r.iou = pair.iou;
        r.centroid_m = (truthPrism(pair.truth).center - resultPrism(pair.result).center).norm();
        r.heightError_m = (b.high_m - b.low_m) - (a.high_m - a.low_m);
        if (m_class == ElementClass::Wall && a.axis)
            r.thicknessError_m = shortSide(b.plan) - a.axis->thickness_m;
        if (a.axis && b.axis)
            r.axisEnd_m = axisEnd(*a.axis, *b.axis);
        return r;
    }

    [[nodiscard]] double axisEnd(const WallAxis& a, const WallAxis& b) const
    {
        const Eigen::Vector2d shift = (m_result.origin - m_truth.origin).head<2>();
        const Eigen::Vector2d start = b.start + shift;
        const Eigen::Vector2d end = b.end + shift;
        const double same = std::max((a.start - start).norm(), (a.end - end).norm());
        const double turned = std::max((a.start - end).norm(), (a.end - start).norm());
        return std::min(same, turned);
    }

    /// An element without a partner.
    [[nodiscard]] ElementResult alone(Outcome outcome, int truth, int result) const
    {
        ElementResult r;
        r.elementClass = m_class;
        r.outcome = outcome;
        r.truth = truth;
        r.result = result;
        return r;
    }

    void list()
    {
        std::vector<bool> isUsed(m_found.size(), false);
        std::vector<ElementResult> counted(m_counted.size());
        for (std::size_t i = 0; i < m_counted.size(); ++i)
        {
            counted[i] = alone(Outcome::Missed, m_counted.index[i], -1);
        }
        for (const Pair& p : m_pairs)
        {
            const ElementResult r = resultOf(p);
            if (r.outcome != Outcome::Matched)
                continue;  // too little in common to call it the same element: one missed, one too many
            isUsed[static_cast<std::size_t>(p.result)] = true;
            counted[static_cast<std::size_t>(p.truth)] = r;
        }
        m_comparison.truth = std::move(counted);
        for (const int index : m_ignored.index)
            m_comparison.truth.push_back(alone(Outcome::NotSeen, index, -1));
        std::sort(m_comparison.truth.begin(), m_comparison.truth.end(),
                  [](const ElementResult& a, const ElementResult& b) { return a.truth < b.truth; });
        for (std::size_t j = 0; j < m_found.size(); ++j)
            if (!isUsed[j])
                m_comparison.others.push_back(alone(Outcome::FalsePositive, -1, m_found.index[j]));
        for (const int index : m_excused)
            m_comparison.others.push_back(alone(Outcome::Excused, -1, index));
        std::sort(m_comparison.others.begin(), m_comparison.others.end(),
                  [](const ElementResult& a, const ElementResult& b) { return a.result < b.result; });
    }

    ElementClass m_class;
    const Bim& m_truth;
    const Bim& m_result;
    const ValidationParams& m_params;
    Group m_counted;
    Group m_ignored;
    Group m_found;
    std::vector<int> m_excused;
    std::vector<Overlap> m_overlaps;  ///< of the counted truth and the found
    std::vector<Pair> m_pairs;
    ClassComparison m_comparison;
};

}  // namespace

bool isAskedFor(const Bim& truth, const BimElement& element)
{
    if (element.visibility && !element.visibility->counts)
        return false;
    return element.storey < 0 || truth.storeys[static_cast<std::size_t>(element.storey)].isSurveyed;
}

ClassComparison compareClass(ElementClass elementClass, const Bim& truth, const Bim& result,
                             const ValidationParams& params)
{
    return Comparison(elementClass, truth, result, params).take();
}

}  // namespace s2b::validation
