#pragma once

#include "renderer/session/render_session.h"

#include <cstdint>
#include <optional>

namespace asos::ui {

struct Forecast;
class Previewer;

/// The time that a render takes, in seconds of the clock.
struct TimeEstimate {
  double all = 0.0;
  double left = 0.0;
};

/// The one estimate that every text of the window shows: the render's own as soon as there is one,
/// before that the forecast of its settings. None: neither is known, or the render has failed.
[[nodiscard]] std::optional<TimeEstimate> time_estimate(const Progress& progress,
                                                        const Forecast* forecast);
/// The same of the window's settings, which a render follows a moment later.
[[nodiscard]] std::optional<TimeEstimate> time_estimate(const Previewer& previewer,
                                                        const Forecast* forecast);

/// The percentage that is shown of a render. A session's share of the work rests while its estimate
/// grows and while edges are searched; this one goes on, ever slower, and never falls. It is 1 only
/// once the render is finished. One thread.
class ShownProgress {
 public:
  /// Call once a frame. `restarts`: another render begins at 0.
  void update(const Progress& progress, std::optional<TimeEstimate> estimate,
              std::uint64_t restarts, double now_seconds);
  [[nodiscard]] double fraction() const { return fraction_; }

 private:
  std::uint64_t restarts_ = 0;
  double now_seconds_ = 0.0;
  double fraction_ = 0.0;
};

}  // namespace asos::ui
