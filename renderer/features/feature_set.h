#pragma once

#include "renderer/features/cut_outs.h"
#include "renderer/features/feature_curve.h"
#include "renderer/features/feature_edge.h"
#include "renderer/features/hierarchy.h"
#include "renderer/features/intersections.h"
#include "renderer/world/world.h"

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace asos {

/// All boundaries that a world can show, ready to be searched by a pyray. Immutable once built,
/// thread-safe.
class FeatureSet {
 public:
  FeatureSet() = default;
  /// `texture_at`: see extract_features. Throws SearchStopped once `stop` is requested.
  explicit FeatureSet(const World& world, TextureAt texture_at = nullptr,
                      const std::stop_token& stop = {});

  [[nodiscard]] const FeatureCounts& counts() const { return counts_; }
  [[nodiscard]] std::span<const FeatureNode> nodes() const { return hierarchy_.nodes; }
  /// FeatureNode::chains counts in these.
  [[nodiscard]] std::span<const NodeChains> chains() const { return hierarchy_.chains; }
  [[nodiscard]] std::span<const FeatureEdge> edges() const { return edges_; }
  [[nodiscard]] std::span<const glm::vec3> positions() const { return positions_; }
  [[nodiscard]] std::span<const FeatureCurve> curves() const { return curves_; }
  [[nodiscard]] const ShapeFace& face(std::uint32_t index) const { return faces_[index]; }

  /// The smooth, connected piece of surface that a triangle belongs to. Along a path in a picture
  /// the visible sheet changes only across a boundary.
  [[nodiscard]] std::uint32_t sheet(std::uint32_t triangle) const {
    return sheet_of_triangle_[triangle];
  }

  /// How far, in world units, the smooth surface around a triangle leaves the triangle's plane
  /// within the next triangles. A boundary that lies less far behind the plane may be the surface's
  /// own outline, where it bends away: the plane does not hide it.
  [[nodiscard]] float deviation(std::uint32_t triangle) const {
    return deviation_of_triangle_[triangle];
  }

  /// The same within `reach` of a point of the surface: less for analytic shapes, which are bent
  /// everywhere alike.
  [[nodiscard]] double deviation(std::uint32_t surface, glm::dvec3 position, double reach) const {
    const std::size_t triangles = deviation_of_triangle_.size() - faces_.size();
    if (surface < triangles) return deviation(surface);
    return face_deviation(faces_[surface - triangles], position, reach);
  }

  /// False where surfaces pass through each other so often that the lines were left out; the safety
  /// net then has to find them.
  [[nodiscard]] bool intersections_complete() const { return intersections_complete_; }

  /// By surface, whether all that is cut out of it is bounded by edges (CutOuts::outlined); empty
  /// without masked surfaces.
  [[nodiscard]] std::span<const std::uint8_t> outlined() const { return outlined_; }
  [[nodiscard]] bool outlined(std::uint32_t surface) const {
    return !outlined_.empty() && outlined_[surface] != 0;
  }
  /// Whether there are masked surfaces whose cut-outs are not, so that only samples tell them.
  [[nodiscard]] bool cut_outs_unbounded() const { return cut_outs_unbounded_; }
  /// Whether some surface's opacity differs from place to place otherwise than by outlined
  /// cut-outs.
  [[nodiscard]] bool opacity_unbounded() const { return opacity_unbounded_; }

  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  FeatureCounts counts_;
  FeatureHierarchy hierarchy_;
  std::vector<FeatureEdge> edges_;
  std::vector<std::uint32_t> sheet_of_triangle_;
  std::vector<float> deviation_of_triangle_;
  std::vector<FeatureCurve> curves_;
  std::vector<ShapeFace> faces_;      // the world's
  std::vector<glm::vec3> positions_;  // the world's, then the ends of intersections and cut-outs
  std::vector<std::uint8_t> outlined_;
  bool intersections_complete_ = true;
  bool cut_outs_unbounded_ = false;
  bool opacity_unbounded_ = false;

  void add(const Intersections& found);
  void add_shapes(const World& world);
  void add_shape_intersections(const World& world);
  void add(const World& world, CutOuts found);
};

}  // namespace asos
