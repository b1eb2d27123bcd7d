#pragma once

#include "renderer/session/render_session.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace asos {

/// A whole picture and what it cost.
struct TimedRender {
  Film film;
  RenderStatistics statistics;
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;  ///< of all threads of the process together
  double memory_mb = 0.0;    ///< the process's largest resident set meanwhile, in 10^6 bytes; 0:
                             ///< this system does not tell
};

/// Renders a snapshot without coarse passes. `stop` is asked some dozens of times a second; once it
/// says so nothing comes back. Nothing else in the process should work at the same time.
[[nodiscard]] std::optional<TimedRender> timed_render(Snapshot snapshot,
                                                      const std::function<bool()>& stop = {});

/// Cells examined on all levels, and rays of all kinds.
[[nodiscard]] std::uint64_t pyrays_of(const RenderStatistics& statistics);
[[nodiscard]] std::uint64_t rays_of(const RenderStatistics& statistics);

}  // namespace asos
