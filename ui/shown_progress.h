#pragma once

#include "renderer/session/render_session.h"

#include <cstdint>
#include <optional>

namespace asos::ui {

struct Forecast;
class Previewer;

/// The duration of a render, in wall-clock seconds.
struct TimeEstimate {
  double all = 0.0;
  double left = 0.0;
};

/// The estimate that every text of the window shows: the render's own if it has one, otherwise the
/// estimate for its settings from a few blocks (SplitForecast). None: neither exists, or the render
/// has failed.
[[nodiscard]] std::optional<TimeEstimate> time_estimate(const Progress& progress,
                                                        const Forecast* forecast);
/// The same for the window's current settings, which the render adopts a moment later.
[[nodiscard]] std::optional<TimeEstimate> time_estimate(const Previewer& previewer,
                                                        const Forecast* forecast);

/// The fraction of split pixels that every text of the window shows, for its current settings:
/// counted in the finished picture, or else estimated. None: neither exists.
[[nodiscard]] std::optional<double> shown_split_share(const Previewer& previewer,
                                                      const Forecast* forecast);

/// The displayed percentage of a render. The session's finished fraction stands still while its
/// estimate grows and while edges are searched. This one keeps growing, ever slower, and never
/// falls. It is 1 only once the render is finished. Not thread-safe.
class ShownProgress {
 public:
  /// Call once a frame. A change of `restarts` means a new render, which starts at 0.
  void update(const Progress& progress, std::optional<TimeEstimate> estimate,
              std::uint64_t restarts, double now_seconds);
  [[nodiscard]] double fraction() const { return fraction_; }

 private:
  std::uint64_t restarts_ = 0;
  double now_seconds_ = 0.0;
  double fraction_ = 0.0;
};

}  // namespace asos::ui
