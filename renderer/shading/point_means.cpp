#include "renderer/shading/point_means.h"

#include "renderer/shading/bilinear.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

/// Visits a grid of points of a patch, half a texel apart and at least `fewest` along each edge. A
/// point is its offset from the patch's centre, in a texture of that size. Returns their number.
template <typename Visit>
int for_each_point(const TexelPatch& patch, int fewest, glm::vec2 size, const Visit& visit) {
  const auto count = [fewest](glm::vec2 edge) {
    return std::max(fewest, 1 + static_cast<int>(2.0f * glm::length(edge)));
  };
  const int across = count(patch.right), along = count(patch.down);
  for (int y = 0; y < along; ++y) {
    for (int x = 0; x < across; ++x) {
      const auto middle = [](int i, int n) {
        return (static_cast<float>(i) + 0.5f) / static_cast<float>(n) - 0.5f;
      };
      visit((middle(x, across) * patch.right + middle(y, along) * patch.down) / size);
    }
  }
  return across * along;
}

}  // namespace

glm::vec4 mean_of_points(const Texels& texels, glm::vec2 uv, const TexelPatch& patch,
                         const Texture& texture) {
  glm::vec4 sum(0.0f);
  const int count = for_each_point(
      patch, 1, glm::vec2(texels.width, texels.height),
      [&](glm::vec2 off) { sum += bilinear(texels, uv + off, texture.wrap_u, texture.wrap_v); });
  return sum / static_cast<float>(count);
}

glm::vec4 mean_of_seen(const Texels& texels, const TexelUse& use, glm::vec2 uv,
                       const TexelPatch& patch, const Texture& texture) {
  glm::vec4 sum(0.0f), seen(0.0f);
  const int count =
      for_each_point(patch, 2, glm::vec2(texels.width, texels.height), [&](glm::vec2 off) {
        const glm::vec4 texel = bilinear(texels, uv + off, texture.wrap_u, texture.wrap_v);
        const float share = use.cutoff ? (texel.a >= *use.cutoff ? 1.0f : 0.0f) : texel.a;
        sum += texel;
        seen += share * glm::vec4(glm::vec3(texel), 1.0f);
      });
  const float alpha = sum.a / static_cast<float>(count);
  const glm::vec3 colour =
      seen.a > 0.0f ? glm::vec3(seen) / seen.a : glm::vec3(sum) / static_cast<float>(count);
  return {colour, alpha};
}

MeanNormal mean_of_normals(const Texels& texels, glm::vec2 uv, const TexelPatch& patch,
                           const Texture& texture) {
  glm::vec3 sum(0.0f);
  const int count =
      for_each_point(patch, 2, glm::vec2(texels.width, texels.height), [&](glm::vec2 off) {
        sum += unit_normal(bilinear(texels, uv + off, texture.wrap_u, texture.wrap_v));
      });
  const glm::vec3 mean = sum / static_cast<float>(count);
  return {0.5f + 0.5f * mean, std::max(0.0f, 1.0f - glm::dot(mean, mean))};
}

}  // namespace asos
