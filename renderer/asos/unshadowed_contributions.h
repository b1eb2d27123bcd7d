#pragma once

#include "renderer/kernels/weigh_lights.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/samples/thread_local_cache.h"
#include "renderer/shading/light_transport.h"

#include <cstddef>
#include <span>
#include <vector>

namespace asos {

/// The largest unshadowed contribution of each of many lights at some points of a block. It
/// determines how many rays each light is worth. Its accuracy is that of weigh_lights.
class UnshadowedContributions {
 public:
  /// The lights have to outlive this.
  explicit UnshadowedContributions(std::span<const PreparedLight> lights);

  /// Forgets all points so far.
  void start();
  /// Adds a point.
  void add(const LightingQuery& point);
  /// Returns the contributions in display units, by light. The lights of one part of a mesh hide
  /// each other, so together they count for at most the light of the two sides that are visible at
  /// a time.
  [[nodiscard]] std::vector<double> most() const;

 private:
  LightTable table_;
  std::vector<double> brightest_;           // largest contribution by each light; at most white
  std::vector<std::size_t> part_of_light_;  // number of its part of a mesh, or none
  std::size_t parts_ = 0;
  CachedPtr<ShadingPoints> point_;
  std::vector<float> worth_;  // contributions at the current point
  std::vector<float> most_;   // the largest at any point
};

}  // namespace asos
