#include "renderer/asos/mirror_strictness.h"

#include "renderer/geometry/largest.h"
#include "renderer/shading/brdf.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

constexpr double faint_mirror = 0.25;
// ToyCar, 240x135, MAX 3, has an RMSE of 3.6e-3 with 1, 2.7e-3 with 8 and with more, in the same
// time.
constexpr double of_meshes = 8.0;

/// The share of light that a surface mirrors, by Schlick's Fresnel term.
double mirrored_share(const RenderScene& scene, const Hit& hit, const SurfacePoint& point,
                      glm::vec3 to_viewer) {
  const SurfaceMaterial seen = surface_material(scene.world(), scene.needs, hit);
  const float f0 = std::max(largest(seen.f0), coat_f0 * seen.coat.factor);
  const float away = 1.0f - std::abs(glm::dot(point.shading_normal, to_viewer));
  return static_cast<double>(glm::mix(f0, 1.0f, std::pow(std::max(0.0f, away), 5.0f)));
}

}  // namespace

double mirror_strictness(const RenderScene& scene, const Hit& hit, const SurfacePoint& point,
                         glm::vec3 to_viewer) {
  if (!scene.world().is_face(hit.triangle)) return of_meshes;
  return std::max(1.0, mirrored_share(scene, hit, point, to_viewer) / faint_mirror);
}

}  // namespace asos
