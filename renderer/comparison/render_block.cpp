#include "renderer/comparison/method.h"

namespace asos {
namespace {

BlockResult render_by_method(const RenderScene& scene, const View& view,
                             const RenderSettings& settings, PixelRect block,
                             const std::stop_token& stop) {
  switch (settings.method) {
    case Method::uniform:
      return render_block_uniform(scene, view, settings, block, stop);
    case Method::stochastic:
      return render_block_stochastic(scene, view, settings, block, stop);
    case Method::sobol:
      return render_block_sobol(scene, view, settings, block, stop);
    case Method::whitted:
      return render_block_whitted(scene, view, settings, block, stop);
    case Method::mitchell:
      return render_block_mitchell(scene, view, settings, block, stop);
    case Method::ray_bound:
      return render_block_ray_bound(scene, view, settings, block, stop);
    case Method::average:
      return render_block_average(scene, view, settings, block, stop);
    case Method::beam:
      return render_block_beam(scene, view, settings, block, stop);
    case Method::asos:
    case Method::asos_published:
      break;
  }
  return render_block_asos(scene, view, as_published(settings), block, stop);
}

}  // namespace

BlockResult render_block(const RenderScene& scene, const View& view, const RenderSettings& settings,
                         PixelRect block, const std::stop_token& stop) {
  BlockResult result = render_by_method(scene, view, settings, block, stop);
  // Methods that split nothing have no causes to tell.
  const std::size_t pixels = result.tile.split_level.size();
  result.tile.cause.resize(pixels, SplitCause::none);
  // Those that do not tell pixels' rays apart have about as many for each.
  if (result.tile.rays.size() != pixels && pixels > 0) {
    const auto mean = static_cast<double>(result.statistics.rays()) / static_cast<double>(pixels);
    result.tile.rays.assign(pixels, static_cast<float>(mean));
  }
  return result;
}

}  // namespace asos
