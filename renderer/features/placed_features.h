#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/world/placements.h"
#include "renderer/world/range_index.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <vector>

// The boundaries of meshes that a world stores once. They are found once, in the mesh's own space,
// and transformed on access.

namespace asos {

struct PlacedFeatures {
  /// Finds the boundaries of a world's meshes.
  PlacedFeatures(const World& world, TextureAt texture_at, const std::stop_token& stop);

  /// Returns the hierarchy of all boundaries: nodes over the places and over `own`, followed by
  /// those of `own`. The numbers of places start after these nodes, `edges` and `positions`.
  [[nodiscard]] FeatureHierarchy behind(FeatureHierarchy own, std::size_t edges,
                                        std::size_t positions);

  // Numbers are those of FeatureSet. Nodes are conservative: their boxes and cones contain all
  // edges below them.
  [[nodiscard]] FeatureNode node(std::uint32_t number) const;
  [[nodiscard]] NodeChains chains(std::uint32_t number) const;
  [[nodiscard]] FeatureEdge edge(std::uint32_t number) const;
  [[nodiscard]] glm::dvec3 position(std::uint32_t number) const;
  /// Take the world's triangle numbers.
  [[nodiscard]] std::uint32_t smooth_surface(std::uint32_t triangle) const;
  [[nodiscard]] float deviation(std::uint32_t triangle) const;
  [[nodiscard]] std::size_t memory_bytes() const;

  std::shared_ptr<const Placements> places;
  /// One for each mesh of `places`. Worlds that show the same mesh share it.
  std::vector<std::shared_ptr<const FeatureSet>> meshes;

 private:
  [[nodiscard]] FeatureNode placed(const FeatureNode& node, std::size_t place) const;
  [[nodiscard]] Box box_of(std::size_t place) const;

  // Ranges of numbers by place; none is empty.
  RangeIndex by_node_, by_chains_, by_edge_, by_position_;
  std::uint32_t first_node_ = 0, first_chains_ = 0, first_edge_ = 0, first_position_ = 0;
};

}  // namespace asos
