#pragma once

#include "renderer/methods/method.h"

namespace asos {

/// A sample's place in its pixel, each coordinate 0 to 1.
struct PixelPoint {
  double x = 0.5;
  double y = 0.5;
};

/// Where sample `index` of pixel (x, y) lies, of n x n.
using PlaceSample = PixelPoint (*)(int x, int y, int index, int n);

/// The side of the first square of at least `spp` samples.
[[nodiscard]] int grid_side(int spp);

/// A block of pixels as the mean of n x n point samples each, n being grid_side(settings.spp),
/// through packets of rays: what the methods that only place samples differently share.
[[nodiscard]] BlockResult sample_block(const RenderScene& scene, const View& view,
                                       const RenderSettings& settings, PixelRect block,
                                       PlaceSample place, const std::stop_token& stop);

}  // namespace asos
