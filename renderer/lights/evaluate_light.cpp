#include "renderer/lights/kinds/ball.h"
#include "renderer/lights/kinds/capsule.h"
#include "renderer/lights/kinds/disk.h"
#include "renderer/lights/kinds/point.h"
#include "renderer/lights/kinds/polygon.h"
#include "renderer/lights/kinds/rectangle.h"
#include "renderer/lights/kinds/segment.h"
#include "renderer/lights/kinds/sun.h"

#include <algorithm>
#include <cmath>

// The functions of all lights, by their shapes' geometry.

namespace asos {

double attenuation(const PreparedLight& light, glm::dvec3 position) {
  return attenuation_towards(light, light.position - position);
}

glm::vec3 segment_irradiance(const PreparedLight& light, const Receiver& receiver, double t0,
                             double t1) {
  return irradiance_of(light.power,
                       LightGeometry<LightShape::segment>::part_form(light, receiver, t0, t1));
}

glm::vec3 unshadowed_irradiance(const PreparedLight& light, const Receiver& receiver) {
  const double form = with_shape(
      light.shape, [&](auto shape) { return LightGeometry<shape>::form(light, receiver); });
  return irradiance_of(light.power, form);
}

LightSample sample_light(const PreparedLight& light, const Receiver& receiver, double u, double v) {
  return with_shape(light.shape, [&](auto shape) -> LightSample {
    const auto found = SharedGeometry<shape>::sample(SampleQuery<shape>{light, receiver, {u, v}});
    if (!(found.distance > 0.0)) return {};
    return {found.direction, found.distance, irradiance_of(light.power, found.form)};
  });
}

glm::vec4 sample_numbers(const PreparedLight& light, const Receiver& receiver, double u, double v) {
  return with_shape(light.shape, [&](auto shape) -> glm::vec4 {
    if constexpr (traits_of(shape).sampling == Sampling::lanes_or_scalar)
      return LightGeometry<shape>::numbers(light, receiver, u, v);
    return {};
  });
}

std::optional<SampledHit> sampled_hit(const PreparedLight& light, const Receiver& receiver,
                                      glm::dvec3 direction) {
  return with_shape(light.shape, [&](auto shape) -> std::optional<SampledHit> {
    if constexpr (requires { LightGeometry<shape>::sampled_hit(light, receiver, direction); })
      return LightGeometry<shape>::sampled_hit(light, receiver, direction);
    return std::nullopt;
  });
}

Highlight highlight_of(const PreparedLight& light, glm::dvec3 position, glm::dvec3 mirrored_view) {
  return with_shape(light.shape, [&](auto shape) {
    const auto found =
        SharedGeometry<shape>::highlight(light, light.position - position, mirrored_view);
    return Highlight{glm::vec3(found.direction), static_cast<float>(found.half_angle_tangent),
                     static_cast<float>(found.distance)};
  });
}

void find_light_patches(const PreparedLight& light, const Receiver& receiver,
                        std::vector<LightPatch>& patches) {
  patches.clear();
  with_shape(light.shape, [&](auto shape) {
    if constexpr (traits_of(shape).has_area())
      LightGeometry<shape>::add_patches(light, receiver, patches);
  });
}

std::optional<LightHit> meet_light(const PreparedLight& light, const Ray& ray) {
  const glm::dvec3 origin(ray.origin), direction(ray.direction);
  const auto t = with_shape(light.shape, [&](auto shape) -> std::optional<double> {
    if constexpr (traits_of(shape).has_surface())
      return LightGeometry<shape>::meet(light, origin, direction);
    return std::nullopt;
  });
  if (!t || !(*t >= static_cast<double>(ray.t_near) && *t <= static_cast<double>(ray.t_far)))
    return std::nullopt;
  const auto shown = static_cast<float>(attenuation(light, origin));
  return LightHit{static_cast<float>(*t), shown * light.power};
}

LightOutlines light_outlines(const PreparedLight& light, std::optional<glm::dvec3> apex,
                             glm::dvec3 direction) {
  return with_shape(light.shape, [&](auto shape) -> LightOutlines {
    if constexpr (traits_of(shape).has_surface())
      return LightGeometry<shape>::outlines(light, apex, direction);
    return {};
  });
}

std::optional<LightWindow> LightWindow::around_ball(glm::dvec3 to_centre, double radius) {
  const double d2 = glm::dot(to_centre, to_centre);
  const double tangent2 = d2 - radius * radius;
  if (!(tangent2 > 0.0)) return std::nullopt;
  const double d = std::sqrt(d2);
  const glm::dvec3 axis = to_centre / d;
  const glm::dvec3 across = glm::normalize(
      glm::cross(axis, std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const double rim = radius * std::sqrt(tangent2) / d;
  return LightWindow{
      axis * (tangent2 / d), rim * across, rim * glm::cross(axis, across), Inside::ellipse, {}};
}

std::optional<LightWindow> light_window(const PreparedLight& light, glm::dvec3 apex) {
  return with_shape(light.shape, [&](auto shape) -> std::optional<LightWindow> {
    if constexpr (traits_of(shape).has_area()) return LightGeometry<shape>::window(light, apex);
    return std::nullopt;
  });
}

double way_to_light(const PreparedLight& light, glm::dvec3 from, glm::dvec3 towards) {
  return with_shape(light.shape, [&](auto shape) {
    constexpr LightTraits traits = traits_of(shape);
    if constexpr (traits.has_surface() && !traits.flat)
      return LightGeometry<shape>::way(light, from, towards);
    return 1.0;
  });
}

}  // namespace asos
