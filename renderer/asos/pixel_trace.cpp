#include "renderer/asos/pixel_trace.h"

#include "renderer/asos/asos.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace asos {

PixelTrace trace_pixel(const RenderScene& scene, const View& view, const RenderSettings& asked,
                       int x, int y) {
  const RenderSettings settings = as_published(asked);
  const int fat = settings.asos.fat;
  PixelRect block{x / fat * fat, y / fat * fat, fat, fat};
  block.width = std::min(fat, view.width() - block.x);
  block.height = std::min(fat, view.height() - block.y);
  PixelWatch watch;
  watch.pixel = {x, y};
  const BlockResult result = render_fat_pyray({scene, view, settings, block}, &watch);
  const auto i = static_cast<std::size_t>((y - block.y) * block.width + x - block.x);
  TracedPyray& pixel = watch.observer.pixel;
  return {x,
          y,
          pixel.result,
          std::move(pixel.levels),
          std::move(pixel.cells),
          std::move(watch.observer.nested),
          watch.unresolved_area,
          result.tile.split_level[i],
          result.tile.cause[i],
          result.tile.outlook[i].samples,
          watch.missed};
}

}  // namespace asos
