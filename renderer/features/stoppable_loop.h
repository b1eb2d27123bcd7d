#pragma once

#include "renderer/tasks.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stop_token>

namespace asos {

/// Thrown by a search for boundaries after a stop request, so that no stage sees an incomplete
/// result of another one.
struct SearchStopped {};

inline void check_stop(const std::stop_token& stop) {
  if (stop.stop_requested()) throw SearchStopped();
}

/// Calls `visit` with the numbers below `count`, on all processors and in any order. Throws
/// SearchStopped some thousand calls after a stop request.
template <typename Visit>
void in_parallel(std::size_t count, const std::stop_token& stop, const Visit& visit) {
  constexpr std::size_t calls_between_checks = 4096;
  in_task_ranges(count, 1, [&](std::size_t i, std::size_t last) {
    while (i < last) {
      check_stop(stop);
      const std::size_t end = std::min(last, i + calls_between_checks);
      for (; i < end; ++i) visit(static_cast<std::uint32_t>(i));
    }
  });
}

}  // namespace asos
