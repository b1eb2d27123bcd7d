#include "renderer/asos/texture_samples.h"

#include "renderer/sampling/random.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

/// Hashes a place of the picture, rounded to 2^-16 of a pixel. The hash does not depend on the
/// frame.
std::uint64_t bits_of(glm::dvec2 pixels, int seed) {
  const auto x = static_cast<std::int64_t>(std::llround(pixels.x * 65536.0));
  const auto y = static_cast<std::int64_t>(std::llround(pixels.y * 65536.0));
  const auto within = static_cast<std::uint32_t>((x & 0xffff) << 16 | (y & 0xffff));
  return mix_bits(pixel_random(static_cast<int>(x >> 16), static_cast<int>(y >> 16), within) ^
                  static_cast<std::uint64_t>(seed));
}

}  // namespace

bool is_textured(const Material& material, const RenderFeatures& render_features) {
  if (render_features.textures &&
      (material.base_color_texture.used() || material.transmission_texture.used()))
    return true;
  if (material.unlit) return false;
  return (render_features.textures &&
          (material.metallic_roughness_texture.used() || material.occlusion_texture.used() ||
           material.specular_texture.used() || material.specular_color_texture.used() ||
           material.coat.texture.used() || material.coat.roughness_texture.used() ||
           material.sheen.color_texture.used() || material.sheen.roughness_texture.used() ||
           material.anisotropy.texture.used() || material.film.texture.used() ||
           material.film.thickness_texture.used() || material.diffuse_transmission.texture.used() ||
           material.diffuse_transmission.color_texture.used())) ||
         (render_features.normal_maps && has_normal_map(material)) ||
         (render_features.emission && material.emissive_texture.used());
}

int texture_divisions(int texture_resolution, double side) {
  // Sides are powers of two up to the rounding of the frame's coordinates.
  return std::max(1, static_cast<int>(std::ceil(texture_resolution * side - 1e-3)));
}

std::vector<TexturePart> texture_parts(const Square& all, int n, const LeafPlace& place, int seed,
                                       bool jitter) {
  std::vector<TexturePart> parts;
  for (int i = 0; i < n * n; ++i) {
    const Square square = all.part(n, i);
    const glm::dvec2 corner = glm::dvec2(place.origin) +
                              static_cast<double>(place.width) * glm::dvec2(square.u, square.v);
    const RandomPair random = jitter ? unit_pair(bits_of(corner, seed)) : RandomPair{0.5, 0.5};
    const glm::vec2 at(square.u + square.side * static_cast<float>(random.u),
                       square.v + square.side * static_cast<float>(random.v));
    parts.push_back({square, at});
  }
  return parts;
}

}  // namespace asos
