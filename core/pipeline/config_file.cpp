// SPDX-License-Identifier: GPL-3.0-or-later
/// Parameters as text: the TOML file and the Markdown documentation. Reading follows the TOML specification (toml++).
#include "core/base/error.h"
#include "core/pipeline/parameter_text.h"
#include "core/pipeline/parameters.h"
#include "core/pipeline/presets.h"

#include <toml++/toml.hpp>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace s2b
{

namespace
{

/// "walls" of "walls.mergeGap".
std::string stageOf(const ParameterInfo& info)
{
    return info.name.substr(0, info.name.find('.'));
}
std::string keyOf(const ParameterInfo& info)
{
    return info.name.substr(info.name.find('.') + 1);
}

std::string unitText(const ParameterInfo& info)
{
    return info.unit.empty() || info.unit == "1" ? "" : " " + info.unit;
}

/// As TOML and the documentation write it: switches as words, doubles always recognisable as such.
std::string valueText(const ParameterInfo& info, double value)
{
    if (info.isSwitch())
        return value != 0.0 ? "true" : "false";
    std::string text = numberText(value);
    if (!info.isInteger() && text.find_first_of(".e") == std::string::npos)
        text += ".0";
    return text;
}

[[noreturn]] void fail(const std::string& path, const toml::source_region& source, const std::string& message)
{
    throw Error(ErrorCode::BadParameter, path + ", line " + std::to_string(source.begin.line) + ": " + message);
}

double numberOf(const std::string& path, const ParameterInfo& info, const toml::node& node)
{
    if (info.isSwitch() && node.is_boolean())
        return node.as_boolean()->get() ? 1.0 : 0.0;
    if (!info.isSwitch() && node.is_integer())
        return static_cast<double>(node.as_integer()->get());
    if (!info.isSwitch() && node.is_floating_point())
        return node.as_floating_point()->get();
    fail(path, node.source(), info.name + " has a value of another kind, use " + rangeText(info));
}

void readStage(Parameters& parameters, const std::string& path, const std::string& stage, const toml::table& table)
{
    for (const auto& [key, node] : table)
    {
        try
        {
            const ParameterInfo& info = findParameter(stage + "." + std::string(key.str()));
            info.set(parameters, numberOf(path, info, node));
        }
        catch (const Error& error)
        {
            const std::string message = error.what();
            if (message.starts_with(path))
                throw;
            fail(path, key.source(), message);
        }
    }
}

}  // namespace

void loadConfig(Parameters& parameters, const std::string& path)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw Error(ErrorCode::BadParameter, path + ": is a folder, give a TOML file of parameters");
    toml::table root;
    try
    {
        root = toml::parse_file(path);
    }
    catch (const toml::parse_error& error)
    {
        if (!std::filesystem::exists(path, ignored))
            throw Error(ErrorCode::BadParameter, path + ": there is no such file");
        if (error.source().begin.line == 0)  // never got to the text
            throw Error(ErrorCode::BadParameter, path + ": the file can't be read");
        fail(path, error.source(), "not TOML: " + std::string(error.description()));
    }

    Parameters read = parameters;
    for (const auto& [key, node] : root)
    {
        const std::string stage(key.str());
        const bool known =
            std::ranges::any_of(parameterTable(), [&](const auto& info) { return stageOf(info) == stage; });
        if (!node.is_table() && known)
            fail(path, key.source(), "\"" + stage + "\" is a table of parameters, write [" + stage + "]");
        if (node.is_table() && known)
        {
            readStage(read, path, stage, *node.as_table());
            continue;
        }
        try
        {
            // Never found: it names the nearest stage or parameter.
            const toml::table* table = node.as_table();
            const bool hasKey = table && !table->empty();
            static_cast<void>(findParameter(hasKey ? stage + "." + std::string(table->begin()->first.str()) : stage));
        }
        catch (const Error& error)
        {
            fail(path, key.source(), error.what());
        }
    }
    try
    {
        checkParameters(read);
    }
    catch (const Error& error)
    {
        throw Error(ErrorCode::BadParameter, path + ": " + error.what());
    }
    parameters = read;
}

std::string configText(const Parameters& parameters)
{
    std::ostringstream text;
    text << "# Parameters of the reconstruction. A parameter that is not given keeps its default.\n";
    std::string stage;
    for (const ParameterInfo& info : parameterTable())
    {
        if (stageOf(info) != stage)
        {
            stage = stageOf(info);
            text << "\n[" << stage << "]\n";
        }
        text << "# " << info.help << " " << rangeText(info) << unitText(info) << "\n";
        text << keyOf(info) << " = " << valueText(info, info.value(parameters)) << "\n";
    }
    return text.str();
}

std::string parameterDocumentation()
{
    std::ostringstream text;
    text << "# Parameters\n\n"
            "Set them with `-SET name=value`, in a TOML file with `-CONFIG FILE.toml`, or in the dialog. In the file, "
            "the\n"
            "part of the name before the dot is a table, the part after it a key:\n\n"
            "```toml\n[walls]\nmergeGap = 0.5\n```\n\n"
            "The source says where a default comes from: a section of HumanTech D3.6 (Scan to BIMxD), a measurement,\n"
            "or practice (common dimensions of buildings and surveys; not tuned on data).\n"
            "This file is generated from the table in `core/pipeline/parameter_table.cpp`.\n";
    const Parameters defaults;
    std::string stage;
    for (const ParameterInfo& info : parameterTable())
    {
        if (stageOf(info) != stage)
        {
            stage = stageOf(info);
            text << "\n## " << stage << "\n\n| name | default | range | meaning | source of the default |\n"
                 << "| --- | --- | --- | --- | --- |\n";
        }
        // A bar would end the table's cell.
        std::string help = info.help;
        for (std::size_t at = help.find('|'); at != std::string::npos; at = help.find('|', at + 2))
            help.insert(at, "\\");
        text << "| " << info.name << " | " << valueText(info, info.value(defaults)) << unitText(info) << " | "
             << rangeText(info) << " | " << help << " | " << info.source << " |\n";
    }
    text << presetDocumentation();
    return text.str();
}

}  // namespace s2b
