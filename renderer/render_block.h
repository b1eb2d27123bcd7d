#pragma once

#include "renderer/film/block_result.h"
#include "renderer/geometry/pixel_rect.h"
#include "renderer/geometry/view.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/settings/settings.h"

#include <stop_token>

namespace asos {

/// Renders one block of a picture: the front door of the renderer. `settings.method` names the
/// method (renderer/comparison/method.h has the table of all); docs/architecture.md follows a pixel
/// from here.
///
/// `block`: in pixels of the whole picture, whatever the crop; aligned to block_side(settings) and
/// clipped at the picture's right and bottom edge. A pure function of its arguments: any thread,
/// any order, the same bits. Samples that are not finite are left out of their pixel's mean and
/// counted; a pixel without any is black. Once a stop is requested the result is unfinished, to be
/// dropped.
[[nodiscard]] BlockResult render_block(const RenderScene& scene, const View& view,
                                       const RenderSettings& settings, PixelRect block,
                                       const std::stop_token& stop = {});

}  // namespace asos
