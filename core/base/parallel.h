// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"

#include <cstddef>
#include <functional>

namespace s2b
{

/// Calls body(begin, end) for consecutive chunks of [0, count), in any order and on up to `threads` threads (0 = all).
///
/// The chunks depend on `count` and `chunk` alone, never on the number of threads: a result that is gathered per chunk
/// and combined in chunk order is the same for any number of threads. Serial when there is only one chunk.
/// An exception of a body is rethrown here.
void parallelChunks(std::size_t count, std::size_t chunk, unsigned threads,
                    const std::function<void(std::size_t begin, std::size_t end)>& body);

/// The same with the context's threads; ends with Cancelled at the next chunk once that was asked for.
void parallelChunks(std::size_t count, std::size_t chunk, const Context& context,
                    const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace s2b
