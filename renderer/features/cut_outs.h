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

/// The budget for the outlines of a scene's cut-outs. A part that does not fit into the remaining
/// budget has no outline and is left to samples. The result depends only on the scene and the
/// budget.
struct CutOutBudget {
  std::size_t lines = std::size_t{1} << 21;  ///< some 130 MB with their hierarchy
  std::size_t looks = std::size_t{1} << 25;  ///< visited rows and cells of a texture's plane
};

/// The outlines of cut-outs in a world's masked surfaces (glTF 2.0 section 3.9.4, alphaMode MASK).
/// They are the curve at which the alpha that rays test equals the cut-off, as straight pieces.
struct CutOuts {
  std::vector<glm::vec3> positions;
  std::vector<CutOutLine> lines;  ///< ordered by their triangles; connected ends share a position
  /// By surface. 1: `lines` contains all outlines of its cut-outs. 0: it is not masked, or its
  /// cut-outs have no lines. Without lines are analytic shapes with textures, triangles whose
  /// vertices' alpha differs, whose texture coordinates span no area or whose contours are endless,
  /// and parts beyond the budget. Empty without masked surfaces.
  std::vector<std::uint8_t> outlined;
  /// One entry per triangle; bit k: the whole side from corner k to the next is cut out. As long as
  /// `outlined`.
  std::vector<std::uint8_t> hidden_sides;
};

/// Throws SearchStopped once `stop` is requested.
[[nodiscard]] CutOuts find_cut_outs(const World& world, const CutOutBudget& budget = {},
                                    const std::stop_token& stop = {});

}  // namespace asos
