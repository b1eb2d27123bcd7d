#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/gloss.h"
#include "renderer/shading/surface.h"
#include "renderer/world/world.h"

#include <span>

namespace asos {

/// Returns the error of the hit's display intensity (0 to 1) as the mean of the patch around it:
/// that of the midpoint rule, to second order. It has three causes:
/// - The shading normal turns: its cosine to a light errs by turn^2 / 24 along each edge, and more
/// where part of the patch is beyond grazing. turn^2 / 3 is used.
/// - Near a light, the inverse square of the distance falls off: 6 / 24 of the squared ratio of
/// edge to distance. Both are multiplied by the largest reflectance.
/// - A glossy surface may contain a light's highlight narrower than the patch, where the surface is
/// curved or the half vector turns. Covers point lights by the physical rule; for others see
/// highlight_error.
/// The ray's direction is unit; `viewer_distance` is in world units, infinite for parallel rays.
/// Surfaces beyond a boundary, shadows and textures are ignored. Returns 0 for flat shading under
/// distant lights, for unlit materials, and for patches that are not finite, since splitting would
/// not help them.
[[nodiscard]] float midpoint_error(const World& world, std::span<const Light> lights,
                                   const Ray& ray, const Hit& hit, const Patch& patch,
                                   float viewer_distance, LightRule rule = LightRule::physical);

/// Returns the error for highlights of a lobe on a patch whose normals vary by the point's spread;
/// 0 without narrow highlights. `to_viewer` is unit.
[[nodiscard]] float glint_error(std::span<const Light> lights, const Lobe& lobe,
                                const SurfacePoint& point, glm::vec3 to_viewer);

/// Returns the error for the unshadowed irradiance of a light with an extent, which falls off
/// steeply near it, on a white surface. Returns 0 for lights that are distant compared with the
/// patch's size.
[[nodiscard]] float falloff_error(const PreparedLight& light, const Receiver& receiver,
                                  const Patch& patch);

/// Returns the error for the soft rim of a spot's cone (KHR_lights_punctual), which may be narrower
/// than the patch, on a white surface inside the cone. Returns 0 for other lights, for patches
/// entirely inside or outside, and where the rim is about linear across the patch.
[[nodiscard]] float cone_error(const PreparedLight& light, const Receiver& receiver,
                               const Patch& patch);

}  // namespace asos
