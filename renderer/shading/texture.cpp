#include "renderer/shading/texture.h"

#include "renderer/shading/bilinear.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {
namespace {

float decoded(double x, Encoding encoding) {
  const double linear = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  return static_cast<float>(encoding == Encoding::srgb ? linear : x);
}

std::array<float, 256> make_decode_table(Encoding encoding) {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = decoded(static_cast<double>(i) / 255.0, encoding);
  return table;
}

/// Returns the decoding table of 16-bit values, which is computed at first use.
const float* wide_table(Encoding encoding) {
  static const auto tables = [] {
    std::array<std::vector<float>, 2> made;
    for (const Encoding one : {Encoding::srgb, Encoding::linear}) {
      std::vector<float>& table = made[static_cast<std::size_t>(one)];
      for (int i = 0; i < 65536; ++i) table.push_back(decoded(i / 65535.0, one));
    }
    return made;
  }();
  return tables[static_cast<std::size_t>(encoding)].data();
}

const std::array<float, 256> srgb_table = make_decode_table(Encoding::srgb);
const std::array<float, 256> linear_table = make_decode_table(Encoding::linear);

}  // namespace

float srgb_byte_to_linear(std::uint8_t byte) {
  return srgb_table[byte];
}

Texels::Texels(const Image& image, Encoding encoding)
    : width(image.width),
      height(image.height),
      bytes_(image.rgba.data()),
      low_(image.low.data()),
      color_(low_                         ? wide_table(encoding)
             : encoding == Encoding::srgb ? srgb_table.data()
                                          : linear_table.data()),
      alpha_(low_ ? wide_table(Encoding::linear) : linear_table.data()) {}

glm::vec4 Texels::of_16_bits(std::size_t texel) const {
  const auto value = [&](std::size_t c) {
    return static_cast<std::size_t>(bytes_[texel + c]) << 8 | low_[texel + c];
  };
  return {color_[value(0)], color_[value(1)], color_[value(2)], alpha_[value(3)]};
}

glm::vec4 sample_texture(const World& world, int texture, glm::vec2 uv, Encoding encoding) {
  const Image* image = image_of(world, texture);
  if (!image) return glm::vec4(1.0f);
  const Texture& t = world.textures[static_cast<std::size_t>(texture)];
  const Texels texels(*image, encoding);
  return t.filter == Filter::nearest ? nearest(texels, uv, t.wrap_u, t.wrap_v)
                                     : bilinear(texels, uv, t.wrap_u, t.wrap_v);
}

CornerTexcoords corner_texcoords(const World& world, int set, std::uint32_t triangle) {
  if (world.is_face(triangle)) return {{0, 0}, {1, 0}, {0, 1}};
  if (set < 0 || set > 1 || world.texcoords[set].empty()) return {};
  const auto& uv = world.texcoords[set];
  const glm::uvec3 v = world.triangles[triangle];
  return {uv[v.x], uv[v.y], uv[v.z]};
}

glm::vec2 texcoord_at(const World& world, int set, std::uint32_t triangle, float b1, float b2) {
  const CornerTexcoords uv = corner_texcoords(world, set, triangle);
  return (1.0f - b1 - b2) * uv.at_0 + b1 * uv.at_1 + b2 * uv.at_2;
}

glm::vec4 sample_texture(const World& world, const TextureUse& use, std::uint32_t triangle,
                         float b1, float b2, Encoding encoding) {
  const glm::vec2 uv = texcoord_at(world, use.texcoord, triangle, b1, b2);
  return sample_texture(world, use.texture, glm::vec2(use.uv_transform * glm::vec3(uv, 1.0f)),
                        encoding);
}

}  // namespace asos
