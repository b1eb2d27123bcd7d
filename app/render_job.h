#pragma once

#include "app/interrupt.h"
#include "app/progress_bar.h"
#include "renderer/session/render_session.h"

#include <optional>

namespace asos {

/// Renders `snapshot` to the end or to the limit of time (FilmRender), drawing progress, from the
/// calling thread. With a limit, an interrupt ends it early. nullopt: interrupted without a limit,
/// or the scene's boundaries could not be found.
[[nodiscard]] std::optional<RenderResult> run_render_job(
    Snapshot snapshot, ProgressBar& bar, const InterruptGuard& interrupt,
    std::optional<double> time_limit_seconds = {});

}  // namespace asos
