#include "renderer/shading/texture.h"

#include "renderer/shading/bilinear.h"

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

}  // namespace

float srgb_byte_to_linear(std::uint8_t byte) {
  return srgb_table[byte];
}

Texels::Texels(const Image& image, Encoding encoding)
    : width(image.width),
      height(image.height),
      bytes_(image.rgba.data()),
      color_(encoding == Encoding::srgb ? srgb_table.data() : linear_table.data()),
      alpha_(linear_table.data()) {}

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
