// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace s2b::report
{

/// What fills a template: values by name, and sections, each shown once in this order.
struct Fields
{
    std::map<std::string, std::string> values;
    std::vector<std::pair<std::string, Fields>> sections;

    void set(const std::string& name, std::string value) { values[name] = std::move(value); }
    Fields& add(const std::string& section) { return sections.emplace_back(section, Fields{}).second; }
};

/// Fills a template of the ctemplate language: {{NAME:h}} and {{NAME:xml_escape}} are escaped for HTML and XML,
/// {{NAME:none}} is markup already.
/// @throws Error{Internal} for a template with a fault.
[[nodiscard]] std::string fillTemplate(std::string_view text, const Fields& fields);

/// The templates of the folder templates/, which the build makes part of the program.
extern const std::string_view kReportTemplate;
extern const std::string_view kMarkupTemplate;
extern const std::string_view kViewpointTemplate;

}  // namespace s2b::report
