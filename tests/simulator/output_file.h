// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace s2b::sim
{

/// A file that appears under its name only when it is complete: written beside it, then renamed. Left uncommitted, it
/// is removed.
class OutputFile
{
public:
    /// @throws Error{CannotWrite} when the folder does not take new files.
    explicit OutputFile(std::string path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Where to write meanwhile; it has the same extension.
    [[nodiscard]] const std::string& temporary() const { return m_temporary; }
    [[noreturn]] void fail(const std::string& reason) const;
    void commit();

private:
    std::string m_path;
    std::string m_temporary;
    bool m_isCommitted = false;
};

}  // namespace s2b::sim
