#pragma once

#include "renderer/kernels/light_kernel.h"
#include "renderer/samples/light_places.h"
#include "renderer/samples/recycled.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Of the lobe's own samples, which place on lights is theirs: of all lights the same.
inline constexpr std::uint32_t place_in_lobe = 0x3000;

/// Of some rays of each of so many points, one is kept, the likelier the more it carries, and that
/// carries `share` of all of theirs together. `at`: each point's number, of 2^32; `walked` is
/// scratch. `kept` is not one of `rays`.
void pick_one(std::size_t points, std::span<const ShadowRayBatch> rays,
              const LightPlaceBatch::Fractions& at, float share, std::vector<float>& walked,
              ShadowRayBatch& kept);

/// Highlights of lights that are wider than the lobe, which differ from place to place on them and
/// from direction to direction: a sample looks at several places and along several directions,
/// evenly spread over both, and one of each sends its ray for all, the likelier the more it carries
/// (resampling: Talbot, Cline and Egbert 2005, "Importance resampling for global illumination").
class WideLights {
 public:
  /// Learns which lights are to be looked at so, of those that are `asked` (one a light, else 0):
  /// those that are wider than the lobe of the batch's middle point, if most points shine.
  void find(const LitBatch& points, std::span<const LightConstants> lights,
            std::span<const std::uint8_t> asked, LightPlaces& places);
  [[nodiscard]] bool holds(std::size_t light) const { return !wide_.empty() && wide_[light] != 0; }

  /// The points' rays to a place, and along the lobe, each with what it carries for all. `samples`
  /// are the points'. Valid until the next call.
  [[nodiscard]] std::span<const ShadowRayBatch> shade(const LitBatch& points,
                                                      std::span<const SampleIndex> samples,
                                                      std::uint32_t light,
                                                      const LightConstants& constants,
                                                      LightPlaces& places);

 private:
  static constexpr std::uint32_t candidates = 4;
  struct Work {
    std::array<LobeBatch, candidates> lobes;
    LightPlaceBatch places;
    LightPlaceBatch part;
    std::array<ShadowRayBatch, 2 * candidates> rays;  ///< to places, then along the lobe
    std::array<ShadowRayBatch, 2> picked;
    std::vector<float> walked;
  };
  const LightPlaceBatch& part_of_places(std::uint32_t part, std::size_t count);

  std::vector<std::uint8_t> wide_;  // empty: none
  Recycled<Work> work_;             // once there is a wide light
};

}  // namespace asos
