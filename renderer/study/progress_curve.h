#pragma once

#include "renderer/session/render_session.h"

#include <functional>
#include <vector>

namespace asos {

/// The picture of a render at a moment.
struct TimedPicture {
  double seconds = 0.0;  ///< CPU time of the workers so far
  Film film;             ///< radiance alone
  Reached reached;
  Progress progress;
};

/// The pictures of a render, in the order of their times.
struct RecordedRender {
  std::vector<TimedPicture> pictures;
  bool finished = false;  ///< the last picture is the final one
};

/// Ratio between the times of successive pictures of a study.
inline constexpr double study_factor = 1.5;

/// Renders a snapshot and keeps intermediate pictures: the first that covers the whole picture
/// after 0.1 ms of CPU time, further ones each time this has grown by `factor`, and the final one.
/// Without the passes of a progressive render it keeps the final one only. The render ends once
/// `stop` returns true; its pictures so far are kept. Times are those of all threads of the process
/// except the calling one, so nothing else in the process should work at the same time. Apart from
/// the selection of moments, the result does not depend on the machine.
[[nodiscard]] RecordedRender watch_render(const Snapshot& snapshot, double factor,
                                          const std::function<bool()>& stop = {});

}  // namespace asos
