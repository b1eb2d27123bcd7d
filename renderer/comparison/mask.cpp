#include "renderer/comparison/block_facets.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace asos {

namespace {

constexpr int mask_side = 8;

using CoverageMask = std::uint64_t;

glm::dvec2 mask_point(const FrameRectangle& square, int bit) {
  const glm::dvec2 share(bit % mask_side + 0.5, bit / mask_side + 0.5);
  return square.lo + share / double{mask_side} * (square.hi - square.lo);
}

// Returns the points of the pixel that a facet covers.
CoverageMask mask_of(const Facet& facet, const FrameRectangle& square) {
  CoverageMask mask = 0;
  for (int bit = 0; bit < mask_side * mask_side; ++bit) {
    const glm::dvec2 p = mask_point(square, bit);
    const bool inside = std::all_of(facet.inside.begin(), facet.inside.end(),
                                    [&](const HalfPlane& h) { return h.depth(p) >= 0.0; });
    if (inside) mask |= CoverageMask{1} << bit;
  }
  return mask;
}

bool meets(const Facet& facet, const FrameRectangle& square) {
  const std::array corners{square.lo, glm::dvec2(square.hi.x, square.lo.y), square.hi,
                           glm::dvec2(square.lo.x, square.hi.y)};
  return std::all_of(facet.inside.begin(), facet.inside.end(), [&](const HalfPlane& h) {
    return std::any_of(corners.begin(), corners.end(),
                       [&](glm::dvec2 p) { return h.depth(p) >= 0.0; });
  });
}

glm::dvec2 centroid_of(CoverageMask mask, const FrameRectangle& square) {
  glm::dvec2 sum(0.0);
  for (CoverageMask left = mask; left != 0; left &= left - 1)
    sum += mask_point(square, std::countr_zero(left));
  return sum / static_cast<double>(std::popcount(mask));
}

struct MaskFragment {
  const Facet* facet = nullptr;
  CoverageMask mask = 0;
  double nearness = 0.0;  // at the mask's centroid
};

}  // namespace

/// Coverage masks (Carpenter's A-buffer, 1984; Fiume 1991, CGF'98 section 2.12): each triangle
/// covers some of 8 x 8 fixed points of a pixel. Fragments are processed from front to back. Each
/// contributes the points that none before it covers, and is shaded once, at their centroid. The
/// areas of straight edges are right to 1/64 of the pixel. Objects finer than the points are
/// missed, and intersecting fragments are ordered by one depth each. Lights are sampled; mirrors
/// show highlights and the sky.
BlockResult render_block_mask(const BlockJob& job) {
  BlockFacets seen(job);
  std::vector<MaskFragment> fragments;
  return seen.run([&](int x, int y, bool& split) {
    const FrameRectangle square = seen.square(x, y);
    fragments.clear();
    for (const Facet& facet : seen.facets()) {
      if (!meets(facet, square)) continue;
      const CoverageMask mask = mask_of(facet, square);
      if (mask != 0) fragments.push_back({&facet, mask, facet.q(centroid_of(mask, square))});
    }
    std::stable_sort(fragments.begin(), fragments.end(),
                     [](const auto& a, const auto& b) { return a.nearness > b.nearness; });
    glm::dvec3 sum(0.0);
    CoverageMask left = ~CoverageMask{0};
    const auto add = [&](const Facet* facet, CoverageMask mask) {
      const double share = std::popcount(mask) / double{mask_side * mask_side};
      sum += share * glm::dvec3(seen.radiance(facet, centroid_of(mask, square), std::sqrt(share)));
      split |= share < 1.0;
    };
    for (const MaskFragment& fragment : fragments) {
      if ((fragment.mask & left) != 0) add(fragment.facet, fragment.mask & left);
      left &= ~fragment.mask;
    }
    if (left != 0) add(nullptr, left);
    return glm::vec3(sum);
  });
}

}  // namespace asos
