#pragma once

#include "renderer/scene/scene.h"
#include "renderer/shading/texel_window.h"
#include "renderer/shading/texture.h"
#include "renderer/shading/texture_filter.h"

#include <glm/glm.hpp>

// Means over a patch of a bilinear texture's finest level, by points half a texel apart. Used where
// values between texels are no mixture of texels, or where the patch is oblique and covers few
// texels.

namespace asos {

/// Returns the mean over the whole patch.
[[nodiscard]] glm::vec4 mean_of_points(const Texels& texels, glm::vec2 uv, const TexelPatch& patch,
                                       const Texture& texture);

/// Returns the mean colour of the visible part and the mean alpha; if nothing is visible, the mean
/// of all.
[[nodiscard]] glm::vec4 mean_of_seen(const Texels& texels, const TexelUse& use, glm::vec2 uv,
                                     const TexelPatch& patch, const Texture& texture);

/// Returns the mean of a map's unit normals and their variance.
[[nodiscard]] MeanNormal mean_of_normals(const Texels& texels, glm::vec2 uv,
                                         const TexelPatch& patch, const Texture& texture);

}  // namespace asos
