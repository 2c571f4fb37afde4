// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace s2b
{

/// What kind of input was wrong. Stages never throw because the data did not allow a result: that is a Diagnostic.
enum class ErrorCode
{
    EmptyCloud,      ///< no point, or none left to work on
    BadCoordinates,  ///< NaN or infinite coordinates, or coordinates that lost their precision
    BadLabels,       ///< no label field, codes without a class, a label map that can't be used
    BadParameter,    ///< unknown name, value out of range, file that is not TOML
    BadFile,         ///< unreadable, truncated or not of the expected format
    CannotWrite,     ///< the output could not be written; no partial file is left
    Internal         ///< a broken invariant of ours
};

/// Bad input: one sentence that names the file or value and what to do. Arguments are unchanged, no partial output is
/// left.
class Error : public std::runtime_error
{
public:
    Error(ErrorCode code, const std::string& message) : std::runtime_error(message), m_code(code) {}
    [[nodiscard]] ErrorCode code() const noexcept { return m_code; }

private:
    ErrorCode m_code;
};

/// Thrown from within a stage after Context::cancel was requested. Nothing was changed.
class Cancelled : public std::runtime_error
{
public:
    Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace s2b
