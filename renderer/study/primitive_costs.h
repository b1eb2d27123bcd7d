#pragma once

#include <vector>

namespace asos {

/// The cost of the in-out test of a pyray's cone against a primitive, compared with a ray's test.
struct PrimitiveCost {
  const char* name = "";
  double ray_ns = 0.0;
  double cone_ns = 0.0;
  /// The cost of this program's own method for curved faces: finding their outline in the pyray's
  /// square. 0 for those that are meshes here.
  double square_ns = 0.0;
  double published = 0.0;  ///< cost of cone over ray, GI'93 table 3

  [[nodiscard]] double factor() const { return cone_ns / ray_ns; }
};

/// Measures GI'93 table 3, in its order. All kinds of test run over the same 20,000 pyrays in turn,
/// `rounds` times; the least time of each counts. The cone is the published one, around the pyray.
/// A round takes some hundredths of a second.
[[nodiscard]] std::vector<PrimitiveCost> primitive_costs(int rounds);

}  // namespace asos
