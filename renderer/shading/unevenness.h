#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/surface.h"
#include "renderer/world/world.h"

#include <span>

namespace asos {

/// By how much the mean display intensity (0 to 1) of a patch of surface may differ from that at
/// its middle, where a hit lies: the midpoint rule's error, to second order, of what shading does
/// across the patch. The shading normal turns (its cosine to a light errs by turn^2 / 24 along each
/// edge), near a light the inverse square of the distance falls off (6 / 24 of the squared ratio of
/// edge to distance), both times what the material reflects at most; and a smooth surface may hold
/// a light's highlight, narrower than the patch, where it is bent or the half vector turns across
/// it (by the physical rule that of a light without a size; of others see highlight_error). The
/// ray's direction is unit; `viewer_distance` in world units, infinite for parallel rays. Surfaces
/// beyond a boundary, shadows and textures are not looked at. 0 for flat shading under distant
/// lights, for unlit materials, and for patches that are not finite, which splitting would not make
/// so.
[[nodiscard]] float midpoint_error(const World& world, std::span<const Light> lights,
                                   const Ray& ray, const Hit& hit, const Patch& patch,
                                   float viewer_distance, LightRule rule = LightRule::physical);

/// The same for what the lights' highlights do across a patch whose normals have the variance of
/// the point's spread about its shading normal, as those of a normal map have: 0 for materials
/// without narrow highlights. `roughness` is what textures leave of it, `to_viewer` is unit.
[[nodiscard]] float glint_error(std::span<const Light> lights, const Material& material,
                                float roughness, const SurfacePoint& point, glm::vec3 to_viewer);

/// The same for the irradiance that a light of some size gives unshadowed, which falls off steeply
/// beside it: relative to what white would show of it. 0 for lights that are not near, compared
/// with the patch's size.
[[nodiscard]] float falloff_error(const PreparedLight& light, const Receiver& receiver,
                                  const Patch& patch);

/// The same for the rim of a spot's cone (its soft edge, KHR_lights_punctual), which may be
/// narrower than the patch: relative to what white would show inside the cone. 0 for other lights,
/// and where the patch lies wholly inside or outside, or the rim is about linear across it.
[[nodiscard]] float cone_error(const PreparedLight& light, const Receiver& receiver,
                               const Patch& patch);

}  // namespace asos
