#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// A point to be grouped by place, direction and emission.
struct ClusterPoint {
  glm::dvec3 position{0.0};  ///< in units of the size of the whole
  glm::dvec3 facing{0.0};    ///< unit; 0: none
  double weight = 1.0;
  glm::dvec3 emission{0.0};  ///< in units of the largest mean of the whole
};

/// Groups points and returns their indices by group; no group is empty. There are at most `most`
/// groups, and no more than needed for a seed within `tolerance` of every point. Seeds are farthest
/// from each other (Gonzalez 1985), followed by Lloyd's k-means in the nine dimensions. Depends
/// only on the points' order.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> cluster(std::span<const ClusterPoint> points,
                                                              std::size_t most, double tolerance);

}  // namespace asos
