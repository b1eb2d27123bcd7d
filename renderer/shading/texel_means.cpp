#include "renderer/shading/texel_means.h"

namespace asos {
namespace {

/// Visits a grid of points of a patch, half a texel apart and at least `fewest` along each edge. A
/// point is its offset from the patch's centre, in texels. Returns their number.
template <typename Visit>
int for_each_point(const TexelPatch& patch, int fewest, const Visit& visit) {
  const auto count = [fewest](glm::vec2 edge) {
    return std::max(fewest, 1 + static_cast<int>(2.0f * glm::length(edge)));
  };
  const int across = count(patch.right), along = count(patch.down);
  for (int y = 0; y < along; ++y) {
    for (int x = 0; x < across; ++x) {
      const auto middle = [](int i, int n) {
        return (static_cast<float>(i) + 0.5f) / static_cast<float>(n) - 0.5f;
      };
      visit(middle(x, across) * patch.right + middle(y, along) * patch.down);
    }
  }
  return across * along;
}

}  // namespace

glm::vec4 mean_of_points(const Texels& texels, glm::vec2 uv, const TexelPatch& patch,
                         const Texture& texture) {
  const TexelBlock block(texels, uv, patch, texture);
  Channels sum{};
  const int count = for_each_point(patch, 1, [&](glm::vec2 off) { sum += block.at(off); });
  return vec4_of(sum / static_cast<float>(count));
}

glm::vec4 mean_of_seen(const Texels& texels, std::optional<float> cutoff, glm::vec2 uv,
                       const TexelPatch& patch, const Texture& texture) {
  const TexelBlock block(texels, uv, patch, texture);
  Channels sum{}, seen{};
  const int count = for_each_point(patch, 2, [&](glm::vec2 off) {
    const Channels texel = block.at(off);
    const float share = cutoff ? (texel[3] >= *cutoff ? 1.0f : 0.0f) : texel[3];
    sum += texel;
    seen += share * Channels{texel[0], texel[1], texel[2], 1.0f};
  });
  const float alpha = sum[3] / static_cast<float>(count);
  const glm::vec4 colour =
      vec4_of(seen[3] > 0.0f ? seen / seen[3] : sum / static_cast<float>(count));
  return {glm::vec3(colour), alpha};
}

MeanNormal mean_of_normals(const Texels& texels, glm::vec2 uv, const TexelPatch& patch,
                           const Texture& texture) {
  const TexelBlock block(texels, uv, patch, texture);
  glm::vec3 sum(0.0f);
  const int count =
      for_each_point(patch, 2, [&](glm::vec2 off) { sum += unit_normal(vec4_of(block.at(off))); });
  const glm::vec3 mean = sum / static_cast<float>(count);
  return {0.5f + 0.5f * mean, std::max(0.0f, 1.0f - glm::dot(mean, mean))};
}

}  // namespace asos
