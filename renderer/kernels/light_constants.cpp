#include "renderer/kernels/light_constants.h"

#include "renderer/lights/light_math.h"
#include "renderer/shading/reflected_light.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace asos {
namespace {

glm::vec3 unit_or_zero(glm::dvec3 v) {
  const double length = glm::length(v);
  return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0.0f);
}

float least_mirror(const PreparedLight& light) {
  const auto least = shown_from(light);
  return least ? static_cast<float>(*least) : std::numeric_limits<float>::infinity();
}

}  // namespace

LightConstants::LightConstants(const PreparedLight& prepared)
    : shape(prepared.shape),
      light(&prepared),
      power(prepared.power),
      position(prepared.position),
      position_rest(prepared.position - glm::dvec3(position)),
      towards(prepared.towards),
      radius(static_cast<float>(prepared.radius)),
      half_u(prepared.half_u),
      half_v(prepared.half_v),
      u_axis(unit_or_zero(prepared.half_u)),
      v_axis(unit_or_zero(prepared.half_v)),
      u_length(static_cast<float>(glm::length(prepared.half_u))),
      v_length(static_cast<float>(glm::length(prepared.half_v))),
      area(static_cast<float>(prepared.area)),
      thickness(static_cast<float>(prepared.thickness)),
      two_sided(prepared.two_sided),
      shown_from(least_mirror(prepared)),
      lambertian(prepared.rule == LightRule::physical),
      representative(prepared.rule == LightRule::published),
      attenuates(prepared.inverse_range != 0.0 || prepared.cone_scale != 0.0),
      inverse_range(static_cast<float>(prepared.inverse_range)),
      cone_scale(static_cast<float>(prepared.cone_scale)),
      cone_offset(static_cast<float>(prepared.cone_offset)) {
  if (traits_of(shape).infinite) {
    const double cosine = 1.0 / std::sqrt(1.0 + prepared.radius * prepared.radius);
    const double sine = prepared.radius * cosine;
    one_less_cosine = static_cast<float>(sine * sine / (1.0 + cosine));
  }
  highlight_radius = traits_of(shape).line
                         ? u_length
                         : static_cast<float>(std::sqrt(prepared.area * std::numbers::inv_pi));
}

}  // namespace asos
