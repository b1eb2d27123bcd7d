#pragma once

#include "renderer/features/disjoint_sets.h"
#include "renderer/features/feature_edge.h"

#include <span>
#include <vector>

namespace asos {

/// Returns how far the smooth surface deviates from each triangle's plane within the neighbouring
/// flat facets, in world units: see FeatureSet::deviation. `facets` joins triangles in one plane.
/// At this stage, `edges` have triangles in place of the surface numbers.
[[nodiscard]] std::vector<float> deviations(const World& world, DisjointSets& facets,
                                            std::span<const FeatureEdge> edges,
                                            const std::stop_token& stop = {});

}  // namespace asos
