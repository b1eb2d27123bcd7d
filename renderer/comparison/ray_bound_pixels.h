#pragma once

#include "renderer/prepared/render_scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Returns 1 for each pixel of a block, row by row, that a possibly visible boundary crosses, else
/// 0 (CGF'98 section 2.9: "a ray bound surrounding several similar rays is used to detect the
/// proximity of the rays to the boundary of an object"; Ohta and Maekawa 1990).
///
/// The ray bounds are pyramids around 8 x 8, 4 x 4, 2 x 2 pixels and one pixel. The boundaries and
/// their hierarchy are those of ASOS with square detection. Boundaries behind the surface at the
/// centre of a bound are ignored, except within a few pixels' widths behind it (OccluderPlane).
/// `centres` are the hits of the rays through the pixels' centres, row by row; `block` is no larger
/// than block_size.
[[nodiscard]] std::vector<std::uint8_t> pixels_with_boundaries(const RenderScene& scene,
                                                               const View& view, PixelRect block,
                                                               std::span<const Hit> centres);

}  // namespace asos
