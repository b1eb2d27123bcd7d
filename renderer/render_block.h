#pragma once

#include "renderer/film/block_result.h"
#include "renderer/geometry/pixel_rect.h"
#include "renderer/geometry/view.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/settings/settings.h"

#include <stop_token>

namespace asos {

/// Renders one block of a picture: the main entry point of the renderer. `settings.method` selects
/// the method (renderer/comparison/method.h has the table); docs/architecture.md describes the path
/// of a pixel from here.
///
/// `block`: in pixels of the whole picture, whatever the crop; aligned to block_side(settings) and
/// clipped at the picture's right and bottom edge. A pure function: it can be called in any thread
/// and order with bit-identical results. Samples that are not finite are left out of their pixel's
/// mean and counted; a pixel without finite samples is black. After a requested stop the result is
/// incomplete and to be dropped.
[[nodiscard]] BlockResult render_block(const RenderScene& scene, const View& view,
                                       const RenderSettings& settings, PixelRect block,
                                       const std::stop_token& stop = {});

}  // namespace asos
