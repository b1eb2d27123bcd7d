#include "renderer/methods/random.h"
#include "renderer/methods/sample_block.h"

namespace asos {

BlockResult render_block_stochastic(const RenderScene& scene, const View& view,
                                    const RenderSettings& settings, PixelRect block,
                                    const std::stop_token& stop) {
  const PlaceSample jittered = [](int x, int y, int index, int n) {
    const RandomPair r = unit_pair(pixel_random(x, y, static_cast<std::uint32_t>(index)));
    return PixelPoint{(index % n + r.u) / n, (index / n + r.v) / n};
  };
  return sample_block(scene, view, settings, block, jittered, stop);
}

}  // namespace asos
