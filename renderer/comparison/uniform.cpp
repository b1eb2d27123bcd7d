#include "renderer/samples/sample_block.h"

namespace asos {

BlockResult render_block_uniform(const RenderScene& scene, const View& view,
                                 const RenderSettings& settings, PixelRect block,
                                 const std::stop_token& stop) {
  const int n = grid_side(settings.sampling.spp);
  GridPlaces places(n, false);
  return sample_block(scene, view, settings, block, places, n * n, stop);
}

}  // namespace asos
