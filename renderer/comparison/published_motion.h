#pragma once

#include "renderer/samples/block_job.h"

namespace asos {

/// Renders a block with motion blur as CGF'98 section 8 proposes: the pyray of each pixel is
/// elongated by the way of the surface at the pixel's centre, over the whole exposure. The picture
/// is of the middle moment, by the settings of `job`. A pixel whose centre shows nothing that moves
/// stays sharp: moving objects end at sharp outlines. Lenses are ignored in elongated pixels.
[[nodiscard]] BlockResult render_published_motion(const BlockJob& job);

}  // namespace asos
