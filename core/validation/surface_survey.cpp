// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/surface_survey.h"

#include "core/base/parallel.h"
#include "core/labels/label.h"
#include "core/validation/loa.h"
#include "core/validation/surface_search.h"
#include "core/validation/validation_parameters.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>

namespace s2b::validation
{

namespace
{

constexpr std::size_t kChunk = 16384;  ///< points: some 10 ms
constexpr std::size_t kCellChunk = 4096;
constexpr std::size_t kClasses = 6;
constexpr std::size_t kBins = 2000;  ///< of an element's distances: 0.1 mm of 0.20 m
constexpr float kTouching_m = 0.01F;
constexpr float kFacing = 0.7F;  ///< cosine: a point is on a face, not beside it
constexpr double kMicro = 1e6;   ///< sums are whole micrometres, so that their order does not matter

/// The elements that points of a label are compared with; nothing: points of it lie on no element.
std::optional<ElementClass> classOfLabel(Label label)
{
    switch (label)
    {
        case Label::Wall:
            return ElementClass::Wall;
        case Label::Column:
            return ElementClass::Column;
        case Label::Door:
            return ElementClass::Door;
        case Label::Window:
            return ElementClass::Window;
        case Label::Floor:
        case Label::Ceiling:
        case Label::Roof:
            return ElementClass::Slab;
        default:
            return std::nullopt;
    }
}

struct Sums
{
    std::uint64_t points = 0;
    std::uint64_t absolute = 0;
    std::int64_t side = 0;
    std::uint64_t squares = 0;

    void add(const Sums& other)
    {
        points += other.points;
        absolute += other.absolute;
        side += other.side;
        squares += other.squares;
    }
};

/// What one thread gathers; whole numbers, so that it does not matter which thread gathered what.
struct Gathered
{
    std::vector<Sums> elements;
    std::array<std::uint64_t, 64> histogram{};
};

/// Lends each thread a Gathered of its own.
class Gatherers
{
public:
    explicit Gatherers(std::size_t elements) : m_elements(elements) {}

    std::unique_ptr<Gathered> take()
    {
        const std::lock_guard lock(m_mutex);
        if (m_free.empty())
        {
            auto one = std::make_unique<Gathered>();
            one->elements.resize(m_elements);
            return one;
        }
        auto one = std::move(m_free.back());
        m_free.pop_back();
        return one;
    }
    void giveBack(std::unique_ptr<Gathered> one)
    {
        const std::lock_guard lock(m_mutex);
        m_free.push_back(std::move(one));
    }
    [[nodiscard]] Gathered sum() const
    {
        Gathered total;
        total.elements.resize(m_elements);
        for (const auto& one : m_free)
        {
            for (std::size_t e = 0; e < m_elements; ++e)
                total.elements[e].add(one->elements[e]);
            for (std::size_t b = 0; b < total.histogram.size(); ++b)
                total.histogram[b] += one->histogram[b];
        }
        return total;
    }

private:
    std::size_t m_elements;
    std::mutex m_mutex;
    std::vector<std::unique_ptr<Gathered>> m_free;
};

template <class Better>
void improve(float& place, float value, Better better)
{
    const std::atomic_ref<float> atomic(place);
    float known = atomic.load(std::memory_order_relaxed);
    while (better(value, known) && !atomic.compare_exchange_weak(known, value, std::memory_order_relaxed))
    {
    }
}

class Surveyor
{
public:
    Surveyor(const Bim& bim, const CloudView& cloud, const ValidationParams& params, bool perPoint,
             const Context& context)
        : m_bim(bim),
          m_cloud(cloud),
          m_context(context),
          m_params(params),
          m_range(static_cast<float>(params.deviationRange_m)),
          m_triangles(surfaceOf(bim)),
          m_faces(m_triangles, context),
          m_all(m_triangles, indices([](ElementClass) { return true; })),
          m_counts(bim.elements.size() * kBins),
          m_gatherers(bim.elements.size())
    {
        if (cloud.labels != nullptr)
            prepareLabels();
        const std::size_t cells = m_faces.cells().size();
        m_survey.isSeen.assign(cells, 0);
        m_survey.isHidden.assign(cells, 0);
        m_survey.lowest_m.assign(cells, std::numeric_limits<float>::infinity());
        m_survey.highest_m.assign(cells, -std::numeric_limits<float>::infinity());
        if (perPoint)
        {
            m_survey.deviation.distance_m.assign(cloud.count, std::numeric_limits<float>::quiet_NaN());
            m_survey.deviation.element.assign(cloud.count, -1);
        }
    }

    SurfaceSurvey run()
    {
        parallelChunks(m_cloud.count, kChunk, m_context,
                       [&](std::size_t begin, std::size_t end) { measure(begin, end); });
        parallelChunks(m_faces.cells().size(), kCellChunk, m_context,
                       [&](std::size_t begin, std::size_t end) { findHidden(begin, end); });
        summarise();
        m_survey.cells = m_faces.cells();
        return std::move(m_survey);
    }

private:
    template <class Wanted>
    [[nodiscard]] std::vector<std::uint32_t> indices(Wanted wanted) const
    {
        std::vector<std::uint32_t> which;
        for (std::uint32_t t = 0; t < m_triangles.size(); ++t)
            if (wanted(m_bim.elements[static_cast<std::size_t>(m_triangles[t].element)].elementClass))
                which.push_back(t);
        return which;
    }

    /// Points of a class are compared with elements of it, and with those of classes that the labels don't tell apart.
    void prepareLabels()
    {
        std::array<std::atomic<bool>, kClasses> isUsed{};
        parallelChunks(m_cloud.count, kChunk, m_context,
                       [&](std::size_t begin, std::size_t end)
                       {
                           std::array<bool, 256> isThere{};
                           for (std::size_t i = begin; i < end; ++i)
                               isThere[m_cloud.labels[i]] = true;
                           for (std::size_t label = 0; label < isThere.size(); ++label)
                               if (const auto c = classOfLabel(static_cast<Label>(label)); c && isThere[label])
                                   isUsed[static_cast<std::size_t>(*c)] = true;
                       });
        const auto isUntold = [&](ElementClass e) { return !isUsed[static_cast<std::size_t>(e)]; };
        for (std::size_t c = 0; c < kClasses; ++c)
            if (isUsed[c])
                m_ofClass[c].emplace(m_triangles, indices([&](ElementClass e)
                                                          { return static_cast<std::size_t>(e) == c || isUntold(e); }));
        m_untold.emplace(m_triangles, indices(isUntold));
    }

    /// The surfaces that a point is compared with.
    [[nodiscard]] const SurfaceSearch& searchFor(std::size_t point) const
    {
        if (m_cloud.labels == nullptr)
            return m_all;
        const auto elementClass = classOfLabel(static_cast<Label>(m_cloud.labels[point]));
        return elementClass ? *m_ofClass[static_cast<std::size_t>(*elementClass)] : *m_untold;
    }

    void measure(std::size_t begin, std::size_t end)
    {
        const Eigen::Vector3d shift = m_cloud.origin - m_bim.origin;
        auto gathered = m_gatherers.take();
        for (std::size_t i = begin; i < end; ++i)
        {
            const float* xyz = m_cloud.xyz + 3 * i;
            const Eigen::Vector3f point = (Eigen::Vector3d(static_cast<double>(xyz[0]), static_cast<double>(xyz[1]),
                                                           static_cast<double>(xyz[2])) +
                                           shift)
                                              .cast<float>();
            Nearest nearest;
            if (point.allFinite() && searchFor(i).find(point, m_range, -1, nearest))
                take(i, point, nearest, *gathered);
        }
        m_gatherers.giveBack(std::move(gathered));
    }

    void take(std::size_t i, const Eigen::Vector3f& point, const Nearest& nearest, Gathered& gathered)
    {
        const SurfaceTriangle& triangle = m_triangles[nearest.triangle];
        const auto e = static_cast<std::size_t>(triangle.element);
        const auto micrometres = std::llround(static_cast<double>(nearest.signed_m) * kMicro);
        const auto absolute = static_cast<std::uint64_t>(std::abs(micrometres));
        gathered.elements[e].add({1, absolute, micrometres, absolute * absolute});

        const double share = static_cast<double>(nearest.distance_m) / m_params.deviationRange_m;
        const auto bin = std::min(kBins - 1, static_cast<std::size_t>(share * static_cast<double>(kBins)));
        std::atomic_ref(m_counts[e * kBins + bin]).fetch_add(1, std::memory_order_relaxed);
        const auto bars = static_cast<double>(gathered.histogram.size());
        const double bar = (static_cast<double>(nearest.signed_m) / m_params.deviationRange_m + 1.0) * 0.5 * bars;
        ++gathered.histogram[static_cast<std::size_t>(std::clamp(bar, 0.0, bars - 1.0))];

        if (!m_survey.deviation.element.empty())
        {
            m_survey.deviation.distance_m[i] = nearest.signed_m;
            m_survey.deviation.element[i] = triangle.element;
        }
        if (std::abs(triangle.normal.dot(point - nearest.foot)) < kFacing * nearest.distance_m)
            return;
        const std::size_t cell = m_faces.cellAt(nearest.triangle, nearest.foot);
        std::atomic_ref(m_survey.isSeen[cell]).store(1, std::memory_order_relaxed);
        improve(m_survey.lowest_m[cell], nearest.foot.z(), std::less<>());
        improve(m_survey.highest_m[cell], nearest.foot.z(), std::greater<>());
    }

    /// A face that touches another element can't have points.
    void findHidden(std::size_t begin, std::size_t end)
    {
        for (std::size_t c = begin; c < end; ++c)
        {
            const FaceCells::Cell& cell = m_faces.cells()[c];
            Nearest nearest;
            if (cell.area_m2 > 0.0F && m_all.find(cell.center + kTouching_m * cell.normal, 0.3F, cell.element, nearest))
                m_survey.isHidden[c] = nearest.signed_m < 0.5F * kTouching_m ? 1 : 0;
        }
    }

    /// The distance that a share of an element's points keeps.
    [[nodiscard]] double quantile(std::size_t element, std::uint64_t points, double share) const
    {
        const double wanted = share * static_cast<double>(points);
        double below = 0.0;
        for (std::size_t b = 0; b < kBins; ++b)
        {
            const double count = m_counts[element * kBins + b];
            if (count > 0.0 && below + count >= wanted)
                return (static_cast<double>(b) + (wanted - below) / count) * m_params.deviationRange_m / kBins;
            below += count;
        }
        return m_params.deviationRange_m;
    }

    void summarise()
    {
        const Gathered total = m_gatherers.sum();
        CloudDeviation& d = m_survey.deviation;
        d.histogram = total.histogram;
        std::array<Sums, kClasses> ofClass{};
        for (std::size_t e = 0; e < m_bim.elements.size(); ++e)
        {
            const Sums& sums = total.elements[e];
            ofClass[static_cast<std::size_t>(m_bim.elements[e].elementClass)].add(sums);
            Deviation one;
            one.element = static_cast<int>(e);
            one.points = sums.points;
            if (sums.points > 0)
            {
                const auto n = static_cast<double>(sums.points);
                one.meanAbsolute_m = static_cast<double>(sums.absolute) / kMicro / n;
                one.meanSigned_m = static_cast<double>(sums.side) / kMicro / n;
                one.rms_m = std::sqrt(static_cast<double>(sums.squares) / n) / kMicro;
                one.median_m = quantile(e, sums.points, 0.5);
                one.p95_m = quantile(e, sums.points, 0.95);
            }
            d.elements.push_back(one);
        }
        coverage();
        for (Deviation& one : d.elements)
        {
            if (one.points == 0 || one.coverage < m_params.minimumCoverage)
                continue;
            one.band = bandOf(one.p95_m, m_params);
            one.verdict = keepsTolerance(one.p95_m, m_params) ? Verdict::Within : Verdict::OutOfTolerance;
        }
        for (std::size_t c = 0; c < kClasses; ++c)
            if (ofClass[c].points > 0)
                d.meanAbsolute_m[static_cast<ElementClass>(c)] =
                    static_cast<double>(ofClass[c].absolute) / kMicro / static_cast<double>(ofClass[c].points);
        if (const auto walls = d.meanAbsolute_m.find(ElementClass::Wall); walls != d.meanAbsolute_m.end())
            d.wallMeanAbsolute_m = walls->second;
    }

    void coverage()
    {
        std::vector<double> visible(m_bim.elements.size());
        std::vector<double> seen(m_bim.elements.size());
        for (std::size_t c = 0; c < m_faces.cells().size(); ++c)
        {
            const FaceCells::Cell& cell = m_faces.cells()[c];
            if (m_survey.isHidden[c] != 0)
                continue;
            const auto e = static_cast<std::size_t>(cell.element);
            visible[e] += static_cast<double>(cell.area_m2);
            seen[e] += m_survey.isSeen[c] != 0 ? static_cast<double>(cell.area_m2) : 0.0;
        }
        for (std::size_t e = 0; e < visible.size(); ++e)
            m_survey.deviation.elements[e].coverage = visible[e] > 0.0 ? seen[e] / visible[e] : 0.0;
    }

    const Bim& m_bim;
    const CloudView& m_cloud;
    const Context& m_context;
    const ValidationParams& m_params;
    float m_range;
    std::vector<SurfaceTriangle> m_triangles;
    FaceCells m_faces;
    SurfaceSearch m_all;
    std::array<std::optional<SurfaceSearch>, kClasses> m_ofClass;  ///< only with labels
    std::optional<SurfaceSearch> m_untold;                         ///< likewise
    std::vector<std::uint32_t> m_counts;                           ///< kBins per element
    Gatherers m_gatherers;
    SurfaceSurvey m_survey;
};

}  // namespace

SurfaceSurvey surveySurfaces(const Bim& bim, const CloudView& cloud, const ValidationParams& params, bool perPoint,
                             const Context& context)
{
    checkParams(params);
    return Surveyor(bim, cloud, params, perPoint, context).run();
}

CloudDeviation measureDeviation(const Bim& bim, const CloudView& cloud, const ValidationParams& params, bool perPoint,
                                const Context& context)
{
    return surveySurfaces(bim, cloud, params, perPoint, context).deviation;
}

}  // namespace s2b::validation
