// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/template.h"

#include "core/base/error.h"

#include <ctemplate/template.h>

#include <memory>

namespace s2b::report
{
namespace
{

void fill(ctemplate::TemplateDictionary& dictionary, const Fields& fields)
{
    for (const auto& [name, value] : fields.values)
        dictionary.SetValue(name, value);
    for (const auto& [name, section] : fields.sections)
        fill(*dictionary.AddSectionDictionary(name), section);
}

}  // namespace

std::string fillTemplate(std::string_view text, const Fields& fields)
{
    const std::unique_ptr<ctemplate::Template> parsed(
        ctemplate::Template::StringToTemplate(text.data(), text.size(), ctemplate::STRIP_BLANK_LINES));
    ctemplate::TemplateDictionary dictionary("report");
    fill(dictionary, fields);
    std::string filled;
    if (!parsed || !parsed->Expand(&filled, &dictionary))
        throw Error(ErrorCode::Internal, "a template of the report has a fault: please report it");
    return filled;
}

}  // namespace s2b::report
