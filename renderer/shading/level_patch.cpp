#include "renderer/shading/level_patch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asos {
namespace {

// Shorter edges are invisible; this length keeps areas above 0.
constexpr float thinnest = 1.0f / 32.0f;
// Nearest texels have sharp borders, however large they appear in the picture. Places closer than
// this do not differ in large textures.
constexpr float least_of_nearest = 1e-4f;
// Longer edges make no difference, since every texture repeats along them. Their fourth powers are
// still finite.
constexpr float longest_edge = 1e9f;

/// Shortens an edge by the variance that filtering adds to w^2 / 12, that of the edge. A tent of
/// texels that are boxes themselves adds 1/4 squared texel; the finest level's tent would have
/// added 1/6 of its own squared texel.
glm::vec2 less_of_texels(glm::vec2 edge, float texels) {
  const float length2 = glm::dot(edge, edge);
  if (!(length2 > 1e-30f)) return {};  // avoids a division by zero
  const float left2 = length2 + 2.0f / (texels * texels) - 3.0f;
  return edge * std::sqrt(std::max(left2, thinnest * thinnest) / length2);
}

/// Returns the size of a level of an image, relative to the image.
glm::vec2 scale_of(std::size_t level, int width, int height) {
  return {static_cast<float>(side_of_level(width, level)) / static_cast<float>(width),
          static_cast<float>(side_of_level(height, level)) / static_cast<float>(height)};
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
  if (!(longest > (nearest ? least_of_nearest : least_footprint)) || !std::isfinite(squares))
    return {};
  if (longest > longest_edge) {
    const float shorter = longest_edge / longest;
    patch = {shorter * patch.right, shorter * patch.down};
  }
  if (patch.area() < 0.5f * glm::length(patch.right) * glm::length(patch.down))
    patch = principal_axes(patch);
  LevelPatch found{0, patch};
  for (std::size_t level = 1; level <= levels; ++level) {
    const glm::vec2 scale = scale_of(level, image.width, image.height);
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
  found.patch = bounded(found.patch, in_areas ? 0.1f * least_of_nearest : thinnest, budget.most);
  return found;
}

LevelPatch coarser(const LevelPatch& patch, const Texels& finest) {
  const glm::vec2 scale = scale_of(1, finest.width, finest.height);
  return {1, bounded({less_of_texels(scale * patch.patch.right, 2.0f),
                      less_of_texels(scale * patch.patch.down, 2.0f)},
                     thinnest, TexelBudget().most)};
}

}  // namespace asos
