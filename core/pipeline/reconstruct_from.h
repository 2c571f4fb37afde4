// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/corrections/model.h"
#include "core/pipeline/pipeline.h"

#include <optional>

namespace s2b
{

/// Runs single stages on a cloud, with what an earlier run and people's corrections give for all others: given levels
/// give other walls, given walls other doors.
///
/// - Exactly `options.stages` run. What they need and the model lacks (walls without a storey) is an error.
/// - Corrections stay: an element of the stages that run is renewed only where nobody touched it. What is found where a
///   corrected element is or was, or where one was taken out, is dropped.
/// - Ids stay: of what is not renewed, and of what is found again in its place. New elements get ids that no other has.
/// - What hangs on renewed walls follows: openings keep their place in the plan, or go with their wall; junctions are
///   those of the new walls.
/// - Storeys that are found again within half a room's height keep their id and their corrections; the elements of
///   those that are not found again go with them. The frame stays.
/// - `options.levels`, when given, are what the stage Levels finds. Other stages stand on the model's own storeys.
/// @param storey  only this one; nothing: all. Levels are always found for all.
/// @return found and corrected as they then are. `earlier` is not changed.
/// @throws Error{BadParameter} for an unknown storey or missing storeys or walls; else as reconstruct(); Cancelled.
/// Deterministic as reconstruct().
[[nodiscard]] Model reconstructFrom(const CloudView& cloud, const PipelineOptions& options, const Model& earlier,
                                    std::optional<ElementId> storey, const Context& context);

}  // namespace s2b
