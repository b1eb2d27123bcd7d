#pragma once

#include "renderer/session/render_session.h"
#include "ui/stoppable_job.h"

#include <functional>
#include <optional>
#include <string>

namespace asos {

/// A picture by another method that took about as long as the one in the window.
struct EqualTimeFrame {
  Film film;
  std::string summary;  ///< method, samples and times, in a line
};

/// Renders the view by a method whose only setting is its number of samples: as many as take
/// `seconds` of processor time, told by a render with one. Nothing once `stop` says so.
[[nodiscard]] std::optional<EqualTimeFrame> render_in_time(Snapshot snapshot, Method method,
                                                           double seconds,
                                                           const std::function<bool()>& stop);

/// The processor time of a finished picture's pixels.
[[nodiscard]] double processor_seconds(const Film& film);

using EqualTimeJob = StoppableJob<EqualTimeFrame>;

}  // namespace asos
