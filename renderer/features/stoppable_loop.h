#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace asos {

/// Thrown by a search for boundaries that was asked to stop. No stage then ever sees what another
/// one has left unfinished.
struct SearchStopped {};

inline void check_stop(const std::stop_token& stop) {
  if (stop.stop_requested()) throw SearchStopped();
}

/// Calls `visit` with the numbers below `count`, on all processors and in any order. Throws
/// SearchStopped some thousand calls after a stop is requested.
template <typename Visit>
void in_parallel(std::size_t count, const std::stop_token& stop, const Visit& visit) {
  constexpr std::size_t calls_between_checks = 4096;
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, count), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end();) {
      check_stop(stop);
      const std::size_t end = std::min(range.end(), i + calls_between_checks);
      for (; i < end; ++i) visit(static_cast<std::uint32_t>(i));
    }
  });
}

}  // namespace asos
