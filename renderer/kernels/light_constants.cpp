#include "renderer/kernels/light_constants.h"

#include "renderer/shading/reflected_light.h"

#include <limits>

namespace asos {
namespace {

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
      one_less_cosine(static_cast<float>(prepared.one_less_cosine)),
      half_u(prepared.half_u),
      half_v(prepared.half_v),
      u_axis(prepared.u_axis),
      v_axis(prepared.v_axis),
      u_length(static_cast<float>(prepared.u_length)),
      v_length(static_cast<float>(prepared.v_length)),
      area(static_cast<float>(prepared.area)),
      highlight_radius(static_cast<float>(prepared.highlight_radius)),
      thickness(static_cast<float>(prepared.thickness)),
      two_sided(prepared.two_sided),
      shown_from(least_mirror(prepared)),
      rule(prepared.rule),
      inverse_range(static_cast<float>(prepared.inverse_range)),
      cone_scale(static_cast<float>(prepared.cone_scale)),
      cone_offset(static_cast<float>(prepared.cone_offset)) {}

}  // namespace asos
