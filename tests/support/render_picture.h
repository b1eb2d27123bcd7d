#pragma once

#include "renderer/comparison/method.h"

#include <algorithm>

namespace asos::test {

struct Picture {
  Film film;
  RenderStatistics statistics;
};

/// Renders a picture block by block. With a crop, only the blocks that it touches; outside it the
/// picture is black.
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
      const PixelRect seen = settings.visible();
      if (x >= seen.x + seen.width || y >= seen.y + seen.height || x + rect.width <= seen.x ||
          y + rect.height <= seen.y)
        continue;
      const BlockResult block = render_block(scene, view, settings, rect);
      picture.film.put(block.tile);
      picture.statistics += block.statistics;
    }
  }
  const PixelRect seen = settings.visible();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (intersection(seen, {x, y, 1, 1}).empty())
        picture.film.radiance[picture.film.index(x, y)] = glm::vec3(0.0f);
  return picture;
}

/// The scene's first camera, or one that frames it.
inline Camera first_camera(const World& world, double aspect) {
  return world.cameras.empty() ? default_camera(world, aspect) : world.cameras.front();
}

}  // namespace asos::test
