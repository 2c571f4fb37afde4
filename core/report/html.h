// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/plan_view.h"
#include "core/report/scene.h"

#include <string>
#include <vector>

namespace s2b::report
{

/// The drawings of the page, in its order.
struct Drawings
{
    std::vector<Drawing> plans;
    std::vector<Drawing> deviations;
    std::vector<Drawing> walls;
    std::vector<std::string> unseen;  ///< storeys that have no plan because the survey saw nothing of them
};

/// report.html: one page without any external resource, for the screen and for A4 paper.
[[nodiscard]] std::string makeHtml(const ReportInput& input, const Scene& scene, const Drawings& drawings);

/// The page's style sheet, for other pages that show these drawings.
[[nodiscard]] std::string pageStyle();

}  // namespace s2b::report
