#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// Indices of lights with an area that no surface of the world shows. Rays of the viewer pass
/// through them, but reflections contain them as highlights (CGF'98 section 5.1). A surface that
/// shows a light is its own part, or an emissive stand-in around its centre.
using LightsWithoutGeometry = std::vector<std::uint32_t>;
[[nodiscard]] LightsWithoutGeometry find_lights_without_geometry(const World& world,
                                                                 std::span<const Light> lights);

/// Returns whether a part that shows a light of the file (Part::shows_light) shows this light.
[[nodiscard]] bool stands_in(const Part& part, const Light& light);

/// Where a ray hits a light, and the radiance towards the ray's origin.
struct LightHit {
  float t = 0.0f;
  glm::vec3 radiance{0.0f};
};
/// Returns the hit between the ray's ends, on the emitting side; nothing for lights without an
/// area.
[[nodiscard]] std::optional<LightHit> meet_light(const PreparedLight& light, const Ray& ray);

/// Returns the outlines of a light with an area as seen from `apex`, or from infinity towards
/// `direction`, as closed chains of points. Circles have `circle_points` of them.
inline constexpr int circle_points = 128;
using LightOutlines = std::vector<std::vector<glm::dvec3>>;
[[nodiscard]] LightOutlines light_outlines(const PreparedLight& light,
                                           std::optional<glm::dvec3> apex, glm::dvec3 direction);

/// Returns whether a cone may contain part of a light with an area, by the ball around the light.
/// `axis` is unit, and the half angle is in radians. Conservative.
[[nodiscard]] bool may_show(const PreparedLight& light, glm::dvec3 apex, glm::dvec3 axis,
                            double half_angle);

}  // namespace asos
