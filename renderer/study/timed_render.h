#pragma once

#include "renderer/session/render_session.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace asos {

/// A whole picture and its cost.
struct TimedRender {
  Film film;
  RenderStatistics statistics;
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;  ///< of all threads of the process together
  double memory_mb = 0.0;    ///< the process' peak resident set, in 10^6 bytes; 0: unknown
};

/// Renders a snapshot without coarse passes. `stop` is called some dozens of times per second; once
/// it returns true, the result is nothing. Nothing else in the process should work at the same
/// time.
[[nodiscard]] std::optional<TimedRender> timed_render(Snapshot snapshot,
                                                      const std::function<bool()>& stop = {});

/// Returns the cells examined on all levels. rays_of() returns the rays of all kinds.
[[nodiscard]] std::uint64_t pyrays_of(const RenderStatistics& statistics);
[[nodiscard]] std::uint64_t rays_of(const RenderStatistics& statistics);

}  // namespace asos
