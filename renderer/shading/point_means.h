#pragma once

#include "renderer/scene/scene.h"
#include "renderer/shading/texel_window.h"
#include "renderer/shading/texture.h"
#include "renderer/shading/texture_filter.h"

#include <glm/glm.hpp>

// Means over a patch of the finest level by points half a texel apart, of a bilinear texture: where
// what lies between texels is no mixture of them, or the patch lies aslant over few of them.

namespace asos {

/// Of all of it.
[[nodiscard]] glm::vec4 mean_of_points(const Texels& texels, glm::vec2 uv, const TexelPatch& patch,
                                       const Texture& texture);

/// The mean colour of what is seen, and the mean alpha; nothing is seen: the mean of all.
[[nodiscard]] glm::vec4 mean_of_seen(const Texels& texels, const TexelUse& use, glm::vec2 uv,
                                     const TexelPatch& patch, const Texture& texture);

/// The mean of a map's unit normals, and the variance about it.
[[nodiscard]] MeanNormal mean_of_normals(const Texels& texels, glm::vec2 uv,
                                         const TexelPatch& patch, const Texture& texture);

}  // namespace asos
