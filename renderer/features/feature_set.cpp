#include "renderer/features/feature_set.h"

#include <algorithm>
#include <future>

namespace asos {

namespace {

// Sound models have fewer lines than triangles. Where there are many more, surfaces coincide, and
// their lines say nothing.
std::size_t line_budget(const World& world) {
  return std::max<std::size_t>(10'000, 4 * world.triangles.size());
}

}  // namespace

FeatureSet::FeatureSet(const World& world) : positions_(world.positions) {
  auto intersections =
      std::async(std::launch::async, [&] { return find_intersections(world, line_budget(world)); });
  ExtractedFeatures extracted = extract_features(world);
  counts_ = extracted.counts;
  edges_ = std::move(extracted.edges);
  sheet_of_triangle_ = std::move(extracted.sheet_of_triangle);
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
    edge.kind = FeatureKind::intersection;
    edges_.push_back(edge);
    positions_.push_back(line.a);
    positions_.push_back(line.b);
  }
}

std::size_t FeatureSet::memory_bytes() const {
  return hierarchy_.nodes.size() * sizeof(FeatureNode) + edges_.size() * sizeof(FeatureEdge) +
         sheet_of_triangle_.size() * sizeof(std::uint32_t) + positions_.size() * sizeof(glm::vec3);
}

}  // namespace asos
