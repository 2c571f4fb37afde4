// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/reconstruct_from.h"

#include "core/cloud/frame.h"
#include "core/corrections/elements.h"
#include "core/levels/given_levels.h"
#include "core/pipeline/renewal.h"
#include "core/pipeline/stage_runs.h"

namespace s2b
{
namespace
{

/// Brings cells about the cloud's origin into a given frame.
void moveInto(SurfaceCells& cells, const Eigen::Vector3d& origin, const Frame& frame)
{
    rotateCells(cells, frame.yaw_rad);
    const Eigen::Vector3d shift = frame.toBuilding(origin);
    cells.lowestLayer_m += shift.z();
    for (SurfaceCell& c : cells.cells)
        c.position = (c.position.cast<double>() + shift).cast<float>();
}

/// Storeys that have no floor, only walls that show them: they are found with the storey below.
std::set<ElementId> storeysOfWalls(const Building& building)
{
    std::set<ElementId> ids;
    for (const Diagnostic& d : building.diagnostics)
        if (d.code == "StoreyFromWalls")
            ids.insert(d.element);
    return ids;
}

const char* stageOf(Stage stage)
{
    switch (stage)
    {
        case Stage::Levels:
            return "levels";
        case Stage::Walls:
            return "walls";
        case Stage::Doors:
        case Stage::Windows:
        case Stage::Openings:
            return "doors";
        case Stage::Columns:
            return "columns";
        case Stage::Slabs:
            return "slabs";
        case Stage::Spaces:
            return "spaces";
    }
    return "";
}

/// The storey that a diagnostic speaks of: its element's, or the highest one below its place.
ElementId storeyOf(const Building& building, const Diagnostic& d)
{
    if (const ElementId id = storeyOf(building, d.element); id.value)
        return id;
    ElementId below;
    for (const Storey& s : building.storeys)
        if (s.elevation_m < d.location.z() + 0.3)
            below = s.id;
    return below;
}

class Renewal
{
public:
    Renewal(const CloudView& cloud, const PipelineOptions& options, const Model& earlier,
            std::optional<ElementId> storey, const Sightlines& sightlines, const Context& context)
        : m_cloud(cloud),
          m_options(options),
          m_context(context),
          m_sightlines(sightlines),
          m_model(earlier),
          m_before(earlier.corrected)
    {
        m_nextId = std::max(freeId(earlier.found).value, freeId(earlier.corrected).value);
        if (storey && !earlier.corrected.storey(*storey))
            throw Error(ErrorCode::BadParameter, std::format("the model has no storey {}", storey->value));
        if (storey)
            m_scope = wholeScope(*storey);
    }

    Model run(SurfaceCells cells)
    {
        const Stages& stages = m_options.stages;
        m_context.report("Levels", 0.55);
        const LevelResult found = findLevels(cells, m_options.parameters.levels, m_context);
        if (stages.contains(Stage::Levels))
            takeLevels(m_options.levels.empty() ? found
                                                : givenLevels(m_options.levels, m_before.frame.origin.z(), found));
        if (m_model.corrected.storeys.empty() && stages != Stages{Stage::Levels})
            throw Error(ErrorCode::BadParameter, "the model has no storey to look for anything on: run Levels first");
        const std::vector<Storey> given = floors();
        const std::vector<Level> levels = levelsOf(given, found.levels);
        for (std::size_t i = 0; i < levels.size(); ++i)
            if (inScope(given[i].id))
                runStages(cells, levels[i], given[i],
                          0.6 + 0.32 * static_cast<double>(i) / static_cast<double>(levels.size()),
                          0.32 / static_cast<double>(levels.size()));
        takeRooms(cells, levels, given);
        takeDiagnostics();
        m_context.checkCancelled();
        return std::move(m_model);
    }

private:
    using Stages = std::set<Stage>;

    [[nodiscard]] bool inScope(ElementId storey) const { return m_scope.empty() || m_scope.contains(storey); }

    /// A storey of walls alone and the one that it was found with belong together.
    [[nodiscard]] std::set<ElementId> wholeScope(ElementId storey) const
    {
        const std::set<ElementId> ofWalls = storeysOfWalls(m_model.corrected);
        std::set<ElementId> scope = {storey};
        const std::vector<Storey>& all = m_model.corrected.storeys;
        for (std::size_t i = 1; i < all.size(); ++i)
            if (ofWalls.contains(all[i].id) && (all[i].id == storey || all[i - 1].id == storey))
                scope.insert({all[i].id, all[i - 1].id});
        return scope;
    }

    [[nodiscard]] std::vector<Storey> floors() const
    {
        const std::set<ElementId> ofWalls = storeysOfWalls(m_model.corrected);
        std::vector<Storey> all = m_model.corrected.storeys;
        std::erase_if(all, [&](const Storey& s) { return ofWalls.contains(s.id); });
        return all;
    }

    void takeLevels(LevelResult found)
    {
        std::vector<Storey> fresh;
        for (const Level& level : found.levels)
        {
            fresh.push_back(s2b::storeyOf(level));
            if (!m_options.levels.empty() && level.ceilingSeen)
                fresh.back().height.provenance = Provenance::Corrected;
            fresh.back().id = ElementId{m_nextId++};
            fresh.back().name = std::format("Level {}", fresh.size() - 1);
        }
        const std::set<ElementId> ofWalls = storeysOfWalls(m_model.corrected);
        for (const Storey& s : m_model.corrected.storeys)  // those are not the levels' to take away
            if (ofWalls.contains(s.id))
                fresh.push_back(s);
        renewStoreys(m_model, std::move(fresh), m_options.parameters.levels.minimumRoomHeight_m / 2, m_ids);
        append(m_diagnostics, std::move(found.diagnostics));
    }

    void runStages(const SurfaceCells& cells, const Level& level, const Storey& storey, double from, double share)
    {
        PipelineOptions options = m_options;
        std::vector<Wall> given;
        for (const Wall& w : m_model.corrected.walls)
            if (wholeScope(storey.id).contains(w.storey))
                given.push_back(w);
        // Walls first: openings and columns then see them between those that people corrected.
        if (m_options.stages.contains(Stage::Walls))
        {
            options.stages = {Stage::Walls};
            takeWalls(runStorey(cells, {level, storey.id, storey.name, nullptr, from, from + share, {}, &m_sightlines},
                                options, m_nextId, m_context),
                      storey);
            given.clear();
            for (const Wall& w : m_model.corrected.walls)
                if (wholeScope(storey.id).contains(w.storey))
                    given.push_back(w);
        }
        options.stages = m_options.stages;
        options.stages.erase(Stage::Walls);
        StoreyRun run = runStorey(cells,
                                  {level,
                                   storey.id,
                                   storey.name,
                                   &given,
                                   from,
                                   from + share,
                                   {&m_cloud, m_model.corrected.frame},
                                   &m_sightlines},
                                  options, m_nextId, m_context);
        std::set<OpeningKind> kinds;
        if (m_options.stages.contains(Stage::Doors))
            kinds.insert(OpeningKind::Door);
        if (m_options.stages.contains(Stage::Windows))
            kinds.insert(OpeningKind::Window);
        if (m_options.stages.contains(Stage::Openings))
            kinds.insert(OpeningKind::Plain);
        const std::set<ElementId> scope = wholeScope(storey.id);
        const InScope isIn = [&](ElementId id) { return scope.contains(id); };
        if (!kinds.empty())
            renewOpenings(m_model, std::move(run.openings), given, kinds, isIn, m_ids);
        if (m_options.stages.contains(Stage::Columns))
            renewColumns(m_model, std::move(run.columns), isIn, m_ids);
        append(m_diagnostics, std::move(run.diagnostics));
    }

    void takeWalls(StoreyRun run, const Storey& storey)
    {
        std::set<ElementId> scope = wholeScope(storey.id);
        if (run.upper)
        {
            // The storey that shows in the walls alone: the one of the earlier run, or a new one.
            ElementId known;
            for (const ElementId id : scope)
                if (id != storey.id)
                    known = id;
            if (!known.value)
            {
                known = run.upper->id;
                run.upper->name = std::format("Level {}", m_model.corrected.storeys.size());
                for (Building* b : {&m_model.found, &m_model.corrected})
                {
                    b->storeys.push_back(*run.upper);
                    std::stable_sort(b->storeys.begin(), b->storeys.end(),
                                     [](const Storey& a, const Storey& c) { return a.elevation_m < c.elevation_m; });
                }
            }
            for (Wall& w : run.walls)
                if (w.storey == run.upper->id)
                    w.storey = known;
            m_ids[run.upper->id] = known;
            scope.insert(known);
        }
        renewWalls(
            m_model, std::move(run.walls), std::move(run.junctions), [&](ElementId id) { return scope.contains(id); },
            m_ids);
        append(m_diagnostics, std::move(run.diagnostics));
        for (const ElementId id : scope)  // an upper storey whose walls are gone
            if (!run.upper && id != storey.id &&
                std::ranges::none_of(m_model.corrected.walls, [&](const Wall& w) { return w.storey == id; }))
                for (Building* b : {&m_model.found, &m_model.corrected})
                    *b = removeElement(std::move(*b), id);
    }

    void takeRooms(const SurfaceCells& cells, const std::vector<Level>& levels, const std::vector<Storey>& given)
    {
        std::vector<ElementId> storeys;
        for (const Storey& s : given)
            storeys.push_back(s.id);
        RoomsRun rooms = runRooms(cells, levels, storeys, m_model.corrected.walls, m_options, m_nextId, m_context);
        std::erase_if(rooms.slabs, [&](const Slab& s) { return !inScope(s.storey); });
        std::erase_if(rooms.spaces, [&](const Space& s) { return !inScope(s.storey); });
        const InScope isIn = [&](ElementId id) { return inScope(id); };
        if (m_options.stages.contains(Stage::Slabs))
            renewSlabs(m_model, std::move(rooms.slabs), isIn, m_ids);
        if (m_options.stages.contains(Stage::Spaces))
            renewSpaces(m_model, std::move(rooms.spaces), isIn, m_ids);
        append(m_diagnostics, std::move(rooms.diagnostics));
    }

    /// Those of the stages that ran are renewed, within the scope; of the others those whose element is still there.
    void takeDiagnostics()
    {
        std::set<std::string> ran;
        for (const Stage stage : m_options.stages)
            ran.insert(stageOf(stage));
        std::vector<Diagnostic> all;
        for (const Diagnostic& d : m_before.diagnostics)
        {
            const bool isGone = d.element.value && nameOf(m_model.corrected, d.element).empty();
            const std::string stage = d.code == "StoreyFromWalls" ? "walls" : d.stage;
            const bool isRenewed = ran.contains(stage) && inScope(storeyOf(m_before, d));
            if (!isGone && !isRenewed)
                all.push_back(d);
        }
        for (Diagnostic& d : m_diagnostics)
        {
            const ElementId fresh = d.element;
            if (const auto known = m_ids.find(fresh); known != m_ids.end())
                d.element = known->second;
            const bool isOfAnOther = fresh.value && nameOf(m_model.corrected, d.element).empty();
            if (!isOfAnOther && inScope(storeyOf(m_model.corrected, d)) &&
                std::ranges::none_of(all, [&](const Diagnostic& k) { return isSame(d, k); }))
                all.push_back(d);
        }
        m_model.corrected.diagnostics = all;
        m_model.found.diagnostics = std::move(all);
    }

    const CloudView& m_cloud;
    const PipelineOptions& m_options;
    const Context& m_context;
    const Sightlines& m_sightlines;
    Model m_model;
    Building m_before;
    std::set<ElementId> m_scope;  ///< empty: all storeys
    std::uint32_t m_nextId = 1;
    IdMap m_ids;
    std::vector<Diagnostic> m_diagnostics;
};

}  // namespace

Model reconstructFrom(const CloudView& cloud, const PipelineOptions& options, const Model& earlier,
                      std::optional<ElementId> storey, const Context& context)
{
    const StationInput stations = stationsOf(cloud, context);
    CloudView input = cloud;
    input.stations = stations.view;
    const Frame& frame = earlier.corrected.frame;
    const Sightlines sightlines(input, frame.yaw_rad, frame.toBuilding(cloud.origin), context);
    Renewal renewal(cloud, options, earlier, storey, sightlines, context);
    SurfaceCells cells = surfaceCellsOf(input, options, context);
    context.report("Building frame", 0.5);
    moveInto(cells, cloud.origin, earlier.corrected.frame);
    return renewal.run(std::move(cells));
}

}  // namespace s2b
