#include "renderer/shading/texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace asos {
namespace {

std::array<float, 256> make_decode_table(Encoding encoding) {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double x = static_cast<double>(i) / 255.0;
    const double linear = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    table[i] = static_cast<float>(encoding == Encoding::srgb ? linear : x);
  }
  return table;
}

const std::array<float, 256> srgb_table = make_decode_table(Encoding::srgb);
const std::array<float, 256> linear_table = make_decode_table(Encoding::linear);

/// Takes a coordinate to [0, 1], before it is scaled to texels. Done in this order, and not on
/// texel indices, so that no coordinate overflows an integer.
float wrapped(float x, Wrap wrap) {
  if (!std::isfinite(x)) return 0.0f;
  switch (wrap) {
    case Wrap::repeat:
      return x - std::floor(x);
    case Wrap::mirrored_repeat: {
      const float t = x - 2.0f * std::floor(0.5f * x);  // 0 to 2
      return t <= 1.0f ? t : 2.0f - t;
    }
    case Wrap::clamp_to_edge:
      break;
  }
  return std::clamp(x, 0.0f, 1.0f);
}

/// A texel's index that may lie one step outside 0..size-1, as bilinear neighbours do.
int wrapped_neighbour(int i, int size, Wrap wrap) {
  if (i >= 0 && i < size) return i;
  if (wrap == Wrap::repeat) return i < 0 ? size - 1 : 0;
  return i < 0 ? 0 : size - 1;  // a mirror shows the edge texel again
}

struct Texels {
  const Image& image;
  const std::array<float, 256>& colour;

  [[nodiscard]] glm::vec4 at(int x, int y) const {
    const std::size_t index =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
             static_cast<std::size_t>(x));
    const std::uint8_t* p = image.rgba.data() + index;
    return {colour[p[0]], colour[p[1]], colour[p[2]], linear_table[p[3]]};
  }
};

}  // namespace

float srgb_byte_to_linear(std::uint8_t byte) {
  return srgb_table[byte];
}

glm::vec4 sample_texture(const World& world, int texture, glm::vec2 uv, Encoding encoding) {
  constexpr glm::vec4 missing{1.0f};
  if (texture < 0 || static_cast<std::size_t>(texture) >= world.textures.size()) return missing;
  const Texture& t = world.textures[static_cast<std::size_t>(texture)];
  if (t.image < 0 || static_cast<std::size_t>(t.image) >= world.images.size()) return missing;
  const Image& image = world.images[static_cast<std::size_t>(t.image)];
  if (image.width <= 0 || image.height <= 0 || image.rgba.empty()) return missing;

  const Texels texels{image, encoding == Encoding::srgb ? srgb_table : linear_table};
  const float x = wrapped(uv.x, t.wrap_u) * static_cast<float>(image.width);
  const float y = wrapped(uv.y, t.wrap_v) * static_cast<float>(image.height);
  if (t.filter == Filter::nearest) {
    return texels.at(std::min(static_cast<int>(x), image.width - 1),
                     std::min(static_cast<int>(y), image.height - 1));
  }

  // Texel centres lie at half integers.
  const float x0 = std::floor(x - 0.5f);
  const float y0 = std::floor(y - 0.5f);
  const float fx = x - 0.5f - x0;
  const float fy = y - 0.5f - y0;
  const int left = wrapped_neighbour(static_cast<int>(x0), image.width, t.wrap_u);
  const int right = wrapped_neighbour(static_cast<int>(x0) + 1, image.width, t.wrap_u);
  const int top = wrapped_neighbour(static_cast<int>(y0), image.height, t.wrap_v);
  const int bottom = wrapped_neighbour(static_cast<int>(y0) + 1, image.height, t.wrap_v);
  return glm::mix(glm::mix(texels.at(left, top), texels.at(right, top), fx),
                  glm::mix(texels.at(left, bottom), texels.at(right, bottom), fx), fy);
}

glm::vec2 texcoord_at(const World& world, int set, std::uint32_t triangle, float b1, float b2) {
  if (set < 0 || set > 1 || world.texcoords[set].empty()) return glm::vec2(0.0f);
  const auto& uv = world.texcoords[set];
  const glm::uvec3 v = world.triangles[triangle];
  return (1.0f - b1 - b2) * uv[v.x] + b1 * uv[v.y] + b2 * uv[v.z];
}

glm::vec4 sample_texture(const World& world, const TextureUse& use, std::uint32_t triangle,
                         float b1, float b2, Encoding encoding) {
  const glm::vec2 uv = texcoord_at(world, use.texcoord, triangle, b1, b2);
  return sample_texture(world, use.texture, glm::vec2(use.uv_transform * glm::vec3(uv, 1.0f)),
                        encoding);
}

}  // namespace asos
