#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/leaf.h"
#include "renderer/shading/footprint.h"

// What a patch shows of textures that neither its hit nor a footprint of it tells.

namespace asos {

/// Whether a patch reaches far beyond the triangle that was hit, which tells of its own bend only.
[[nodiscard]] bool reaches_beyond_triangle(const World& world, const Hit& hit, const Patch& patch);

/// Whether it does on a bent mesh with textures, which need not go on there as they do on the
/// triangle.
[[nodiscard]] bool textured_by_several(const EyeContext& eye, const Hit& hit, const Patch& patch);

/// Whether a leaf reaches beyond its triangle on any mesh with textures or colours of its corners,
/// and what rays through it meet there lies elsewhere in the texture, or has another colour, than
/// the triangle, going on, would have it.
[[nodiscard]] bool strays_beyond_edges(const EyeContext& eye, const EyeSamples& samples,
                                       const Leaf& leaf);

/// Whether a patch with textures or colours of its corners recedes so much that what it shows of
/// them is not spread evenly over it: its far end is seen shorter than its near one.
[[nodiscard]] bool recedes(const EyeContext& eye, const Ray& ray, const Hit& hit,
                           const Patch& patch);

/// Whether what a patch shows of several textures together is not what it shows of their means, as
/// of metal that is rough here and rust there. The patch is that of a square with the area of a
/// leaf of weight `share`, `part` what the leaf is of it.
[[nodiscard]] bool uneven_products(const EyeContext& eye, const Hit& hit, const Patch& square,
                                   const PartShape& part, double share);

}  // namespace asos
