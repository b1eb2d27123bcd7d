#pragma once

#include "app/interrupt.h"
#include "app/progress_bar.h"
#include "renderer/result.h"
#include "renderer/session/render_session.h"

#include <optional>

namespace asos {

/// A finished picture, as large as the settings' crop where they have one.
struct RenderedPicture {
  Film film;
  RenderStatistics statistics;
  double seconds = 0.0;
  int threads = 0;  ///< that worked
  /// How far all of it has come at least, where the limit of time ended it.
  std::optional<Reached> stopped_at;
};

/// Renders `snapshot` to the end, drawing progress, from the calling thread. nullopt: interrupted,
/// or the scene's boundaries could not be found.
/// With a limit, in seconds of rendering, the picture comes in passes and is what they have made of
/// it by then: at the least a sample for each block, which takes a fraction of a second.
[[nodiscard]] std::optional<RenderedPicture> run_render_job(
    Snapshot snapshot, ProgressBar& bar, const InterruptGuard& interrupt,
    std::optional<double> time_limit_seconds = {});

/// Refuses pictures that this machine's memory cannot hold, before anything is allocated.
[[nodiscard]] Result<void> check_picture_fits(const RenderSettings& settings);

}  // namespace asos
