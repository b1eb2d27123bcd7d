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

/// Lights of some area that no surface of the world shows, by index: rays for
/// the viewer go through them, but what is mirrored shows them, for they are its highlights (CGF'98
/// section 5.1). A light is shown by its own part, and by an emissive stand-in around its middle.
using LightsWithoutGeometry = std::vector<std::uint32_t>;
[[nodiscard]] LightsWithoutGeometry find_lights_without_geometry(const World& world,
                                                                 std::span<const Light> lights);

/// Whether a part that shows a light of the file shows this one.
[[nodiscard]] bool stands_in(const Part& part, const Light& light);

/// Where a ray meets a light, and the radiance that it sends back.
struct LightHit {
  float t = 0.0f;
  glm::vec3 radiance{0.0f};
};
/// Between the ray's ends, on the side that shines; nothing for lights without an area.
[[nodiscard]] std::optional<LightHit> meet_light(const PreparedLight& light, const Ray& ray);

/// The outlines of such a light as seen from `apex`, or from infinitely far towards `direction`:
/// closed chains of points. Circles have `circle_points` of them.
inline constexpr int circle_points = 128;
[[nodiscard]] std::vector<std::vector<glm::dvec3>> light_outlines(const PreparedLight& light,
                                                                  std::optional<glm::dvec3> apex,
                                                                  glm::dvec3 direction);

/// Whether a cone may show some of a light with an area, from its apex: by the ball around the
/// light. `axis` is unit, the angle to the cone's side in radians. Conservative.
[[nodiscard]] bool may_show(const PreparedLight& light, glm::dvec3 apex, glm::dvec3 axis,
                            double half_angle);

}  // namespace asos
