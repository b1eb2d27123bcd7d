#include "renderer/shading/level_patch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asos {
namespace {

/// Shortens an edge by the variance that filtering adds to w^2 / 12, that of the edge. A tent of
/// texels that are boxes themselves adds 1/4 squared texel; the finest level's tent would have
/// added 1/6 of its own squared texel.
glm::vec2 less_of_texels(glm::vec2 edge, float texels) {
  const float length2 = glm::dot(edge, edge);
  if (!(length2 > 1e-30f)) return {};  // avoids a division by zero
  const float left2 = length2 + 2.0f / (texels * texels) - 3.0f;
  return edge * std::sqrt(std::max(left2, thinnest_patch * thinnest_patch) / length2);
}

/// Returns about how many texels the patch covers.
float held(const TexelPatch& patch) {
  return (glm::length(patch.right) + 2.0f) * (glm::length(patch.down) + 2.0f);
}

/// Returns the patch with both edges long enough for an area, and short enough for the number of
/// texels. The latter matters where even the coarsest level is too fine: there the texture repeats.
TexelPatch bounded(TexelPatch patch, float least, float most) {
  const float longest = held(patch) > most ? std::sqrt(most) : most;
  const auto within = [&](glm::vec2 edge, glm::vec2 other) {
    const float length = glm::length(edge);
    if (length >= least) return edge * std::min(1.0f, longest / length);
    return least / glm::length(other) * glm::vec2(-other.y, other.x);
  };
  const bool right_first = glm::length(patch.right) >= glm::length(patch.down);
  if (!right_first) std::swap(patch.right, patch.down);
  patch.down = within(patch.down, patch.right);
  patch.right = within(patch.right, patch.down);
  if (!right_first) std::swap(patch.right, patch.down);
  return patch;
}

}  // namespace

LevelPatch patch_in(std::size_t levels, const Image& image, Filter filter, TexelPatch patch,
                    TexelBudget budget) {
  const bool nearest = filter == Filter::nearest;
  const float longest = patch.longest();
  const float squares = glm::dot(patch.right, patch.right) + glm::dot(patch.down, patch.down);
  if (!(longest > (nearest ? least_nearest_footprint : least_footprint)) || !std::isfinite(squares))
    return {};
  if (longest > longest_patch_edge) {
    const float shorter = longest_patch_edge / longest;
    patch = {shorter * patch.right, shorter * patch.down};
  }
  if (patch.area() < 0.5f * glm::length(patch.right) * glm::length(patch.down))
    patch = principal_axes(patch);
  LevelPatch found{0, patch};
  for (std::size_t level = 1; level <= levels; ++level) {
    const glm::vec2 scale = scale_of_level(level, image.width, image.height);
    const TexelPatch coarser{scale * patch.right, scale * patch.down};
    const float width = std::min(glm::length(coarser.right), glm::length(coarser.down));
    if (width < budget.across && held(found.patch) <= budget.most) break;
    found = {level, coarser};
  }
  if (found.level > 0) {
    const float texels = std::ldexp(1.0f, static_cast<int>(found.level));
    found.patch.right = less_of_texels(found.patch.right, texels);
    found.patch.down = less_of_texels(found.patch.down, texels);
  }
  const bool in_areas = nearest && found.level == 0;
  found.patch =
      bounded(found.patch, in_areas ? 0.1f * least_nearest_footprint : thinnest_patch, budget.most);
  return found;
}

LevelPatch coarser(const LevelPatch& patch, const Texels& finest) {
  const glm::vec2 scale = scale_of_level(1, finest.width, finest.height);
  return {1, bounded({less_of_texels(scale * patch.patch.right, 2.0f),
                      less_of_texels(scale * patch.patch.down, 2.0f)},
                     thinnest_patch, TexelBudget().most)};
}

}  // namespace asos
