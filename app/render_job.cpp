#include "app/render_job.h"

#include "renderer/session/film_render.h"

#include <utility>

namespace asos {

std::optional<RenderResult> run_render_job(Snapshot snapshot, ProgressBar& bar,
                                           const InterruptGuard& interrupt,
                                           std::optional<double> time_limit_seconds) {
  FilmRender render;
  const bool in_passes = time_limit_seconds.has_value();
  std::optional<RenderResult> result = render.render(
      std::move(snapshot), [&] { return in_passes || !interrupt.interrupted(); },
      [&](const Progress& progress) { bar.show(progress); }, time_limit_seconds,
      [&] { return interrupt.interrupted(); });
  if (result) bar.wipe();
  return result;
}

}  // namespace asos
