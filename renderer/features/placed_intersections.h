#pragma once

#include "renderer/features/intersections.h"

namespace asos {

/// Finds where meshes that a world keeps once pass through each other's places and through other
/// surfaces, as find_intersections does. Looks only at triangles in the boxes of two parts, and
/// gives up, with `complete` false, where these are more than `most_candidates`.
[[nodiscard]] Intersections find_placed_intersections(const World& world,
                                                      const IntersectionBudget& budget,
                                                      const std::stop_token& stop = {});

/// 40 bytes of memory each while they are compared.
inline constexpr std::size_t most_candidates = 6'000'000;

}  // namespace asos
