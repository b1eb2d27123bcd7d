#pragma once

#include "renderer/pyray/caster.h"
#include "renderer/reflections/reflection_mask.h"
#include "renderer/samples/region_sampler.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace asos {

/// Parts of pixels with an error above the allowance after a block's first stage.
struct OpenRegions {
  struct Part {
    PyrayLeaf leaf;  ///< without its border
    RegionSampler::Mean so_far;
  };
  std::vector<Part> parts;
  RegionSampler::Open samples;  ///< in the order of `parts`

  [[nodiscard]] std::size_t bytes() const { return parts.size() * sizeof(Part) + samples.bytes(); }
};

/// The weighted mean of a blurred reflection's leaves. Their depths together determine the kernel.
class BlurredSum {
 public:
  /// `share`: fraction of the region that counts. `distance`: distance of the visible surface.
  void add(const LeafRegion& region, double share, glm::dvec3 radiance, float distance);

  /// Returns the mean. Most boundaries between leaves belong to the nearest surface, so its depth
  /// determines the blur.
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

/// Sum of the leaves of each root, and statistics of its pixel.
struct RootSum {
  glm::dvec3 radiance{0.0};
  double weight = 0.0;
  bool shadow_cut = false;    ///< the edge of a hard shadow cut one of its leaves
  bool cut_out = false;       ///< samples found cut-outs, or several transparent layers
  bool mirror_cut = false;    ///< a boundary split the reflection of a leaf
  bool defocused = false;     ///< the root was sampled over the camera's lens
  std::uint32_t samples = 0;  ///< of parts that were sampled as a whole
  /// Samples of parts whose samples differ visibly and need more than one round.
  std::uint32_t varied = 0;
  float error = 0.0f;          ///< error bound of the root's centre, from the bounds of its leaves
  double squared_error = 0.0;  ///< of sampled parts: the sum of their squared standard errors
  /// The summed error bounds of leaves by their centres, by area. Infinite in a mirror that may
  /// show a bright light at a wrong place.
  double centre_error = 0.0;
  std::uint64_t rays = 0;  ///< of all kinds for the root's leaves, except for eye rays

  /// Adds the estimate of a leaf by samples, with this weight.
  void add_samples(const RegionSampler::Mean& found, const PyrayLeaf& leaf, double leaf_weight);
  void add_samples(const RegionSampler::Mean& found, const PyrayLeaf& leaf) {
    add_samples(found, leaf, leaf.weight);
  }
  void add(glm::dvec3 leaf, double leaf_weight) {
    radiance += leaf_weight * leaf;
    weight += leaf_weight;
  }
  /// Records a leaf's error. A quarter of a leaf has a quarter of the leaf's error bound.
  void note_error(float leaf, double leaf_weight) {
    error = std::max(error, leaf / static_cast<float>(leaf_weight));
  }
  [[nodiscard]] glm::vec3 mean() const {
    return weight > 0.0 ? glm::vec3(radiance / weight) : glm::vec3(0.0f);
  }
};

}  // namespace asos
