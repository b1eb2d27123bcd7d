#pragma once

#include "renderer/shading/surface.h"

namespace asos {

/// Returns whether shading multiplies several of a material's textures, or a texture affects its
/// reflections. Then the mean of the shading is not the shading of the textures' means.
[[nodiscard]] bool multiplies_textures(const Material& material,
                                       const RenderFeatures& render_features);

/// Returns the error of a footprint's display intensity if shading uses the mean of each texture.
/// It compares 16 points of the footprint with their means, in uniform light that is half as bright
/// as white. Half of the diffuse light comes from the sky and is occluded. Surfaces rougher than
/// `roughest_mirror` reflect a fraction of the sky, and others all of it. Returns 0 if the first
/// eight points do not differ in two factors.
[[nodiscard]] float product_error(const World& world, const RenderFeatures& render_features,
                                  const Hit& hit, const Footprint& footprint,
                                  float roughest_mirror);

}  // namespace asos
