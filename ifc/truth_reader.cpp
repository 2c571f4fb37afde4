// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/validation/cv4aec_json.h"
#include "core/validation/survey_truth.h"
#include "ifc/bim_reader.h"

#include <filesystem>
#include <fstream>

namespace s2b::ifc
{

namespace
{

[[noreturn]] void fail(const std::string& path, const std::string& reason)
{
    throw Error(ErrorCode::BadFile, "can't read " + path + ": " + reason);
}

/// The first bytes, without a byte order mark and white space.
std::string headOf(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    std::string head(512, '\0');
    if (!in || !in.read(head.data(), 1))
        fail(path, "the file does not exist, is empty or may not be read");
    in.read(head.data() + 1, static_cast<std::streamsize>(head.size()) - 1);
    head.resize(static_cast<std::size_t>(in.gcount()) + 1);
    if (head.starts_with("\xEF\xBB\xBF"))
        head.erase(0, 3);
    head.erase(0, head.find_first_not_of(" \t\r\n"));
    return head;
}

}  // namespace

validation::Bim readTruth(const std::string& path, const BimReadOptions& options)
{
    if (std::filesystem::is_directory(path))
        return validation::readCv4aec(path);
    const std::string head = headOf(path);
    if (head.find("ISO-10303-21") != std::string::npos)
        return readBim(path, options);
    if (head.starts_with("PK"))
        fail(path, "it is packed (ifcZIP); unpack the IFC file from it first");
    if (head.starts_with("<"))
        fail(path, "it is XML (ifcXML); only IFC files in STEP format (.ifc) can be read");
    if (head.starts_with("{") || head.starts_with("["))
        return validation::isSurveyTruth(path) ? validation::readSurveyTruth(path) : validation::readCv4aec(path);
    fail(path, "it is neither an IFC file in STEP format (.ifc) nor a JSON truth file");
}

}  // namespace s2b::ifc
