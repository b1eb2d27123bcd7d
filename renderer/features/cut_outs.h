#pragma once

#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace asos {

/// A straight piece of a cut-out's outline on a triangle; its ends index CutOuts::positions.
struct CutOutLine {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t triangle = 0;
};

/// How much the outlines of a scene's cut-outs may cost. A part that does not fit into what those
/// before it have left has none and is left to samples, so the result depends on nothing else.
struct CutOutBudget {
  std::size_t lines = std::size_t{1} << 21;  ///< some 130 MB with their hierarchy
  std::size_t looks = std::size_t{1} << 25;  ///< at rows and cells of a texture's plane
};

/// The outlines of what textures cut out of a world's masked surfaces (glTF 2.0 section 3.9.4,
/// alphaMode MASK): the curve at which the alpha that rays test is the cut-off, as straight pieces.
struct CutOuts {
  std::vector<glm::vec3> positions;
  std::vector<CutOutLine> lines;  ///< ordered by their triangles; joined ends share a position
  /// By surface, 1: what is cut out of it lies within `lines` alone. 0: it is no masked surface, or
  /// its cut-outs have no lines: those of analytic shapes, where the vertices' alpha differs, where
  /// texture coordinates span no area or are endless, and of what the budget leaves out. Empty
  /// without masked surfaces.
  std::vector<std::uint8_t> outlined;
  /// By triangle, bit k: all of the side from corner k to the next is cut out. As long as
  /// `outlined`.
  std::vector<std::uint8_t> hidden_sides;
};

/// Throws SearchStopped once `stop` is requested.
[[nodiscard]] CutOuts find_cut_outs(const World& world, const CutOutBudget& budget = {},
                                    const std::stop_token& stop = {});

}  // namespace asos
