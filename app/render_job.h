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
};

/// Renders `snapshot` to the end, drawing progress, from the calling thread. nullopt: interrupted.
[[nodiscard]] std::optional<RenderedPicture> run_render_job(Snapshot snapshot, ProgressBar& bar,
                                                            const InterruptGuard& interrupt);

/// Refuses pictures that this machine's memory cannot hold, before anything is allocated.
[[nodiscard]] Result<void> check_picture_fits(const RenderSettings& settings);

}  // namespace asos
