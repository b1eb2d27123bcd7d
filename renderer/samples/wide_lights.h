#pragma once

#include "renderer/kernels/light_kernel.h"
#include "renderer/samples/light_sample_points.h"
#include "renderer/samples/thread_local_cache.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Keeps one ray per point out of several, with a probability proportional to its contribution. The
/// kept ray contributes `share` of their total. `at` is each point's random number, a 32-bit
/// fraction; `walked` is scratch. `kept` must not be one of `rays`.
void pick_one(std::size_t points, std::span<const ShadowRayBatch> rays,
              const LightPointBatch::Fractions& at, float share, std::vector<float>& walked,
              ShadowRayBatch& kept);

/// Highlights of lights wider than the lobe, which vary over the light and over directions. A
/// sample evaluates several places on the light and several directions of the lobe, evenly
/// distributed over both. One of each is selected in proportion to its contribution and sends its
/// ray for all (resampling: Talbot, Cline and Egbert 2005, "Importance resampling for global
/// illumination").
class WideLights {
 public:
  /// Selects the lights for this method among those with a non-zero entry in `asked`. These are the
  /// lights wider than the lobe at the batch's central point, if most points have strong
  /// highlights.
  void find(const ShadingPoints& points, std::span<const LightConstants> lights,
            std::span<const std::uint8_t> asked, LightSamplePoints& places);
  [[nodiscard]] bool holds(std::size_t light) const { return !wide_.empty() && wide_[light] != 0; }

  /// Returns the points' rays to a place, and along the lobe, with their contributions for all
  /// candidates. `samples` belong to the points. Valid until the next call.
  [[nodiscard]] std::span<const ShadowRayBatch> shade(const ShadingPoints& points,
                                                      std::span<const SampleIndex> samples,
                                                      std::uint32_t light,
                                                      const LightConstants& constants,
                                                      LightSamplePoints& places);

 private:
  static constexpr std::uint32_t candidates = 4;
  struct Work {
    std::array<LobeBatch, candidates> lobes;
    LightPointBatch places;
    LightPointBatch part;
    LightArcs arcs;                                   ///< of the present light
    std::array<ShadowRayBatch, 2 * candidates> rays;  ///< to places, then along the lobe
    std::array<ShadowRayBatch, 2> picked;
    std::vector<float> walked;
  };
  const LightPointBatch& part_of_places(std::uint32_t part, std::size_t count);

  std::vector<std::uint8_t> wide_;  // empty: none
  CachedPtr<Work> work_;            // allocated at the first wide light
};

}  // namespace asos
