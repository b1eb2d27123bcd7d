#pragma once

#include "renderer/features/intersections.h"

namespace asos {

/// Finds where meshes that a world stores once pass through each other's places and through other
/// surfaces, as find_intersections does. Tests only triangles in the boxes of two parts. Gives up,
/// with `complete` false, if these are more than `most_candidates`.
[[nodiscard]] Intersections find_placed_intersections(const World& world,
                                                      const IntersectionBudget& budget,
                                                      const std::stop_token& stop = {});

/// Candidates take 40 bytes each while they are compared.
inline constexpr std::size_t most_candidates = 6'000'000;

}  // namespace asos
