#include "renderer/samples/sobol_places.h"

namespace asos {

BlockResult render_block_sobol(const RenderScene& scene, const View& view,
                               const RenderSettings& settings, PixelRect block,
                               const std::stop_token& stop) {
  SobolPlaces places(settings.seed);
  return sample_block(scene, view, settings, block, places, settings.sampling.spp, stop);
}

}  // namespace asos
