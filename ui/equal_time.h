#pragma once

#include "renderer/comparison/method.h"
#include "renderer/session/render_session.h"
#include "ui/stoppable_job.h"

#include <functional>
#include <optional>
#include <string>

namespace asos {

/// A picture by another method that took about as long as the one in the window.
struct EqualTimeFrame {
  Film film;
  std::string summary;  ///< method, samples or EPS, and times, in a line
};

/// Whether a method's quality has one measure: its number of samples, or EPS.
[[nodiscard]] bool can_be_timed(const MethodRow& method);

/// Renders the view by such a method, as well as it can in `seconds` of processor time, which
/// quicker renders before it tell. Nothing once `stop` says so.
[[nodiscard]] std::optional<EqualTimeFrame> render_in_time(Snapshot snapshot, Method method,
                                                           double seconds,
                                                           const std::function<bool()>& stop);

/// The processor time of a finished picture's pixels.
[[nodiscard]] double processor_seconds(const Film& film);

using EqualTimeJob = StoppableJob<EqualTimeFrame>;

}  // namespace asos
