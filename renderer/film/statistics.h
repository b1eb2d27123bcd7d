#pragma once

#include <array>
#include <cstdint>

namespace asos {

/// Work done and what it met, summed over tiles. Integers and sums that do not depend on order but
/// for `unresolved_area`, which is summed in tile order by RenderSession.
struct RenderStatistics {
  std::uint64_t eye_rays = 0;
  std::uint64_t shadow_rays = 0;
  std::uint64_t reflection_rays = 0;
  std::array<std::uint64_t, 9> pyrays_by_level{};  ///< cells examined, by level 0..8
  std::uint64_t split_pixels = 0;      ///< pixels that went beyond level 0 or cut a cell
  std::uint64_t missed_splits = 0;     ///< pixels split by the safety net only (design section 3)
  std::uint64_t uneven_pixels = 0;     ///< pixels of which parts were split for their shading alone
  std::uint64_t saturated_pixels = 0;  ///< pixels sampled at the finest level at once (section 5)
  double unresolved_area = 0.0;        ///< in pixels: area of the leaves that stayed marginal
  std::uint64_t rejected_samples = 0;  ///< samples that were not finite, dropped

  RenderStatistics& operator+=(const RenderStatistics& other);
};

}  // namespace asos
