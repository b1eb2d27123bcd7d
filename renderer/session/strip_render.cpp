#include "renderer/session/strip_render.h"

#include "renderer/comparison/method.h"
#include "renderer/session/film_render.h"
#include "renderer/session/work_plan.h"

#include <algorithm>
#include <utility>

namespace asos {
namespace {

/// Whole groups, so that no group is rendered for two strips.
int rows_of(int width, int strip_pixels) {
  return std::max(1, strip_pixels / width / group_size) * group_size;
}

}  // namespace

Result<StripsEnd> render_strips(const Snapshot& snapshot, PictureWriter& writer,
                                const std::stop_token& stop,
                                const std::function<void(double)>& on_progress, int strip_pixels) {
  if (const auto valid = validated(snapshot.settings); !valid) return unexpected(valid.error());
  if (const auto able = check_method(*snapshot.scene, snapshot.settings); !able)
    return unexpected(able.error());
  const PixelRect whole = snapshot.settings.visible();
  FilmRender render;
  const int bottom = whole.y + whole.height;
  for (int y = whole.y; y < bottom;) {
    // Strips end at the ends of groups, whatever row the crop begins with.
    const int rows = rows_of(whole.width, strip_pixels);
    const PixelRect strip{whole.x, y, whole.width, std::min(bottom, (y / rows + 1) * rows) - y};
    Snapshot part = snapshot;
    part.settings.crop = strip;
    const auto go_on = [&] { return !stop.stop_requested(); };
    const auto tell = [&](const Progress& progress) {
      if (on_progress) on_progress((y - whole.y + progress.fraction * strip.height) / whole.height);
    };
    const auto rendered = render.render(std::move(part), go_on, tell);
    if (!rendered) return StripsEnd::stopped;
    const Film& film = rendered->film;
    if (const auto written = writer.add_rows(film.radiance, film.coverage, film.unlit); !written)
      return unexpected(written.error());
    y += strip.height;
  }
  return StripsEnd::finished;
}

}  // namespace asos
