#include "renderer/features/feature_set.h"

namespace asos {

FeatureSet::FeatureSet(const World& world) : positions_(world.positions) {
  ExtractedFeatures extracted = extract_features(world);
  counts_ = extracted.counts;
  edges_ = std::move(extracted.edges);
  sheet_of_triangle_ = std::move(extracted.sheet_of_triangle);
  hierarchy_ = FeatureHierarchy::build(positions_, edges_);
}

std::size_t FeatureSet::memory_bytes() const {
  return hierarchy_.nodes.size() * sizeof(FeatureNode) + edges_.size() * sizeof(FeatureEdge) +
         sheet_of_triangle_.size() * sizeof(std::uint32_t);
}

}  // namespace asos
