#include "renderer/prepared/focus.h"

#include "renderer/geometry/view.h"
#include "renderer/shading/layers.h"

#include <algorithm>

namespace asos {
namespace {

// Rays across the picture; the surface that one of them meets nearest to the centre is in focus.
constexpr int rays_across = 17;

double automatic_focus(const RenderScene& scene, const Camera& camera,
                       const RenderSettings& settings) {
  const View view(camera, settings.width, settings.height,
                  radius_around_origin(scene.world().bounds));
  const glm::dvec2 size(settings.width, settings.height);
  double focus = 0.0, nearest = 2.0;
  for (int i = 0; i < rays_across * rays_across; ++i) {
    // From -1 to 1 across the picture, including 0.
    const glm::dvec2 at =
        glm::dvec2(i % rays_across, i / rays_across) * 2.0 / (rays_across - 1.0) - 1.0;
    const double distance = glm::dot(at, at);
    if (!(distance < nearest)) continue;
    const glm::dvec2 p = 0.5 * size * (1.0 + 0.999 * at);
    const Ray ray = view.ray(p.x, p.y);
    const Hit hit = closest_visible(scene.world(), scene.render_features, scene.rays(), ray,
                                    culling_of(settings));
    const double depth = hit.valid() ? view.depth(ray, hit.t) : 0.0;
    if (!(depth > 0.0)) continue;
    focus = depth;
    nearest = distance;
  }
  if (focus > 0.0) return focus;
  const glm::dvec3 eye(camera.world_from_camera[3]), back(camera.world_from_camera[2]);
  const Box& box = scene.world().bounds;
  const glm::dvec3 middle = 0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi));
  const double depth = box.empty() ? 0.0 : glm::dot(eye - middle, back);
  return depth > 0.0 ? depth : 1.0;
}

}  // namespace

Camera focused(const RenderScene& scene, const Camera& camera, const RenderSettings& settings) {
  Camera found = camera;
  if (camera.type == Camera::Type::perspective && camera.lens.blurs() && !camera.lens.focus)
    found.lens.focus = automatic_focus(scene, camera, settings);
  return found;
}

}  // namespace asos
