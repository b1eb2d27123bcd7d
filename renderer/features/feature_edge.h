#pragma once

#include "renderer/features/surface_look.h"
#include "renderer/world/world.h"

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace asos {

/// The reason why an edge can be a visible boundary (design section 3). All but the last hold from
/// every viewpoint. The last holds only where the two faces project to the same side.
enum class FeatureKind : std::uint8_t {
  open,          ///< one face, or more than two
  crease,        ///< shading normals or vertex colours differ across the edge; rims of shapes
  seam,          ///< material, what textures show, or the side that shows differs across the edge
  intersection,  ///< two faces pass through each other; no edge of the mesh
  cut_out,       ///< the outline of a texture's cut-out in a face; no edge of the mesh
  silhouette,    ///< two faces that meet smoothly at an angle: a possible silhouette
};

/// An edge of the welded mesh. Vertices index World::positions (or those that FeatureSet appends);
/// the first of several vertices at one place represents all. `left` and `right` are the third
/// vertices of the two faces; open edges, intersections and cut-outs have no `right`.
/// `left_surface` and `right_surface` are the smooth surfaces of the faces on either side
/// (ExtractedFeatures::surface_of_triangle); `none` without a face. An edge of more than two faces
/// has the surfaces of the first two, an intersection those of its two triangles, and a cut-out the
/// left one only.
struct FeatureEdge {
  static constexpr std::uint32_t none = 0xffffffffu;

  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t left = none;
  std::uint32_t right = none;
  std::uint32_t left_surface = none;
  std::uint32_t right_surface = none;
  FeatureKind kind = FeatureKind::open;
  bool folds = false;  ///< its two faces are not coplanar, so the edge can also be a silhouette

  /// Returns whether the edge is a curve of an analytic shape, without vertices.
  [[nodiscard]] bool is_curve() const { return a == none; }
  /// Returns the index of the edge's curve in FeatureSet::curves, stored in `b`.
  [[nodiscard]] std::uint32_t curve() const { return b; }
  void set_curve(std::uint32_t index) { a = none, b = index; }
};

/// The number of edges of each kind in a world. `intersection` counts lines where surfaces pass
/// through each other, and `cut_out` straight pieces of cut-outs' outlines.
struct FeatureCounts {
  std::uint64_t open = 0;
  std::uint64_t silhouette_candidates = 0;
  std::uint64_t crease = 0;
  std::uint64_t seam = 0;
  std::uint64_t intersection = 0;
  std::uint64_t cut_out = 0;

  FeatureCounts& operator+=(const FeatureCounts& other);
};

struct ExtractedFeatures {
  std::vector<FeatureEdge> edges;
  /// Faces joined by edges across which the surface is smooth have the same number.
  std::vector<std::uint32_t> surface_of_triangle;
  std::vector<float> deviation_of_triangle;  ///< see FeatureSet::deviation
  FeatureCounts counts;
};

/// Finds the feature edges of a world. It pairs the faces at each edge of the `welded` mesh
/// (welded_vertices) and drops the edges between coplanar faces that look alike. Winding matters
/// only for culling, where a single-sided face is next to one with the opposite winding. Time is
/// linear in the number of triangles. It skips these:
/// - triangles without area, which bound nothing
/// - triangles that repeat another one's corners and look
/// - edges whose faces are all cut out along them, by `hidden_sides` (CutOuts::hidden_sides, or
///   empty)
/// `texture_at` decides whether a jump of texture coordinates is visible; without it, every jump is
/// a seam. Throws SearchStopped once `stop` is requested.
[[nodiscard]] ExtractedFeatures extract_features(const World& world,
                                                 std::span<const std::uint32_t> welded,
                                                 TextureAt texture_at = nullptr,
                                                 const std::stop_token& stop = {},
                                                 std::span<const std::uint8_t> hidden_sides = {});

}  // namespace asos
