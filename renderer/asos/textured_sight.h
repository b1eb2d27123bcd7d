#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/shading/footprint.h"

// Textures of a patch that neither its hit nor the footprint of that hit represents.

namespace asos {

/// Returns whether a patch extends far beyond the triangle of its hit, so that this triangle does
/// not represent the patch.
[[nodiscard]] bool reaches_beyond_triangle(const World& world, const Hit& hit, const Patch& patch);

/// Returns whether a patch of a curved, textured mesh extends far beyond its hit's triangle.
/// Textures need not continue there as on the triangle.
[[nodiscard]] bool textured_by_several(const EyeContext& eye, const Hit& hit, const Patch& patch);

/// Returns whether a leaf extends beyond its triangle and the colours there differ from the
/// triangle's extrapolated ones. It casts rays there and compares texture coordinates and vertex
/// colours.
[[nodiscard]] bool strays_beyond_edges(const EyeContext& eye, const EyeSamples& samples,
                                       const Leaf& leaf);

/// Returns whether a textured patch is so oblique that perspective shortens its far end. Then its
/// texture is not spread evenly over the leaf. Vertex colours count, too.
[[nodiscard]] bool recedes(const EyeContext& eye, const Ray& ray, const Hit& hit,
                           const Patch& patch);

/// Returns whether the mean shading of a patch with several textures differs from the shading of
/// their means, such as rough metal next to rust. `square` is the patch of a square with the area
/// of a leaf of weight `share`, and `part` is the leaf's shape in it.
[[nodiscard]] bool uneven_products(const EyeContext& eye, const Ray& ray, const Hit& hit,
                                   const Patch& square, const FootprintShape& part, double share);

}  // namespace asos
