// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/output_file.h"

#include "core/base/error.h"

#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

namespace s2b::sim
{

OutputFile::OutputFile(std::string path) : m_path(std::move(path))
{
    const std::filesystem::path target(m_path);
    m_temporary = (target.parent_path() / (target.stem().string() + ".partial" + target.extension().string())).string();
    if (std::filesystem::is_directory(target))
        fail("it is a folder");
    if (!std::ofstream(m_temporary, std::ios::binary | std::ios::trunc))
        fail("give a folder that exists and can be written to");
}

OutputFile::~OutputFile()
{
    std::error_code ignored;
    if (!m_isCommitted)
        std::filesystem::remove(m_temporary, ignored);
}

void OutputFile::fail(const std::string& reason) const
{
    throw Error(ErrorCode::CannotWrite, "can't write '" + m_path + "': " + reason);
}

void OutputFile::commit()
{
    std::error_code error;
    std::filesystem::rename(m_temporary, m_path, error);
    if (error)
        fail(error.message());
    m_isCommitted = true;
}

}  // namespace s2b::sim
