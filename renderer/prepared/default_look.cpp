#include "renderer/prepared/default_look.h"

#include "renderer/prepared/own_lights.h"
#include "renderer/shading/environment_picture.h"
#include "renderer/world/ground.h"

namespace asos {
namespace {

bool stands_below(const World& world, const Camera& camera) {
  const Box bounds = bounds_without_ground(world);
  return !bounds.empty() && camera.world_from_camera[3].y > static_cast<double>(bounds.lo.y);
}

}  // namespace

DefaultLook default_look(const RenderScene& scene, const Camera& camera) {
  const AnimationInvariants& stage = scene.geometry->stage;
  if (!stage.has_default_lighting) return {};
  const bool ground = !stage.default_lighting_inside && stands_below(scene.world(), camera);
  return {std::make_shared<const Sky>(Environment::softboxes), ground ? Ground::on : Ground::off};
}

DefaultLook default_look(const RenderScene& scene) {
  return default_look(scene, first_camera(scene.world()));
}

Ground likely_ground(const World& world, bool dark, const Camera& camera) {
  const Box bounds = bounds_without_ground(world);
  const glm::dvec3 eye(camera.world_from_camera[3]);
  const bool inside = glm::all(glm::greaterThanEqual(eye, glm::dvec3(bounds.lo))) &&
                      glm::all(glm::lessThanEqual(eye, glm::dvec3(bounds.hi)));
  return dark && !inside && stands_below(world, camera) ? Ground::on : Ground::off;
}

Background default_background(const Sky* sky) {
  Background background;
  if (!sky || !sky->choice().environment || !has_picture(*sky->choice().environment))
    return background;
  const glm::vec3 far = glm::vec3(ground_albedo) * sky->ambient({0.0f, 1.0f, 0.0f});
  background.kind = BackgroundKind::colours;
  background.top = background.bottom = glm::min(far, glm::vec3(Background::brightest));
  return background;
}

}  // namespace asos
