#pragma once

#include "renderer/features/disjoint_sets.h"
#include "renderer/features/feature_edge.h"

#include <span>
#include <vector>

namespace asos {

/// How far the smooth surface leaves each triangle's plane within the neighbouring flat facets, in
/// world units: see FeatureSet::deviation. `facets` joins triangles that lie in one plane. `edges`
/// still name their triangles where later the sheets are.
[[nodiscard]] std::vector<float> deviations(const World& world, DisjointSets& facets,
                                            std::span<const FeatureEdge> edges,
                                            const std::stop_token& stop = {});

}  // namespace asos
