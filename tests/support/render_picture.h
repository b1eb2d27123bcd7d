#pragma once

#include "renderer/methods/method.h"

#include <algorithm>

namespace asos::test {

struct Picture {
  Film film;
  RenderStatistics statistics;
};

/// A whole picture, block by block.
inline Picture render_picture(const RenderScene& scene, const Camera& camera,
                              const RenderSettings& settings) {
  const int width = settings.width;
  const int height = settings.height;
  const View view(camera, width, height);
  const int side = block_side(settings);
  Picture picture{Film(width, height), {}};
  for (int y = 0; y < height; y += side) {
    for (int x = 0; x < width; x += side) {
      const PixelRect rect{x, y, std::min(side, width - x), std::min(side, height - y)};
      const BlockResult block = render_block(scene, view, settings, rect);
      picture.film.put(block.tile);
      picture.statistics += block.statistics;
    }
  }
  return picture;
}

/// The scene's first camera, or one that frames it.
inline Camera first_camera(const World& world, double aspect) {
  return world.cameras.empty() ? default_camera(world, aspect) : world.cameras.front();
}

}  // namespace asos::test
