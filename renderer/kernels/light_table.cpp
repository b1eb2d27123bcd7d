#include "renderer/kernels/light_table.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace asos {
namespace {

using LightShape = LightConstants::Shape;

// Returns the radius of a sphere about the light's centre that contains the light.
float radius_of(const LightConstants& light) {
  switch (light.shape) {
    case LightShape::ball:
    case LightShape::sun:
      return light.radius;
    case LightShape::segment:
      return light.u_length;
    case LightShape::disk:
      return std::max(light.u_length, light.v_length);
    case LightShape::rectangle:
    case LightShape::polygon:
      return std::max(glm::length(light.half_u + light.half_v),
                      glm::length(light.half_u - light.half_v));
    case LightShape::point:
    case LightShape::distant:
      break;
  }
  return 0.0f;
}

}  // namespace

void LightTable::clear() {
  numbers_.clear();
  attenuates_ = false;
  for (std::vector<float>& values : fields_) values.clear();
}

void LightTable::add(const LightConstants& light, std::uint32_t number) {
  constexpr float pi = std::numbers::pi_v<float>;
  const std::size_t i = numbers_.size();
  numbers_.push_back(number);
  if (i % step == 0)
    for (std::vector<float>& values : fields_) values.resize(i + step, 0.0f);
  const auto set = [&](Field field, float value) { fields_[field][i] = value; };
  const auto set3 = [&](Field first, glm::vec3 v) {
    for (int c = 0; c < 3; ++c) set(static_cast<Field>(first + static_cast<std::size_t>(c)), v[c]);
  };
  set3(position_x, light.position + light.position_rest);
  set3(towards_x, light.towards);
  set(radius, radius_of(light));
  if (light.shape == LightShape::ball || light.shape == LightShape::sun) {
    set(round, light.radius);
  } else {
    const auto per_square = [](glm::vec3 v) {
      const float square = glm::dot(v, v);
      return square > 0.0f ? 1.0f / square : 0.0f;
    };
    set3(half_u_x, light.half_u);
    set3(half_v_x, light.half_v);
    set(per_u2, per_square(light.half_u));
    set(per_v2, per_square(light.half_v));
  }
  set(inverse_range, light.inverse_range);
  set(cone_scale, light.cone_scale);
  set(cone_offset, light.cone_offset);
  attenuates_ |= light.attenuates;
  set(shown_from, light.shown_from);
  set(far, light.shape == LightShape::distant || light.shape == LightShape::sun ? 1.0f : 0.0f);
  set(two_sided, light.two_sided ? 1.0f : 0.0f);
  set(least, std::numeric_limits<float>::min());
  set(extent, 1.0f);
  set3(power_x, light.power);
  switch (light.shape) {
    case LightShape::disk:
    case LightShape::rectangle:
    case LightShape::polygon:
      set(flat, 1.0f);
      set(extent, light.area);
      set(near_size, 1.0f / pi);
      set(part_square, pi);
      break;
    case LightShape::ball:
      set(extent, pi * light.radius * light.radius);
      set(least, std::max(light.radius * light.radius, std::numeric_limits<float>::min()));
      break;
    case LightShape::segment:
      set(extent, 2.0f * light.u_length);
      set(near_linear, light.u_length);
      set(part_linear, 2.0f);
      break;
    case LightShape::sun:
      set(extent, 2.0f * pi * light.one_less_cosine);
      break;
    case LightShape::point:
    case LightShape::distant:
      break;
  }
}

}  // namespace asos
