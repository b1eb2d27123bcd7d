#pragma once

#include "renderer/pyray/square.h"
#include "renderer/reflections/mirrored_mask.h"
#include "renderer/samples/sample_sums.h"
#include "renderer/samples/sobol_places.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace asos {

/// Parts of pixels as the mean of samples that are well distributed over the part and over each
/// light together, in packets: what is left to do where so much bounds or shades a part that
/// looking at all of it would cost more (design section 5, "Saturation").
class RegionSampler {
 public:
  /// `block`: the pixels that the frame shows whose square the regions lie in. `mask`: the parts of
  /// it that count, and for how much; null: all the same. All have to outlive this.
  RegionSampler(const RenderScene& scene, const Viewer& viewer, const RenderSettings& settings,
                PixelRect block, int seed, const MirroredMask* mask = nullptr);

  /// How far to go.
  struct Goal {
    double standard_error = 0.0;  ///< of the mean, in display intensity; negative: take `most`
    std::uint32_t most = 16;      ///< samples; a power of two, at least 16
    std::uint32_t least = 16;     ///< the same, at most `most`: so few tell nothing of themselves
  };
  struct Estimate {
    glm::dvec3 mean{0.0};       ///< linear radiance
    std::uint32_t samples = 0;  ///< that count; 0: there is no mean
    double masked_share = 0.0;  ///< share of the samples in the region that the mask left out
  };

  /// The samples are a function of the region, and of the pixel that its square starts in. Four at
  /// a time, twice as many each round, until the four quarters of them tell that the goal is met.
  /// With a `kernel`, squares are sampled as it is distributed there.
  [[nodiscard]] Estimate sample(const LeafRegion& region, const Goal& goal,
                                RenderStatistics& counts, const BlurKernel* kernel = nullptr);

 private:
  /// How many samples of a round lie in the region, and how many of these beside the mask.
  struct Share {
    std::uint32_t in_region = 0;
    std::uint32_t masked = 0;
  };
  [[nodiscard]] Share add(const LeafRegion& region, const BlurKernel* kernel, std::uint32_t first,
                          std::uint32_t end);
  [[nodiscard]] Estimate estimate(std::uint32_t count) const;
  [[nodiscard]] double standard_error(std::uint32_t count, glm::dvec3 mean) const;

  PixelRect block_;
  const MirroredMask* mask_;
  double white_;  // the radiance that a picture may show as white
  SobolPlaces places_;
  SampleSums sums_;  // of four samples each
};

}  // namespace asos
