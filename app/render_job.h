#pragma once

#include "app/interrupt.h"
#include "app/progress_bar.h"
#include "renderer/result.h"
#include "renderer/session/render_session.h"

#include <optional>

namespace asos {

/// A finished picture, of the size of the settings' crop if they have one.
struct RenderedPicture {
  Film film;
  RenderStatistics statistics;
  double seconds = 0.0;
  int threads = 0;  ///< that worked
  /// The pass that the whole picture has reached, if the time limit ended it.
  std::optional<Reached> stopped_at;
};

/// Renders `snapshot` and draws the progress, on the calling thread. Returns nullopt if it was
/// interrupted, or if searching the scene's edges ran out of memory. With a limit, in seconds of
/// rendering, the picture is rendered in passes and ends with what they have reached: at least one
/// sample per block, which takes a fraction of a second.
[[nodiscard]] std::optional<RenderedPicture> run_render_job(
    Snapshot snapshot, ProgressBar& bar, const InterruptGuard& interrupt,
    std::optional<double> time_limit_seconds = {});

/// Returns an error for pictures that do not fit into this machine's memory, before allocating.
[[nodiscard]] Result<void> check_picture_fits(const RenderSettings& settings);

}  // namespace asos
