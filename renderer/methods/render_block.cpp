#include "renderer/methods/method.h"

namespace asos {

BlockResult render_block(const RenderScene& scene, const View& view, const RenderSettings& settings,
                         PixelRect block, const std::stop_token& stop) {
  switch (settings.method) {
    case Method::uniform:
      return render_block_uniform(scene, view, settings, block, stop);
    case Method::stochastic:
      return render_block_stochastic(scene, view, settings, block, stop);
    case Method::beam:
      return render_block_beam(scene, view, settings, block, stop);
    case Method::asos:
    case Method::asos_published:
      break;
  }
  return render_block_asos(scene, view, as_published(settings), block, stop);
}

}  // namespace asos
