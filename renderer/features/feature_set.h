#pragma once

#include "renderer/features/cut_outs.h"
#include "renderer/features/feature_curve.h"
#include "renderer/features/feature_edge.h"
#include "renderer/features/hierarchy.h"
#include "renderer/features/intersections.h"
#include "renderer/world/world.h"

#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

namespace asos {

struct PlacedFeatures;

/// All boundaries of a world, in a hierarchy for pyrays to search. Immutable once built,
/// thread-safe.
class FeatureSet {
 public:
  FeatureSet() = default;
  /// `texture_at`: see extract_features. Throws SearchStopped once `stop` is requested.
  explicit FeatureSet(const World& world, TextureAt texture_at = nullptr,
                      const std::stop_token& stop = {});

  [[nodiscard]] const FeatureCounts& counts() const { return counts_; }
  [[nodiscard]] bool empty() const { return hierarchy_.nodes.empty(); }
  /// Returns a node. Nodes of placed meshes come after all others and are made on access, in
  /// `room`; so are chains.
  [[nodiscard]] const FeatureNode& node(std::uint32_t number, FeatureNode& room) const {
    if (number < hierarchy_.nodes.size()) return hierarchy_.nodes[number];
    return placed_node(number, room);
  }
  /// Returns chains by the index in FeatureNode::chains.
  [[nodiscard]] const NodeChains& chains(std::uint32_t number, NodeChains& room) const {
    if (number < hierarchy_.chains.size()) return hierarchy_.chains[number];
    return placed_chains(number, room);
  }
  [[nodiscard]] FeatureEdge edge(std::uint32_t number) const {
    return number < edges_.size() ? edges_[number] : placed_edge(number);
  }
  [[nodiscard]] glm::dvec3 position(std::uint32_t number) const {
    return number < positions_.size() ? glm::dvec3(positions_[number]) : placed_position(number);
  }
  // The following exclude placed meshes.
  [[nodiscard]] std::span<const FeatureNode> nodes() const { return hierarchy_.nodes; }
  [[nodiscard]] std::span<const NodeChains> chains() const { return hierarchy_.chains; }
  [[nodiscard]] std::span<const FeatureEdge> edges() const { return edges_; }
  [[nodiscard]] std::span<const glm::vec3> positions() const { return positions_; }
  [[nodiscard]] std::span<const FeatureCurve> curves() const { return curves_; }
  [[nodiscard]] const ShapeFace& face(std::uint32_t index) const { return faces_[index]; }

  /// Returns the number of a triangle's smooth, connected surface. Along a path in a picture, the
  /// visible surface changes only at a boundary.
  [[nodiscard]] std::uint32_t smooth_surface(std::uint32_t triangle) const {
    return triangle < surface_of_triangle_.size() ? surface_of_triangle_[triangle]
                                                  : placed_smooth_surface(triangle);
  }

  /// Returns how far, in world units, the smooth surface around a triangle deviates from the
  /// triangle's plane within the next triangles. A boundary at less than this behind the plane may
  /// be the surface's own outline, where it curves away: the plane does not hide it.
  [[nodiscard]] float deviation(std::uint32_t triangle) const {
    return triangle < deviation_of_triangle_.size() ? deviation_of_triangle_[triangle]
                                                    : placed_deviation(triangle);
  }

  /// Returns the deviation within `reach` of a point of the surface. For analytic shapes, whose
  /// curvature is uniform, it is smaller.
  [[nodiscard]] double deviation(std::uint32_t surface, glm::dvec3 position, double reach) const {
    const std::size_t triangles = deviation_of_triangle_.size() - faces_.size();
    if (surface < triangles || placed_) return deviation(surface);
    return face_deviation(faces_[surface - triangles], position, reach);
  }

  /// Returns false if surfaces pass through each other so often that the lines were left out; then
  /// the safety net has to find them.
  [[nodiscard]] bool intersections_complete() const { return intersections_complete_; }

  /// Returns, by surface, whether all its cut-outs are bounded by edges (CutOuts::outlined); empty
  /// without masked surfaces.
  [[nodiscard]] std::span<const std::uint8_t> outlined() const { return outlined_; }
  [[nodiscard]] bool outlined(std::uint32_t surface) const {
    return surface < outlined_.size() && outlined_[surface] != 0;
  }
  /// Returns whether there are masked surfaces whose cut-outs only samples can resolve.
  [[nodiscard]] bool cut_outs_unbounded() const { return cut_outs_unbounded_; }
  /// Returns whether the opacity of a surface varies, other than by cut-outs with outlines.
  [[nodiscard]] bool opacity_unbounded() const { return opacity_unbounded_; }

  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  FeatureCounts counts_;
  FeatureHierarchy hierarchy_;
  std::vector<FeatureEdge> edges_;
  std::vector<std::uint32_t> surface_of_triangle_;
  std::vector<float> deviation_of_triangle_;
  std::vector<FeatureCurve> curves_;
  std::vector<ShapeFace> faces_;      // of the world
  std::vector<glm::vec3> positions_;  // of the world, then the ends of intersections and cut-outs
  std::vector<std::uint8_t> outlined_;
  bool intersections_complete_ = true;
  bool cut_outs_unbounded_ = false;
  bool opacity_unbounded_ = false;
  std::shared_ptr<const PlacedFeatures> placed_;  // null: none

  void find(const World& world, TextureAt texture_at, const std::stop_token& stop);
  void find_placed(const World& world, TextureAt texture_at, const std::stop_token& stop);
  [[nodiscard]] const FeatureNode& placed_node(std::uint32_t number, FeatureNode& room) const;
  [[nodiscard]] const NodeChains& placed_chains(std::uint32_t number, NodeChains& room) const;
  [[nodiscard]] FeatureEdge placed_edge(std::uint32_t number) const;
  [[nodiscard]] glm::dvec3 placed_position(std::uint32_t number) const;
  [[nodiscard]] std::uint32_t placed_smooth_surface(std::uint32_t triangle) const;
  [[nodiscard]] float placed_deviation(std::uint32_t triangle) const;
  void add(const Intersections& found);
  void add_shapes(const World& world);
  void add_shape_intersections(const World& world);
  void add(const World& world, CutOuts found);
};

}  // namespace asos
