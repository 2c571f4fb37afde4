// SPDX-License-Identifier: GPL-3.0-or-later
/// Reading of JSON truth files, for the .cpp files of this folder only.
#pragma once

#include "core/base/error.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

namespace s2b::validation
{

using Json = nlohmann::json;

[[noreturn]] inline void failToRead(const std::string& path, const std::string& reason)
{
    throw Error(ErrorCode::BadFile, "can't read " + path + ": " + reason);
}

/// @throws Error{BadFile} for a missing file, or one that is not JSON or ends too early.
inline Json parseJsonFile(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    if (!in)
        failToRead(path, "the file does not exist or may not be read");
    try
    {
        return Json::parse(in);
    }
    catch (const Json::parse_error& e)
    {
        failToRead(path, "it is not valid JSON, or truncated (at byte " + std::to_string(e.byte) + ")");
    }
}

/// The number at `key`; `otherwise` when it is missing or null.
inline double numberAt(const Json& object, const char* key, double otherwise)
{
    const auto at = object.find(key);
    return at == object.end() || at->is_null() ? otherwise : at->get<double>();
}

/// The text at `key`; empty when it is missing or null.
inline std::string textAt(const Json& object, const char* key)
{
    const auto at = object.find(key);
    return at == object.end() || !at->is_string() ? std::string() : at->get<std::string>();
}

}  // namespace s2b::validation
