// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/class_score.h"
#include "core/validation/overlap.h"
#include "core/validation/storeys.h"
#include "core/validation/surface_survey.h"
#include "core/validation/validation.h"
#include "core/validation/validation_parameters.h"
#include "core/validation/visibility.h"

#include <algorithm>

namespace s2b::validation
{

namespace
{

constexpr ElementClass kClasses[] = {ElementClass::Wall,   ElementClass::Door, ElementClass::Window,
                                     ElementClass::Column, ElementClass::Slab, ElementClass::Space};

/// Of all classes, truth in its order first.
void gather(Validation& validation, const Bim& truth, const Bim& result, const ValidationParams& params,
            const Context& context)
{
    std::vector<ElementResult> others;
    for (const ElementClass elementClass : kClasses)
    {
        context.checkCancelled();
        ClassComparison comparison = compareClass(elementClass, truth, result, params);
        validation.elements.insert(validation.elements.end(), comparison.truth.begin(), comparison.truth.end());
        others.insert(others.end(), comparison.others.begin(), comparison.others.end());
        if (!comparison.truth.empty() || comparison.score.resultCount > 0)
            validation.scores[elementClass] = std::move(comparison.score);
    }
    std::sort(validation.elements.begin(), validation.elements.end(),
              [](const ElementResult& a, const ElementResult& b) { return a.truth < b.truth; });
    std::sort(others.begin(), others.end(),
              [](const ElementResult& a, const ElementResult& b) { return a.result < b.result; });
    validation.elements.insert(validation.elements.end(), others.begin(), others.end());
}

std::optional<double> meanIou(const std::map<ElementClass, ClassScore>& scores)
{
    double sum = 0.0;
    int count = 0;
    for (const ElementClass elementClass : {ElementClass::Wall, ElementClass::Door, ElementClass::Column})
        if (const auto at = scores.find(elementClass); at != scores.end() && at->second.iou)
        {
            sum += *at->second.iou;
            ++count;
        }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

}  // namespace

Validation validate(const Bim& truth, const Bim& result, const CloudView* cloud, const ValidationParams& params,
                    const Context& context)
{
    checkParams(params);
    checkOverlap(truth, result, cloud);
    Validation validation;
    Bim seen = truth;
    if (cloud != nullptr)
    {
        context.report("Distances to the truth", 0.0);
        SurfaceSurvey survey = surveySurfaces(truth, *cloud, params, false, context);
        judgeVisibility(seen, survey, params);
        validation.cloudToTruth = std::move(survey.deviation);
        context.report("Distances to the result", 0.4);
        validation.cloudToResult = measureDeviation(result, *cloud, params, false, context);
    }
    context.report("Matching", 0.8);
    gather(validation, seen, result, params, context);
    validation.meanIou = meanIou(validation.scores);
    validation.storeys = compareStoreys(seen, result);
    validation.extraStoreys = extraStoreys(seen, result);
    context.report("Matching", 1.0);
    return validation;
}

}  // namespace s2b::validation
