#include "renderer/features/feature_set.h"

#include <future>
#include <utility>

namespace asos {

FeatureSet::FeatureSet(const World& world, TextureAt texture_at) : positions_(world.positions) {
  auto intersections = std::async(
      std::launch::async, [&] { return find_intersections(world, IntersectionBudget::of(world)); });
  ExtractedFeatures extracted = extract_features(world, texture_at);
  counts_ = extracted.counts;
  edges_ = std::move(extracted.edges);
  sheet_of_triangle_ = std::move(extracted.sheet_of_triangle);
  departure_of_triangle_ = std::move(extracted.departure_of_triangle);
  add(intersections.get());
  hierarchy_ = FeatureHierarchy::build(positions_, edges_);
}

void FeatureSet::add(const Intersections& found) {
  intersections_complete_ = found.complete;
  counts_.intersection = found.lines.size();
  for (const IntersectionLine& line : found.lines) {
    FeatureEdge edge;
    edge.a = static_cast<std::uint32_t>(positions_.size());
    edge.b = edge.a + 1;
    edge.left_sheet = sheet(line.first_triangle);
    edge.right_sheet = sheet(line.second_triangle);
    edge.kind = FeatureKind::intersection;
    edges_.push_back(edge);
    positions_.push_back(line.a);
    positions_.push_back(line.b);
  }
}

std::size_t FeatureSet::memory_bytes() const {
  return hierarchy_.nodes.size() * sizeof(FeatureNode) + edges_.size() * sizeof(FeatureEdge) +
         sheet_of_triangle_.size() * sizeof(std::uint32_t) +
         departure_of_triangle_.size() * sizeof(float) + positions_.size() * sizeof(glm::vec3);
}

}  // namespace asos
