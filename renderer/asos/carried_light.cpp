#include "renderer/asos/carried_light.h"

#include "renderer/geometry/largest.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>

namespace asos {
namespace {

constexpr std::size_t no_part = std::numeric_limits<std::size_t>::max();

// The most that a surface makes of a light, which shows it no brighter than it is; at most white.
double brightest(const PreparedLight& light) {
  using LightShape = PreparedLight::Shape;
  const bool in_nits = light.shape == LightShape::polygon || light.shape == LightShape::disk ||
                       light.shape == LightShape::ball || light.shape == LightShape::sun;
  return in_nits ? std::min(1.0, static_cast<double>(largest(light.power))) : 1.0;
}

// Its intensity along its axis over pi, as a white wall's radiance there is. Of suns, which carry
// as much everywhere, none.
double reach2(const PreparedLight& light) {
  const auto power = static_cast<double>(largest(light.power)) * std::numbers::inv_pi;
  switch (light.shape) {
    case PreparedLight::Shape::point:
      return power;
    case PreparedLight::Shape::ball:
      return power * std::numbers::pi * light.radius * light.radius;
    case PreparedLight::Shape::segment:
      return power * 2.0 * glm::length(light.half_u);
    case PreparedLight::Shape::polygon:
    case PreparedLight::Shape::disk:
      return power * light.area;
    case PreparedLight::Shape::distant:
    case PreparedLight::Shape::sun:
      break;
  }
  return 0.0;
}

}  // namespace

CarriedLight::CarriedLight(std::span<const PreparedLight> lights)
    : points_(Recycler<LitBatch>::make()),
      places_(Recycler<LightPlaceBatch>::make()),
      rays_(Recycler<ShadowRayBatch>::make()) {
  std::map<std::int32_t, std::size_t> numbers;
  for (const PreparedLight& light : lights) {
    lights_.push_back({LightConstants(light), brightest(light), glm::vec3(light.position),
                       static_cast<float>(reach2(light))});
    part_of_light_.push_back(no_part);
    if (light.own_part < 0) continue;
    part_of_light_.back() = numbers.try_emplace(light.own_part, numbers.size()).first->second;
  }
  parts_.resize(numbers.size());
  for (std::size_t i = 0; i < LitBatch::size; ++i) {
    places_->u[i] = i % 2 == 0 ? 0x40000000u : 0xc0000000u;
    places_->v[i] = i / 2 % 2 == 0 ? 0x40000000u : 0xc0000000u;
  }
  start();
}

void CarriedLight::add(const LitPoint& point) {
  if (points_->count + places_a_light > LitBatch::size) return;
  for (std::size_t i = 0; i < places_a_light; ++i) points_->add(point, glm::vec3(1.0f));
}

const std::vector<double>& CarriedLight::most() {
  most_.assign(lights_.size(), 0.0);
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    const double bound = lights_[i].brightest;
    shade_batch(*points_, lights_[i].constants, *places_, *rays_);
    for (const auto& channel : rays_->carried)
      for (std::size_t k = 0; k < rays_->count; ++k)
        most_[i] = std::max(most_[i], std::min(bound, static_cast<double>(channel[k])));
  }
  hide_each_other();
  return most_;
}

double CarriedLight::by_white_walls(glm::vec3 position) const {
  double all = 0.0;
  for (const Light& light : lights_) {
    const glm::vec3 d = light.position - position;
    const float carried = light.reach2 / glm::dot(d, d);
    all += light.reach2 > 0.0f ? std::min(light.brightest, static_cast<double>(carried))
                               : light.brightest;
  }
  return all;
}

bool CarriedLight::near(glm::vec3 position, double carried) const {
  return std::any_of(lights_.begin(), lights_.end(), [&](const Light& light) {
    const glm::vec3 d = light.position - position;
    return light.reach2 > static_cast<float>(carried) * glm::dot(d, d);
  });
}

void CarriedLight::hide_each_other() {
  constexpr double sides = 2.0;
  std::fill(parts_.begin(), parts_.end(), Part{});
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    if (part_of_light_[i] == no_part) continue;
    Part& part = parts_[part_of_light_[i]];
    part.all += most_[i];
    part.most = std::max(part.most, sides * lights_[i].brightest);
  }
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    if (part_of_light_[i] == no_part) continue;
    const Part& part = parts_[part_of_light_[i]];
    if (part.all > part.most) most_[i] *= part.most / part.all;
  }
}

}  // namespace asos
