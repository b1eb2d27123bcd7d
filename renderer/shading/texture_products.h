#pragma once

#include "renderer/shading/surface.h"

namespace asos {

/// Whether several of a material's textures are multiplied where it is shaded, or one of them tells
/// how it mirrors: what it shows is no mean of what they show each by itself.
[[nodiscard]] bool multiplies_textures(const Material& material, const SceneNeeds& needs);

/// By how much the display intensity of what a footprint shows of a material may differ from that
/// of a material that has the footprint's mean of each of its textures: by 16 points all over it
/// and their means, in even light half as bright as white, by half the sky's. Surfaces rougher than
/// `roughest_mirror` show a share of the sky, all others all of it. 0 where the first eight of the
/// points do not differ in two things.
[[nodiscard]] float product_error(const World& world, const SceneNeeds& needs, const Hit& hit,
                                  const Footprint& footprint, float roughest_mirror);

}  // namespace asos
