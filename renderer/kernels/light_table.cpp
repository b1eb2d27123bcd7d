#include "renderer/kernels/light_table.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace asos {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

// The fields of LightTable that depend on the shape.
struct Extent {
  float radius = 0.0f;
  float extent = 1.0f;
  float near_linear = 0.0f, near_size = 0.0f;
  float least = std::numeric_limits<float>::min();
  float part_linear = 0.0f, part_square = 0.0f;
};

Extent flat_extent(const LightConstants& light, float radius) {
  return {.radius = radius, .extent = light.area, .near_size = 1.0f / pi, .part_square = pi};
}

Extent extent_of(ShapeTag<LightShape::point>, const LightConstants&) {
  return {};
}
Extent extent_of(ShapeTag<LightShape::distant>, const LightConstants&) {
  return {};
}
Extent extent_of(ShapeTag<LightShape::ball>, const LightConstants& light) {
  const float square = light.radius * light.radius;
  return {.radius = light.radius,
          .extent = pi * light.radius * light.radius,
          .least = std::max(square, std::numeric_limits<float>::min())};
}
Extent extent_of(ShapeTag<LightShape::sun>, const LightConstants& light) {
  return {.radius = light.radius, .extent = 2.0f * pi * light.one_less_cosine};
}
Extent extent_of(ShapeTag<LightShape::segment>, const LightConstants& light) {
  return {.radius = light.u_length,
          .extent = 2.0f * light.u_length,
          .near_linear = light.u_length,
          .part_linear = 2.0f};
}
Extent extent_of(ShapeTag<LightShape::disk>, const LightConstants& light) {
  return flat_extent(light, std::max(light.u_length, light.v_length));
}
template <LightShape shape>
requires(shape == LightShape::rectangle || shape == LightShape::polygon) Extent
    extent_of(ShapeTag<shape>, const LightConstants& light) {
  return flat_extent(light, std::max(glm::length(light.half_u + light.half_v),
                                     glm::length(light.half_u - light.half_v)));
}

}  // namespace

void LightTable::clear() {
  numbers_.clear();
  attenuates_ = false;
  for (std::vector<float>& values : fields_) values.clear();
}

void LightTable::add(const LightConstants& light, std::uint32_t number) {
  const LightTraits& traits = traits_of(light.shape);
  const Extent of = with_shape(light.shape, [&](auto shape) { return extent_of(shape, light); });
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
  set(radius, of.radius);
  if (traits.has_area() && !traits.flat) {
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
  set(far, traits.infinite ? 1.0f : 0.0f);
  set(two_sided, light.two_sided ? 1.0f : 0.0f);
  set(flat, traits.flat ? 1.0f : 0.0f);
  set(extent, of.extent);
  set(near_linear, of.near_linear);
  set(near_size, of.near_size);
  set(least, of.least);
  set(part_linear, of.part_linear);
  set(part_square, of.part_square);
  set3(power_x, light.power);
}

}  // namespace asos
