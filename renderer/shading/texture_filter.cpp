#include "renderer/shading/texture_filter.h"

#include "renderer/shading/bilinear.h"
#include "renderer/shading/texture.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

/// Where to look: `count` taps from `first` on, each a mix of two levels.
struct Taps {
  int count = 0;  ///< 0: the footprint is within a texel
  glm::vec2 first{0.0f};
  glm::vec2 step{0.0f};
  std::size_t level = 0;
  float coarser = 0.0f;  ///< share of level + 1
};

/// The ellipse with a parallelogram's variances: its longer axis, and the length of its shorter.
struct Ellipse {
  glm::vec2 longer{0.0f};
  float shorter = 0.0f;
};

Ellipse ellipse_of(glm::vec2 a, glm::vec2 b) {
  // Eigenvalues and the larger one's eigenvector of a a^T + b b^T.
  const float xx = a.x * a.x + b.x * b.x;
  const float yy = a.y * a.y + b.y * b.y;
  const float xy = a.x * a.y + b.x * b.y;
  const float half = 0.5f * (xx - yy);
  const float root = std::sqrt(half * half + xy * xy);
  const float large = 0.5f * (xx + yy) + root;
  const float area = std::abs(a.x * b.y - a.y * b.x);  // the product of both axes
  const glm::vec2 axis = half > 0.0f ? glm::vec2(half + root, xy) : glm::vec2(xy, root - half);
  const float length2 = glm::dot(axis, axis);
  const float longer = std::sqrt(large);
  return {length2 > 0.0f ? axis * (longer / std::sqrt(length2)) : glm::vec2(longer, 0.0f),
          area / longer};
}

Taps taps_at(const Image& image, const MipChain& chain, glm::vec2 uv, glm::vec2 a, glm::vec2 b) {
  const glm::vec2 size(image.width, image.height);
  a *= texel_share * size;
  b *= texel_share * size;
  const float bound = glm::dot(a, a) + glm::dot(b, b);
  if (bound <= 1.0f || !std::isfinite(bound * bound) || chain.empty()) return {};
  const Ellipse ellipse = ellipse_of(a, b);
  const float longer = glm::length(ellipse.longer);
  if (!(longer > 1.0f)) return {};

  // Texels as large as the shorter axis, or as few taps need.
  Taps taps;
  const float texel = std::max({1.0f, ellipse.shorter, longer / static_cast<float>(most_taps)});
  taps.count = std::clamp(static_cast<int>(std::ceil(longer / texel - 0.01f)), 1, most_taps);
  const float level = std::min(std::log2(texel), static_cast<float>(chain.size()));
  taps.level = static_cast<std::size_t>(level);
  taps.coarser = level - static_cast<float>(taps.level);
  taps.step = ellipse.longer / (texel_share * static_cast<float>(taps.count) * size);
  taps.first = uv - (0.5f * static_cast<float>(taps.count - 1)) * taps.step;
  return taps;
}

/// `bilinear` of a level, written for speed: most of a filtered lookup's time goes here.
glm::vec4 bilinear_tap(const MipLevel& level, glm::vec2 uv, Wrap wrap_u, Wrap wrap_v) {
  const TexelPlace p(level.width, level.height, uv, wrap_u, wrap_v);
  const std::uint16_t* texels[4] = {level.texel(p.left, p.top), level.texel(p.right, p.top),
                                    level.texel(p.left, p.bottom), level.texel(p.right, p.bottom)};
  const float low = MipLevel::unit * p.fy;
  const float high = MipLevel::unit - low;
  const float shares[4] = {high - high * p.fx, high * p.fx, low - low * p.fx, low * p.fx};
  glm::vec4 sum(0.0f);
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) sum[k] += shares[i] * static_cast<float>(texels[i][k]);
  }
  return sum;
}

/// The mean over the taps of what `look` sees at a place of a level.
template <typename Look>
glm::vec4 mean_of(const Taps& taps, const Look& look) {
  glm::vec4 sum(0.0f);
  for (int i = 0; i < taps.count; ++i) {
    const glm::vec2 uv = taps.first + static_cast<float>(i) * taps.step;
    glm::vec4 seen = look(taps.level, uv);
    if (taps.coarser > 0.0f) seen = glm::mix(seen, look(taps.level + 1, uv), taps.coarser);
    sum += seen;
  }
  return sum / static_cast<float>(taps.count);
}

glm::vec2 lookup_uv(const World& world, const TextureUse& use, const TexturePlace& place) {
  const glm::vec2 uv = texcoord_at(world, use.texcoord, place.triangle, place.b1, place.b2);
  return {use.uv_transform * glm::vec3(uv, 1.0f)};
}

Taps taps_for(const World& world, const MipChains& mips, const TextureUse& use, TexelKind kind,
              const TexturePlace& place, glm::vec2 uv) {
  if (place.footprint.point() || use.texcoord < 0 || use.texcoord > 1) return {};
  const Image* image = image_of(world, use.texture);
  if (!image) return {};
  if (!world.is_face(place.triangle) && world.texcoords[use.texcoord].empty()) return {};
  const CornerTexcoords at = corner_texcoords(world, use.texcoord, place.triangle);
  const Steps<glm::vec2> steps(place.footprint, at.at_0, at.at_1, at.at_2);
  const glm::mat2 turn(use.uv_transform);
  const Texture& texture = world.textures[static_cast<std::size_t>(use.texture)];
  return taps_at(*image, mips.chain(texture.image, kind), uv, turn * steps.right,
                 turn * steps.down);
}

/// A level of normals as moments: the mean and, last, the mean square, so that they may be mixed.
struct Moments {
  const MipLevel& level;
  int width = level.width;
  int height = level.height;

  [[nodiscard]] glm::vec4 at(int x, int y) const {
    const glm::vec4 texel = level.at(x, y);
    const glm::vec3 n = 2.0f * glm::vec3(texel) - 1.0f;
    return {n, texel.a + glm::dot(n, n)};
  }
};

}  // namespace

glm::vec4 filtered_texture(const World& world, const MipChains& mips, const TextureUse& use,
                           TexelKind kind, const TexturePlace& place) {
  const Encoding encoding = kind == TexelKind::data ? Encoding::linear : Encoding::srgb;
  const glm::vec2 uv = lookup_uv(world, use, place);
  const Taps taps = taps_for(world, mips, use, kind, place, uv);
  if (taps.count == 0) return sample_texture(world, use.texture, uv, encoding);
  const Texture& texture = world.textures[static_cast<std::size_t>(use.texture)];
  const MipChain& chain = mips.chain(texture.image, kind);
  return mean_of(taps, [&](std::size_t level, glm::vec2 at) {
    return level == 0 ? sample_texture(world, use.texture, at, encoding)
                      : bilinear_tap(chain[level - 1], at, texture.wrap_u, texture.wrap_v);
  });
}

MeanNormal filtered_normal(const World& world, const MipChains& mips, const TextureUse& use,
                           const TexturePlace& place) {
  const glm::vec2 uv = lookup_uv(world, use, place);
  const auto finest = [&](glm::vec2 at) {
    return glm::vec3(sample_texture(world, use.texture, at, Encoding::linear));
  };
  const Taps taps = taps_for(world, mips, use, TexelKind::normal, place, uv);
  if (taps.count == 0) return {finest(uv), 0.0f};
  const Texture& texture = world.textures[static_cast<std::size_t>(use.texture)];
  const MipChain& chain = mips.chain(texture.image, TexelKind::normal);
  const glm::vec4 moments = mean_of(taps, [&](std::size_t level, glm::vec2 at) {
    if (level > 0) return bilinear(Moments{chain[level - 1]}, at, texture.wrap_u, texture.wrap_v);
    const glm::vec3 n = 2.0f * finest(at) - 1.0f;
    const float length = glm::length(n);
    return glm::vec4(length > 0.0f ? n / length : n, 1.0f);
  });
  const glm::vec3 mean(moments);
  return {0.5f + 0.5f * mean, std::max(0.0f, moments.a - glm::dot(mean, mean))};
}

}  // namespace asos
