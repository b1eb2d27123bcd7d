#include "renderer/shadows/light_pyramid_caster.h"

namespace asos {

void LightPyramidCaster::start(const ShadowScene& scene, bool see_through,
                               const PreparedLight& light, const LightPyramid& pyramid,
                               bool gives_up) {
  ShadowCaster::start(scene, see_through, pyramid.frame(), light.own_part);
  may_give_up_ = gives_up;
  light_ = &light;
  pyramid_ = &pyramid;
}

std::optional<Ray> LightPyramidCaster::ray_at(glm::vec2 p) const {
  if (!pyramid_->holds(p)) return std::nullopt;
  Ray ray;
  ray.origin = glm::vec3(pyramid_->frame().apex());
  ray.direction = glm::vec3(pyramid_->towards(p));
  if (!pyramid_->infinitely_far())
    ray.t_far = end_before_light(*light_, pyramid_->frame().apex(), pyramid_->towards(p));
  return ray;
}

double LightPyramidCaster::measure(double weight, const LeafRegion& region) const {
  if (light_->rule == LightRule::physical) return pyramid_->form(region);
  const glm::dvec2 middle(region.square.centre_u(), region.square.centre_v());
  const glm::dvec3 to_light = pyramid_->towards(middle);
  const double distance2 = glm::dot(to_light, to_light);
  const double cosine = light_->traits().flat
                            ? std::abs(glm::dot(light_->towards, to_light)) / std::sqrt(distance2)
                            : 1.0;
  return weight * cosine / distance2;
}

}  // namespace asos
