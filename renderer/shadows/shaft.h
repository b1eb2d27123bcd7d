#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/geometry/half_space.h"
#include "renderer/pyray/search_bounds.h"
#include "renderer/world/world.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

namespace asos {

/// The convex hull of two boxes, as their bounding box and bevel planes (Haines and Wallace 1991).
/// It contains everything that can lie between a point of one and a point of the other.
class Shaft {
 public:
  Shaft(const Box& from, const Box& to);

  /// Also excludes everything outside of a half-space.
  void keep_within(const HalfSpace& half) { half_ = half; }

  /// Returns the children of a node whose boxes meet the shaft, as bits; conservative.
  [[nodiscard]] unsigned met_children(const FeatureNode& node) const;
  /// Returns whether a box may meet the shaft; conservative.
  [[nodiscard]] bool meets(const Box& box) const;
  /// Returns whether a straight edge may meet the shaft; conservative.
  [[nodiscard]] bool meets(glm::vec3 a, glm::vec3 b) const;

 private:
  /// Inside: first * p[i] + second * p[j] >= offset.
  struct Bevel {
    int i = 0, j = 1;
    float first = 0.0f, second = 0.0f, offset = 0.0f;
  };
  void add_bevels(const Box& from, const Box& to, int i, int j);

  Box bounds_;
  std::array<Bevel, 12> bevels_;
  std::size_t count_ = 0;
  std::optional<HalfSpace> half_;
};

/// Where to search for boundaries in a shaft.
struct ShaftSearch {
  FeatureCut cut;
  bool complete = false;  ///< every edge was tested: an empty cut proves that there are none
};

/// Finds the part of the feature hierarchy in a shaft, opened up to `most` nodes. Edges that
/// `ignored` ignores do not count.
void search_shaft(const FeatureSet& features, const Shaft& shaft, const SearchBounds& ignored,
                  std::size_t most, ShaftSearch& found);

/// Returns whether an edge that meets a shaft satisfies `asked_for`.
[[nodiscard]] bool any_edge(const FeatureSet& features, const Shaft& shaft,
                            const std::function<bool(const FeatureEdge&)>& asked_for);

}  // namespace asos
