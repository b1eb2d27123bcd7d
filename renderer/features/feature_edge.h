#pragma once

#include "renderer/features/surface_look.h"
#include "renderer/world/world.h"

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace asos {

/// Why an edge can be a boundary of what is seen (design section 3). All but the last bound from
/// every viewpoint, the last only where the two faces project to the same side.
enum class FeatureKind : std::uint8_t {
  open,          ///< one face, or more than two
  crease,        ///< shading normals or vertex colours differ across the edge
  seam,          ///< material, what textures show, or the side that shows differs across the edge
  intersection,  ///< two faces pass through each other; no edge of the mesh
  cut_out,       ///< the outline of what a texture cuts out of a face; no edge of the mesh
  silhouette,    ///< two faces that meet smoothly at an angle: a candidate
};

/// An edge of the welded mesh. Vertices index World::positions (or what FeatureSet appends to
/// them); of vertices at one place the first stands for all. `left` and `right` are the third
/// vertices of the two faces; open edges have no `right`, intersections and cut-outs neither. The
/// sheets are those of the faces on either side (ExtractedFeatures::sheet_of_triangle): none where
/// there is no such face, the first two at an edge of more, the two triangles' of an intersection;
/// a cut-out's is the left one.
struct FeatureEdge {
  static constexpr std::uint32_t none = 0xffffffffu;

  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t left = none;
  std::uint32_t right = none;
  std::uint32_t left_sheet = none;
  std::uint32_t right_sheet = none;
  FeatureKind kind = FeatureKind::open;
  bool folds = false;  ///< its two faces are not coplanar, so it can be a silhouette too

  /// The edge is a curve of an analytic shape and has no vertices.
  [[nodiscard]] bool is_curve() const { return a == none; }
  /// Which one, as an index into FeatureSet::curves; `b` holds it.
  [[nodiscard]] std::uint32_t curve() const { return b; }
  void set_curve(std::uint32_t index) { a = none, b = index; }
};

/// How many edges of each kind a world has. `intersection`: lines where surfaces pass through each
/// other; `cut_out`: straight pieces of cut-outs' outlines.
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
  std::vector<std::uint32_t> sheet_of_triangle;  ///< faces joined by edges that always continue
                                                 ///< the surface smoothly share a sheet
  std::vector<float> deviation_of_triangle;      ///< see FeatureSet::deviation
  FeatureCounts counts;
};

/// Finds the feature edges of a world: pairs the faces of each edge of the `welded` mesh
/// (welded_vertices) and drops the edges between coplanar faces that look alike. Relies on the
/// faces' winding for nothing but for what culling hides: a single-sided face beside one that is
/// wound the other way. Work is linear in the triangles. Zero-area triangles bound nothing and are
/// passed over; so are triangles that repeat another one's corners and look; so are edges of which
/// `hidden_sides` says that all of their faces are cut out there (CutOuts::hidden_sides, or empty).
/// `texture_at` tells whether a jump of texture coordinates shows; without it every one is a seam.
/// Throws SearchStopped once `stop` is requested.
[[nodiscard]] ExtractedFeatures extract_features(const World& world,
                                                 std::span<const std::uint32_t> welded,
                                                 TextureAt texture_at = nullptr,
                                                 const std::stop_token& stop = {},
                                                 std::span<const std::uint8_t> hidden_sides = {});

}  // namespace asos
