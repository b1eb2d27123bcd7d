#pragma once

#include "renderer/shading/texture_filter.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <utility>

namespace asos::test {

/// A triangle whose (b1, b2) are its (u, v), with one texture.
struct Textured {
  World world;
  MipChains mips;
  TextureUse use;

  explicit Textured(Image image, Wrap wrap = Wrap::repeat, Filter filter = Filter::linear,
                    AlphaMode alpha = AlphaMode::opaque) {
    Material m = test::matte(glm::vec3(1));
    m.alpha_mode = alpha;
    use.texture = test::add_texture(world, std::move(image), wrap, filter);
    m.base_color_texture = m.metallic_roughness_texture = m.normal_texture = use;
    test::add_triangle(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, m);
    mips = MipChains(world, find_render_features(world));
  }

  [[nodiscard]] glm::vec4 look(TexelKind kind, glm::vec2 uv, glm::vec2 right,
                               glm::vec2 down) const {
    return filtered_texture(world, mips, use, {kind}, {0, uv.x, uv.y, {right, down}});
  }
};

}  // namespace asos::test
