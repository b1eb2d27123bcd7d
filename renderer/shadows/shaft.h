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

/// The convex hull of two boxes, as their bounding box and the planes that bevel it (Haines and
/// Wallace 1991): everything that can lie between a point of one and a point of the other.
class Shaft {
 public:
  Shaft(const Box& from, const Box& to);

  /// Leaves out what lies outside of a half-space as well.
  void keep_within(const HalfSpace& half) { half_ = half; }

  /// The children of a node whose boxes meet the shaft, bit by bit; conservative.
  [[nodiscard]] unsigned met_children(const FeatureNode& node) const;
  /// Whether a box may meet it; conservative.
  [[nodiscard]] bool meets(const Box& box) const;
  /// Whether a straight edge may meet it; conservative.
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

/// Where to look for boundaries in a shaft.
struct ShaftSearch {
  FeatureCut cut;
  bool complete = false;  ///< every edge was looked at: an empty cut proves that there are none
};

/// Finds the part of the feature hierarchy that lies in a shaft, opened until `most` nodes hold it.
/// Edges that `ignored` ignores do not count.
void search_shaft(const FeatureSet& features, const Shaft& shaft, const SearchBounds& ignored,
                  std::size_t most, ShaftSearch& found);

/// Whether some edge that meets a shaft is one of those asked for.
[[nodiscard]] bool any_edge(const FeatureSet& features, const Shaft& shaft,
                            const std::function<bool(const FeatureEdge&)>& asked_for);

}  // namespace asos
