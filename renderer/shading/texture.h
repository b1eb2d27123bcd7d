#pragma once

#include "renderer/world/texture_image.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>

namespace asos {

/// The encoding of an image's RGB values. Alpha is always linear.
enum class Encoding { srgb, linear };

/// Returns the linear value of an sRGB-encoded byte.
[[nodiscard]] float srgb_byte_to_linear(std::uint8_t byte);

/// Linear access to an image's texels. The image has to outlive this.
class Texels {
 public:
  Texels(const Image& image, Encoding encoding);

  [[nodiscard]] glm::vec4 at(int x, int y) const {
    const std::size_t texel = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                   static_cast<std::size_t>(x));
    if (low_) return of_16_bits(texel);
    const std::uint8_t* p = bytes_ + texel;
    return {color_[p[0]], color_[p[1]], color_[p[2]], alpha_[p[3]]};
  }

  int width;
  int height;

 private:
  [[nodiscard]] glm::vec4 of_16_bits(std::size_t texel) const;

  const std::uint8_t* bytes_;
  const std::uint8_t* low_;  // null: texels of 8 bits
  const float* color_;       // by byte, or by 16-bit value
  const float* alpha_;
};

/// Looks up a texture at (u, v): the nearest texel, or the bilinear mean of four *linear* values
/// (decoded before mixing). Coordinates of any size wrap; those that are not finite read as 0.
/// Returns white if the texture or image is missing or empty. Point-sampled; filtered_texture
/// averages.
[[nodiscard]] glm::vec4 sample_texture(const World& world, int texture, glm::vec2 uv,
                                       Encoding encoding);

/// Looks up a texture at a point of a triangle through a material's use of it: selects the set of
/// coordinates and applies the use's transform. `use.used()` must hold.
[[nodiscard]] glm::vec4 sample_texture(const World& world, const TextureUse& use,
                                       std::uint32_t triangle, float b1, float b2,
                                       Encoding encoding);

/// Texture coordinates of a triangle's corners, or of the points (0, 0), (1, 0) and (0, 1) of an
/// analytic face; 0 where the set is missing.
struct CornerTexcoords {
  glm::vec2 at_0{0.0f}, at_1{0.0f}, at_2{0.0f};
};
[[nodiscard]] CornerTexcoords corner_texcoords(const World& world, int set, std::uint32_t triangle);

/// Returns the texture coordinates of a triangle's point, before any transform; 0 where the set is
/// missing.
[[nodiscard]] glm::vec2 texcoord_at(const World& world, int set, std::uint32_t triangle, float b1,
                                    float b2);

}  // namespace asos
