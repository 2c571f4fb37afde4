// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string_view>

namespace s2b
{

enum class LogLevel
{
    Info,
    Warning,
    Error
};

/// What a run needs from its surroundings. Core never prints, opens a window or reads a clock for a result.
struct Context
{
    /// Called at the start of each stage and as it advances: text for people and the fraction done of the whole run in
    /// [0, 1], never decreasing. Always from the thread that runs the pipeline. May be empty.
    std::function<void(std::string_view text, double fraction)> progress;
    /// Messages for people. Always from the thread that runs the pipeline. May be empty.
    std::function<void(LogLevel level, std::string_view text)> log;
    /// Polled at least every 50 ms of work; a request ends the run with Cancelled.
    std::stop_token cancel;
    unsigned threads = 0;    ///< worker threads, 0 = as many as the hardware has; the result does not depend on it
    std::uint64_t seed = 1;  ///< of every random draw

    void checkCancelled() const
    {
        if (cancel.stop_requested())
            throw Cancelled();
    }
    void report(std::string_view text, double fraction) const
    {
        checkCancelled();
        if (progress)
            progress(text, fraction);
    }
    void say(LogLevel level, std::string_view text) const
    {
        if (log)
            log(level, text);
    }
};

}  // namespace s2b
