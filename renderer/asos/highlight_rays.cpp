#include "renderer/asos/highlight_rays.h"

#include "renderer/geometry/direction.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/shadow_ray.h"

#include <algorithm>

namespace asos {
namespace {

/// Returns whether a ray reaches the point of the light nearest to a direction.
bool reaches(const EyeContext& eye, std::uint32_t light, const SurfacePoint& point,
             glm::vec3 mirrored) {
  const PreparedLight& prepared = eye.viewer.shader.lights()[light];
  if (!prepared.casts_shadows) return true;
  const Highlight nearest =
      highlight_of(prepared, glm::dvec3(point.position), glm::dvec3(mirrored));
  if (!(nearest.distance > 0.0f)) return true;
  eye.counts->count_shadow_ray(light);
  LightSample sample;
  sample.direction = glm::dvec3(nearest.direction);
  sample.distance = static_cast<double>(nearest.distance);
  return eye.scene->rays().transmittance(shadow_ray(point, sample), prepared.own_part) !=
         glm::vec3(0.0f);
}

}  // namespace

bool shows_highlight(const EyeContext& eye, std::uint32_t light, const SurfacePoint& point,
                     glm::vec3 to_viewer) {
  return reaches(eye, light, point, glm::reflect(-to_viewer, point.shading_normal));
}

// Half of GGX's facets lie within alpha of the normal, a fifth within half of alpha and four fifths
// within twice alpha. Reflected directions turn by twice the facet's angle.
HighlightRays rays_to_highlight(const EyeContext& eye, std::uint32_t light,
                                const SurfacePoint& point, glm::vec3 to_viewer, float roughness) {
  const glm::vec3 mirrored = glm::reflect(-to_viewer, point.shading_normal);
  const float alpha = alpha_of(roughness);
  const glm::vec3 right = 2.0f * alpha * any_perpendicular(mirrored);
  const glm::vec3 down = glm::cross(mirrored, right);
  HighlightRays rays;
  const auto send = [&](glm::vec3 aside) {
    ++rays.sent;
    rays.arrived += reaches(eye, light, point, glm::normalize(mirrored + aside));
  };
  send(glm::vec3(0.0f));
  const auto around = [&](glm::vec3 a, glm::vec3 b) {
    for (const glm::vec3& aside : {a, -a, b, -b}) send(aside);
  };
  constexpr float diagonal = 0.70710678f;
  around(0.5f * right, 0.5f * down);
  around(diagonal * (right + down), diagonal * (right - down));
  around(2.0f * right, 2.0f * down);
  return rays;
}

}  // namespace asos
