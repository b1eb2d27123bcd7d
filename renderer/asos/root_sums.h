#pragma once

#include "renderer/reflections/mirrored_mask.h"
#include "renderer/samples/region_sampler.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace asos {

/// The leaves of a blurred reflection, which count by a kernel that all of them tell together.
class BlurredSum {
 public:
  /// `share`: the part of the region that counts. `distance`: that of the surface that it shows.
  void add(const LeafRegion& region, double share, glm::dvec3 radiance, float distance);

  /// Their mean. The boundaries between the leaves are mostly the nearest surface's: its depth says
  /// how they are blurred.
  [[nodiscard]] glm::vec3 mean(const BlurByDepth& blur) const;

 private:
  struct Part {
    Square square;
    std::size_t first_edge = 0;
    std::size_t edge_count = 0;
    double share = 1.0;
    glm::dvec3 radiance{0.0};
  };
  std::vector<Part> parts_;
  std::vector<BorderEdge> borders_;
  float nearest_ = std::numeric_limits<float>::infinity();
};

/// The leaves of each root, added up, with what is told about its pixel.
struct RootSum {
  glm::dvec3 radiance{0.0};
  double weight = 0.0;
  bool shadow_cut = false;    ///< the edge of a hard shadow cut one of its leaves
  bool cut_out = false;       ///< samples found what textures cut out, or let through together
  bool mirror_cut = false;    ///< a boundary split what one of its leaves mirrors
  bool misplaced = false;     ///< bent mirrors, one in the other, may show a bright light elsewhere
  bool defocused = false;     ///< it was sampled over the camera's lens
  std::uint32_t samples = 0;  ///< of parts that were sampled as a whole
  std::uint32_t varied = 0;   ///< of those parts whose samples differ visibly, beyond one round
  float error = 0.0f;         ///< of the root's centre, as the bounds of its leaves tell
  double squared_error = 0.0;  ///< of sampled parts: the sum of their squared standard errors
  double centre_error = 0.0;   ///< of leaves by their centres: the sum of their bounds, by area
  std::uint64_t rays = 0;      ///< of all kinds that were cast for its leaves, beside their own

  /// Adds the estimate of a part of this weight by samples. `layers`: it was sampled for what
  /// textures cut out.
  void add_samples(const RegionSampler::Estimate& found, double leaf_weight, bool layers);
  void add(glm::dvec3 leaf, double leaf_weight) {
    radiance += leaf_weight * leaf;
    weight += leaf_weight;
  }
  /// A leaf's bound is a quarter of that of what it is a quarter of.
  void note_error(float leaf, double leaf_weight) {
    error = std::max(error, leaf / static_cast<float>(leaf_weight));
  }
  [[nodiscard]] glm::vec3 mean() const {
    return weight > 0.0 ? glm::vec3(radiance / weight) : glm::vec3(0.0f);
  }
};

}  // namespace asos
