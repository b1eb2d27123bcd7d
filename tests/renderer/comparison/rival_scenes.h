#pragma once

#include "renderer/comparison/method.h"
#include "renderer/shading/environment.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"

#include <utility>

// Scenes of a few flat colours for an orthographic camera: 8 x 8 pixels, each 1 x 1 in the world.
// Pixel (x, y) covers x - 4 to x - 3 and 4 - y to 3 - y.

namespace asos::test {

inline constexpr PixelRect small_block{0, 0, 8, 8};

/// A rectangle given in pixels, at a height above the plane z = 0.
inline void add_card(World& world, glm::vec2 lo, glm::vec2 hi, const Material& material,
                     float z = 0.0f) {
  add_quad(world, {lo.x - 4.0f, 4.0f - hi.y, z}, {hi.x - lo.x, 0, 0}, {0, hi.y - lo.y, 0},
           material);
}

/// One colour left of a vertical line, another one right of it.
inline World two_colours(float x, glm::vec3 left, glm::vec3 right) {
  World world;
  add_card(world, {-9, -9}, {x, 17}, unlit(left));
  add_card(world, {x, -9}, {17, 17}, unlit(right));
  return world;
}

inline RenderSettings settings_for(Method method, int spp = 16, int size = 8) {
  return make_settings(size, size, method, spp);
}

inline BlockResult render_small(const RenderScene& scene, const RenderSettings& settings,
                                PixelRect block = small_block) {
  return render_block(scene, View(orthographic(8.0), 8, 8), settings, block);
}

inline float red_at(const BlockResult& result, int x, int y) {
  const PixelRect r = result.tile.rect;
  return result.tile.radiance[static_cast<std::size_t>((y - r.y) * r.width + x - r.x)].r;
}

}  // namespace asos::test
