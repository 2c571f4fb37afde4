// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/slabs/slab_outline.h"
#include "core/slabs/slabs.h"

#include <algorithm>
#include <cmath>
#include <format>
#include <optional>

namespace s2b
{
namespace
{

constexpr double kNear_m = 0.06;           // cells this near to a surface's height are on it
constexpr double kUndersideShare = 0.1;    // of a slab, for a ceiling below to say its thickness
constexpr double kRoofCeilingShare = 0.3;  // of a roof, whose underside was seen
constexpr double kAboveShare = 0.3;        // of a roof, where something of the next storey was seen
constexpr double kRoofWidth_m = 1.0;       // narrower remains between two storeys' outlines are their walls'

/// What was seen of a horizontal surface.
struct Surface
{
    struct Hit
    {
        std::uint32_t pixel = 0;
        std::uint32_t points = 0;
        float off_m = 0;  ///< height above the surface
        bool isLabelled = false;
    };
    std::vector<Hit> hits;  ///< a cell each
    PlanBits bits;
};

/// @param height  of the surface by pixel
Surface surfaceOf(const PlanCells& cells, const std::vector<float>& height, bool isFloor)
{
    Surface s;
    s.bits.assign(cells.grid.size(), 0);
    for (const PlanCell& c : cells.cells)
    {
        const float off = c.z - height[c.pixel];
        if (std::abs(off) >= static_cast<float>(kNear_m) || c.upward < 0.9f)
            continue;
        const bool fits = isFloor ? c.label == Label::Floor : c.label == Label::Ceiling || c.label == Label::Roof;
        if (cells.hasLabels && !fits && c.label != Label::Unassigned && c.label != Label::Beam)
            continue;
        s.bits[c.pixel] = 1;
        s.hits.push_back({c.pixel, c.count, off, cells.hasLabels && fits});
    }
    return s;
}

/// Heights of the rooms' floors or ceilings by pixel, the storey's elsewhere.
std::vector<float> heightsOf(const RoomPlan& plan, bool isFloor)
{
    std::vector<float> heights(plan.grid.size(),
                               static_cast<float>(isFloor ? plan.level.floor_m : plan.level.ceiling_m));
    for (const Room& room : plan.rooms)
        forEachPixel(room.outline, plan.grid,
                     [&](std::size_t i) { heights[i] = static_cast<float>(isFloor ? room.floor_m : room.ceiling_m); });
    return heights;
}

void addEvidence(Evidence& evidence, const Polygon& outline, const PlanGrid& grid, const Surface* top,
                 const Surface* underside)
{
    PlanBits inside(grid.size(), 0);
    std::size_t all = 0;
    forEachPixel(outline, grid, [&](std::size_t i) { inside[i] = 1, ++all; });
    double square = 0, labelled = 0;
    std::size_t side = 0;
    for (const Surface* s : {top, underside})
    {
        std::size_t seen = 0;
        if (s)
        {
            forEachPixel(outline, grid, [&](std::size_t i) { seen += s->bits[i]; });
            for (const Surface::Hit& h : s->hits)
                if (inside[h.pixel])
                {
                    evidence.points += h.points;
                    labelled += h.isLabelled ? h.points : 0;
                    square += static_cast<double>(h.points) * static_cast<double>(h.off_m * h.off_m);
                }
        }
        evidence.faceCoverage[side] = all ? static_cast<double>(seen) / static_cast<double>(all) : 0;
        evidence.facesSeen += evidence.faceCoverage[side] > kUndersideShare;
        ++side;
    }
    if (evidence.points)
    {
        evidence.rms_m = std::sqrt(square / static_cast<double>(evidence.points));
        evidence.labelShare = labelled / static_cast<double>(evidence.points);
    }
}

/// The highest level ceiling below a slab that covers a tenth of it.
std::optional<double> undersideOf(const Polygon& outline, const RoomPlan& below)
{
    PlanBits inside(below.grid.size(), 0);
    std::size_t all = 0;
    forEachPixel(outline, below.grid, [&](std::size_t i) { inside[i] = 1, ++all; });
    std::vector<std::pair<double, std::size_t>> ceilings;  // highest first
    for (const Room& room : below.rooms)
        if (room.ceilingSeen)
        {
            std::size_t shared = 0;
            forEachPixel(room.outline, below.grid, [&](std::size_t i) { shared += inside[i]; });
            ceilings.emplace_back(room.ceiling_m, shared);
        }
    std::sort(ceilings.rbegin(), ceilings.rend());
    for (std::size_t i = 0; i < ceilings.size(); ++i)
    {
        double weight = 0, sum = 0;
        for (std::size_t k = i; k < ceilings.size() && ceilings[i].first - ceilings[k].first < 0.03; ++k)
        {
            const double w = static_cast<double>(ceilings[k].second);
            weight += w;
            sum += w * ceilings[k].first;
        }
        if (weight > kUndersideShare * static_cast<double>(all))
            return sum / weight;
    }
    return std::nullopt;
}

/// Whether the storey above goes on over an area that its slab does not cover.
bool isUnder(const Polygon& outline, const RoomPlan& above)
{
    std::size_t all = 0, seen = 0;
    forEachPixel(outline, above.grid, [&](std::size_t i) { ++all, seen += above.seen[i] != 0; });
    return static_cast<double>(seen) > kAboveShare * static_cast<double>(all);
}

class Finder
{
public:
    Finder(const PlanCells& cells, const std::vector<RoomPlan>& plans, const std::vector<ElementId>& storeys,
           std::uint32_t& nextId, const SlabParams& params)
        : m_cells(cells), m_plans(plans), m_storeys(storeys), m_nextId(nextId), m_params(params)
    {
        for (const RoomPlan& plan : plans)
            m_outlines.push_back(slabOutlines(plan, params));
    }

    void addFloors(std::size_t i)
    {
        const RoomPlan& plan = m_plans[i];
        const Surface top = surfaceOf(m_cells, heightsOf(plan, true), true);
        std::optional<Surface> underside;
        std::vector<Polygon> outlines = m_outlines[i];
        if (i > 0)
        {
            underside = surfaceOf(m_cells, heightsOf(m_plans[i - 1], false), false);
            outlines = subtract(outlines, slabHoles(plan, m_plans[i - 1], underside->bits, m_params));
        }
        if (outlines.empty())
            m_result.diagnostics.push_back({Severity::Warning,
                                            "slabs",
                                            "NoFloorSlab",
                                            "No room of this storey was found, so that it has no slab.",
                                            {},
                                            Eigen::Vector3d(0, 0, plan.level.floor_m)});
        for (Polygon& outline : outlines)
        {
            if (area(outline) < m_params.minimumArea_m2)
                continue;
            Slab& slab = add(i, SlabKind::Floor, std::move(outline), plan.level.floor_m);
            addEvidence(slab.evidence, slab.outline, plan.grid, &top, underside ? &*underside : nullptr);
            if (i > 0)
                measureThickness(slab, m_plans[i - 1]);
            if (slab.thickness.provenance == Provenance::Assumed)
                sayAssumed(slab,
                           i > 0 ? "The underside of this slab was not seen" : "Nothing was seen below this slab");
        }
    }

    void addRoofs(std::size_t i)
    {
        const RoomPlan& plan = m_plans[i];
        std::vector<Polygon> open = m_outlines[i];
        const bool isTop = i + 1 == m_plans.size();
        if (!isTop)
            open = subtract(open, m_outlines[i + 1]);
        std::erase_if(open,
                      [&](const Polygon& p)
                      {
                          return area(p) < m_params.minimumArea_m2 || 2 * area(p) < kRoofWidth_m * perimeter(p) ||
                                 (!isTop && isUnder(p, m_plans[i + 1]));
                      });
        if (open.empty())
            return;
        const Surface underside = surfaceOf(m_cells, heightsOf(plan, false), false);
        for (Polygon& outline : open)
        {
            Evidence evidence;
            addEvidence(evidence, outline, plan.grid, nullptr, &underside);
            if (!plan.level.ceilingSeen || evidence.faceCoverage[1] < kRoofCeilingShare)
            {
                if (isTop)
                    m_result.diagnostics.push_back(
                        {Severity::Info,
                         "slabs",
                         "RoofNotLevel",
                         "No level ceiling was seen under the roof here, so that it has no slab.",
                         {},
                         at(outline, plan.level.ceiling_m)});
                continue;
            }
            Slab& slab = add(i, SlabKind::Roof, std::move(outline), plan.level.ceiling_m + m_params.defaultThickness_m);
            slab.evidence = evidence;
            sayAssumed(slab, "Only the underside of this roof was seen");
        }
    }

    [[nodiscard]] SlabResult take() { return std::move(m_result); }

private:
    Slab& add(std::size_t i, SlabKind kind, Polygon&& outline, double top)
    {
        Slab slab;
        slab.id = ElementId{m_nextId++};
        slab.storey = m_storeys[i];
        slab.kind = kind;
        slab.outline = std::move(outline);
        slab.top_m = top;
        slab.thickness = {m_params.defaultThickness_m, Provenance::Assumed, 0.0};
        m_result.slabs.push_back(std::move(slab));
        return m_result.slabs.back();
    }

    void measureThickness(Slab& slab, const RoomPlan& below)
    {
        const std::optional<double> underside = undersideOf(slab.outline, below);
        if (!underside)
            return;
        const double thickness = slab.top_m - *underside;
        if (thickness >= m_params.minimumThickness_m && thickness <= m_params.maximumThickness_m)
            slab.thickness = {thickness, Provenance::Measured, slab.evidence.rms_m};
        else
            m_result.diagnostics.push_back(
                {Severity::Info, "slabs", "UndersideImplausible",
                 std::format("The ceiling below lies {:.2f} m under this floor: it is not this slab's underside.",
                             thickness),
                 slab.id, at(slab.outline, slab.top_m)});
    }

    void sayAssumed(const Slab& slab, const char* why)
    {
        m_result.diagnostics.push_back(
            {Severity::Warning, "slabs", "ThicknessAssumed",
             std::format("{}; its thickness of {:.3f} m is assumed.", why, slab.thickness.value_m), slab.id,
             at(slab.outline, slab.top_m)});
    }

    static Eigen::Vector3d at(const Polygon& outline, double z)
    {
        const Eigen::Vector2d middle = centroid(outline);
        return {middle.x(), middle.y(), z};
    }

    const PlanCells& m_cells;
    const std::vector<RoomPlan>& m_plans;
    const std::vector<ElementId>& m_storeys;
    std::uint32_t& m_nextId;
    const SlabParams& m_params;
    std::vector<std::vector<Polygon>> m_outlines;
    SlabResult m_result;
};

}  // namespace

SlabResult findSlabs(const PlanCells& cells, const std::vector<RoomPlan>& plans, const std::vector<ElementId>& storeys,
                     std::uint32_t& nextId, const SlabParams& params, const Context& context)
{
    Finder finder(cells, plans, storeys, nextId, params);
    for (std::size_t i = 0; i < plans.size(); ++i)
    {
        context.checkCancelled();
        finder.addFloors(i);
        finder.addRoofs(i);
    }
    return finder.take();
}

}  // namespace s2b
