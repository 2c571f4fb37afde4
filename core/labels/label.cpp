// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/labels/label.h"

#include "core/base/error.h"
#include "core/base/nearest_name.h"

#include <toml++/toml.hpp>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <vector>

namespace s2b
{

namespace
{

constexpr std::array<std::string_view, kLabelCount> kLabelNames = {
    "unassigned", "floor", "ceiling", "wall", "column", "door", "window", "beam", "stair", "roof", "furniture"};

constexpr std::array<std::string_view, 4> kMapNames = {"s2b", "s3dis", "scannet", "asprs"};

/// S3DIS (Armeni et al., 2016), the class order that its published point labels use.
LabelMap s3disMap()
{
    return {"s3dis",
            {{0, Label::Ceiling},
             {1, Label::Floor},
             {2, Label::Wall},
             {3, Label::Beam},
             {4, Label::Column},
             {5, Label::Window},
             {6, Label::Door},
             {7, Label::Furniture},     // table
             {8, Label::Furniture},     // chair
             {9, Label::Furniture},     // sofa
             {10, Label::Furniture},    // bookcase
             {11, Label::Furniture},    // board
             {12, Label::Furniture}}};  // clutter: everything that is none of the above
}

/// ScanNet with NYU40 ids. It has no column, beam or stair: those are among 38, otherstructure.
LabelMap scannetMap()
{
    LabelMap map{"scannet", {}};
    for (int code = 1; code <= 40; ++code)
        map.classOfCode[code] = Label::Furniture;
    map.classOfCode[0] = Label::Unassigned;
    map.classOfCode[1] = Label::Wall;
    map.classOfCode[2] = Label::Floor;
    map.classOfCode[8] = Label::Door;
    map.classOfCode[9] = Label::Window;
    map.classOfCode[22] = Label::Ceiling;
    map.classOfCode[38] = Label::Unassigned;
    return map;
}

/// LAS 1.4 (ASPRS). Made for airborne surveys: a building is one class, so its parts are left to geometry, and what is
/// surely no building (vegetation, water, noise, wires, vehicles' ways) is kept away from it as furniture is.
LabelMap asprsMap()
{
    LabelMap map{"asprs", {}};
    for (const int code :
         {0, 1, 6, 8, 12, 20})  // never classified, unclassified, building, key point, overlap, ignored ground
        map.classOfCode[code] = Label::Unassigned;
    map.classOfCode[2] = Label::Floor;  // ground: a ground filter's lowest surface is indoors the floor
    for (const int code : {3, 4, 5, 7, 9, 10, 11, 13, 14, 15, 16, 17, 18, 19, 21, 22})
        map.classOfCode[code] = Label::Furniture;
    return map;
}

LabelMap s2bMap()
{
    LabelMap map{"s2b", {}};
    for (std::size_t i = 0; i < kLabelCount; ++i)
        map.classOfCode[static_cast<int>(i)] = static_cast<Label>(i);
    return map;
}

[[noreturn]] void fail(const std::string& message)
{
    throw Error(ErrorCode::BadLabels, message);
}

[[noreturn]] void fail(const std::string& path, const toml::source_region& source, const std::string& message)
{
    fail(path + ", line " + std::to_string(source.begin.line) + ": " + message);
}

toml::table parseLabelFile(const std::string& path)
{
    try
    {
        return toml::parse_file(path);
    }
    catch (const toml::parse_error& error)
    {
        if (error.source().begin.line == 0)  // never got to the text
            fail(path + ": the label map can't be read");
        fail(path, error.source(), "not TOML: " + std::string(error.description()));
    }
}

void readPair(LabelMap& map, const toml::key& key, const toml::node& node)
{
    const std::string_view text = key.str();
    int code = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), code);
    if (error != std::errc() || end != text.data() + text.size())
        fail(map.name, key.source(), "\"" + std::string(text) + "\" is no label code, use a whole number");
    if (!node.is_string())
        fail(map.name, key.source(),
             "code " + std::string(text) + " needs a class name in quotes, one of " + joinNames(kLabelNames));
    const std::string& name = node.as_string()->get();
    const auto found = std::ranges::find(kLabelNames, name);
    if (found == kLabelNames.end())
        fail(map.name, key.source(),
             "there is no class \"" + name + "\", the nearest known one is " +
                 std::string(nearestName(name, kLabelNames)));
    if (!map.classOfCode.emplace(code, static_cast<Label>(found - kLabelNames.begin())).second)
        fail(map.name, key.source(), "code " + std::to_string(code) + " is given twice");
}

}  // namespace

std::string_view labelName(Label label)
{
    const auto index = static_cast<std::size_t>(label);
    return index < kLabelNames.size() ? kLabelNames[index] : std::string_view("unknown");
}

LabelMap builtInLabelMap(std::string_view name)
{
    if (name == "s2b")
        return s2bMap();
    if (name == "s3dis")
        return s3disMap();
    if (name == "scannet")
        return scannetMap();
    if (name == "asprs")
        return asprsMap();
    fail("there is no label map \"" + std::string(name) + "\", use " + joinNames(kMapNames) + " or a TOML file");
}

LabelMap loadLabelMap(const std::string& nameOrFile)
{
    std::error_code ignored;
    const bool isBuiltIn = std::ranges::find(kMapNames, nameOrFile) != kMapNames.end();
    if (isBuiltIn || !std::filesystem::exists(nameOrFile, ignored))
        return builtInLabelMap(nameOrFile);
    if (std::filesystem::is_directory(nameOrFile, ignored))
        fail(nameOrFile + ": is a folder, give a TOML file or one of " + joinNames(kMapNames));

    const toml::table root = parseLabelFile(nameOrFile);
    const toml::table* labels = root["labels"].as_table();
    if (!labels || labels->empty())
        fail(nameOrFile + ": has no table [labels] with lines like 3 = \"wall\"");
    for (const auto& [key, node] : root)
    {
        if (key.str() != "labels")
            fail(nameOrFile, key.source(),
                 "\"" + std::string(key.str()) + "\" is not known, only the table [labels] is");
    }
    LabelMap map{nameOrFile, {}};
    for (const auto& [key, node] : *labels)
        readPair(map, key, node);
    return map;
}

}  // namespace s2b
