#pragma once

#include "renderer/comparison/method.h"
#include "renderer/session/render_session.h"
#include "ui/stoppable_job.h"

#include <functional>
#include <optional>
#include <string>

namespace asos::ui {

/// Another method's picture that took about as much CPU time as the one in the window.
struct EqualTimeFrame {
  Film film;
  std::string name;     ///< see snapshot_name
  std::string summary;  ///< method, samples or EPS, and times, in one line
};

/// Whether the quality of a method has a single parameter: its sample count, or EPS.
[[nodiscard]] bool can_be_timed(const MethodRow& method);

/// The progress of a comparison, or its result.
struct EqualTimeNews {
  std::optional<EqualTimeFrame> frame;  ///< at the end
  std::string doing;                    ///< the render's quality: "19 spp"
  double fraction = 0.0;                ///< of this render, 0 to 1
};
using TellEqualTime = std::function<void(EqualTimeNews)>;

/// Renders the view by a method that can_be_timed at the best quality that fits into `seconds` of
/// CPU time, found by quicker trial renders. `tell` (may be empty) is called with each render's
/// progress. Returns nothing if `stop` returned true.
[[nodiscard]] std::optional<EqualTimeFrame> render_in_time(Snapshot snapshot, Method method,
                                                           double seconds,
                                                           const std::function<bool()>& stop,
                                                           const TellEqualTime& tell = {});

/// CPU time of a finished picture's pixels.
[[nodiscard]] double processor_seconds(const Film& film);

using EqualTimeJob = StoppableJob<EqualTimeNews>;

}  // namespace asos::ui
