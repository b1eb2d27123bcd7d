#include "renderer/methods/sample_block.h"

namespace asos {

BlockResult render_block_uniform(const RenderScene& scene, const View& view,
                                 const RenderSettings& settings, PixelRect block,
                                 const std::stop_token& stop) {
  const PlaceSample at_centres = [](int, int, int index, int n) {
    return PixelPoint{(index % n + 0.5) / n, (index / n + 0.5) / n};
  };
  return sample_block(scene, view, settings, block, at_centres, stop);
}

}  // namespace asos
