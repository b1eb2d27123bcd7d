#include "renderer/shading/specular_integral.h"

#include "renderer/lights/form_factor.h"
#include "renderer/lights/light_math.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/viewed_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace asos {
namespace {

using LightShape = PreparedLight::Shape;

/// A light of no size in the direction `to_light` (unit), by what it sends through a unit of area.
SpecularIntegral mirrored_point(const SpecularView& view, glm::dvec3 to_light, double flux) {
  const double cosine = cosine_above(to_light, view.receiver);
  if (!(cosine > 0.0)) return {};
  const glm::dvec3 n = view.receiver.normal;
  const glm::dvec3 half = glm::normalize(to_light + view.to_viewer);
  const double least = grazing_cosine;
  const double v_dot_h = std::clamp(glm::dot(view.to_viewer, half), 0.0, 1.0);
  const BrdfAngles angles{static_cast<float>(std::max(cosine, least)),
                          static_cast<float>(std::max(glm::dot(n, view.to_viewer), least)),
                          static_cast<float>(std::clamp(glm::dot(n, half), 0.0, 1.0)),
                          static_cast<float>(v_dot_h)};
  const double lobe =
      static_cast<double>(ggx_lobe(static_cast<float>(view.roughness), angles)) * cosine * flux;
  return {lobe, lobe * std::pow(1.0 - v_dot_h, 5.0)};
}

SpecularIntegral mirrored_point_light(const PreparedLight& light, const SpecularView& view) {
  const glm::dvec3 to_light = light.position - view.receiver.position;
  const double distance2 = glm::dot(to_light, to_light);
  if (!(distance2 > 0.0)) return {};
  return mirrored_point(view, to_light / std::sqrt(distance2), 1.0 / distance2);
}

double of_outlines(const PreparedLight& light, const Ltc& ltc, glm::dvec3 position, bool behind) {
  constexpr std::size_t few = 8;
  std::array<glm::dvec3, few> near_by;
  std::vector<glm::dvec3> many;
  double form = 0.0;
  for (const std::vector<glm::dvec3>& outline : light.outlines) {
    if (outline.size() > few) many.resize(outline.size());
    const std::span<glm::dvec3> corners(outline.size() > few ? many.data() : near_by.data(),
                                        outline.size());
    std::transform(outline.begin(), outline.end(), corners.begin(),
                   [&](glm::dvec3 corner) { return ltc.to_cosine * (corner - position); });
    form += polygon_form(corners, ltc.horizons);
  }
  return std::max(0.0, behind ? -form : form);
}

double of_cone(const Ltc& ltc, glm::dvec3 axis, double sine, double cosine) {
  const glm::dvec3 u = any_perpendicular(axis);
  return ellipse_form(ltc.to_cosine * (cosine * axis), ltc.to_cosine * (sine * u),
                      ltc.to_cosine * (sine * glm::cross(axis, u)), ltc.horizons);
}

double of_flat(const PreparedLight& light, const Ltc& ltc, glm::dvec3 position) {
  const glm::dvec3 to_middle = light.position - position;
  const double height = -glm::dot(to_middle, light.towards);
  if (height == 0.0 || (height < 0.0 && !light.two_sided)) return 0.0;
  if (light.shape == LightShape::polygon) return of_outlines(light, ltc, position, height < 0.0);
  return ellipse_form(ltc.to_cosine * to_middle, ltc.to_cosine * light.half_u,
                      ltc.to_cosine * light.half_v, ltc.horizons);
}

double of_ball(const PreparedLight& light, const Ltc& ltc, glm::dvec3 position) {
  const glm::dvec3 to_middle = light.position - position;
  const double distance = glm::length(to_middle);
  if (distance <= light.radius) return whole_form(ltc.horizons);
  const double sine = light.radius / distance;
  return of_cone(ltc, to_middle / distance, sine, std::sqrt((1.0 - sine) * (1.0 + sine)));
}

/// The integral over a line whose points shine the same in all directions. By the angle at the
/// receiver, after the transform, the integrand is smooth; 16 points (Gauss and Legendre) are
/// enough for a thousandth.
double of_even_line(const Ltc& ltc, glm::dvec3 begin, glm::dvec3 end) {
  constexpr std::array<double, 8> nodes{0.0950125098376374, 0.2816035507792589, 0.4580167776572274,
                                        0.6178762444026438, 0.7554044083550030, 0.8656312023878318,
                                        0.9445750230732326, 0.9894009349916499};
  constexpr std::array<double, 8> weights{
      0.1894506104550685, 0.1826034150449236, 0.1691565193950025, 0.1495959888165767,
      0.1246289712555339, 0.0951585116824928, 0.0622535239386479, 0.0271524594117541};
  const glm::dvec3 a = ltc.to_cosine * begin;
  const glm::dvec3 b = ltc.to_cosine * end;
  const double length_a = glm::length(a);
  const glm::dvec3 across = glm::cross(a, b);
  const double sine = glm::length(across);
  if (!(sine > 0.0) || !(length_a > 0.0)) return 0.0;
  const double angle = std::atan2(sine, glm::dot(a, b));
  const glm::dvec3 first = a / length_a;
  const glm::dvec3 second = glm::cross(across / sine, first);
  const double height = sine / glm::length(b - a);
  const glm::dmat3 back = glm::inverse(ltc.to_cosine);
  double sum = 0.0;
  for (std::size_t i = 0; i < 16; ++i) {
    const double node = i < 8 ? nodes[i] : -nodes[i - 8];
    const double turned = 0.5 * angle * (1.0 + node);
    const glm::dvec3 direction = std::cos(turned) * first + std::sin(turned) * second;
    sum += weights[i % 8] * std::max(0.0, direction.z) * glm::length(back * direction);
  }
  return 0.5 * angle * sum * glm::determinant(ltc.to_cosine) *
         (glm::length(end - begin) / glm::length(b - a)) / height;
}

/// A thin tube: how broad it is goes with how the transform stretches what is at right angles to it
/// (Heitz and Hill 2017).
double of_segment(const PreparedLight& light, const Ltc& ltc, glm::dvec3 position) {
  glm::dvec3 begin = light.position - light.half_u - position;
  glm::dvec3 end = light.position + light.half_u - position;
  const LinePart part = part_above(ltc.to_cosine * begin, ltc.to_cosine * end, ltc.horizons);
  if (!(part.first < part.second)) return 0.0;
  const glm::dvec3 along = end - begin;
  end = begin + part.second * along;
  begin += part.first * along;
  if (light.rule == LightRule::published) return of_even_line(ltc, begin, end);
  const glm::dvec3 across = glm::cross(begin, end);
  const double length = glm::length(across);
  if (!(length > 0.0)) return 0.0;
  // Where a normal of the plane through the line and the receiver comes to lie.
  const glm::dvec3 normal = glm::transpose(glm::inverse(ltc.to_cosine)) * (across / length);
  const Receiver receiver{glm::dvec3(0.0), glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 1)};
  return line_form(ltc.to_cosine * begin, ltc.to_cosine * end, true, receiver) /
         glm::length(normal);
}

double form_of(const PreparedLight& light, const Ltc& ltc, glm::dvec3 position) {
  switch (light.shape) {
    case LightShape::ball:
      return of_ball(light, ltc, position);
    case LightShape::sun: {
      const double cosine = 1.0 / std::sqrt(1.0 + light.radius * light.radius);
      return of_cone(ltc, light.towards, light.radius * cosine, cosine);
    }
    case LightShape::segment:
      return of_segment(light, ltc, position);
    case LightShape::polygon:
    case LightShape::disk:
      return of_flat(light, ltc, position);
    case LightShape::point:
    case LightShape::distant:
      break;
  }
  return 0.0;
}

}  // namespace

SpecularView::SpecularView(const Receiver& at, glm::dvec3 viewer, double surface_roughness)
    : receiver(at),
      to_viewer(viewer),
      roughness(surface_roughness),
      ltc(ltc_of(at, viewer, surface_roughness)) {}

SpecularIntegral specular_of(const PreparedLight& light, const SpecularView& view) {
  SpecularIntegral all;
  if (light.shape == LightShape::point) {
    all = mirrored_point_light(light, view);
  } else if (light.shape == LightShape::distant) {
    all = mirrored_point(view, light.towards, 1.0);
  } else {
    const glm::dvec3 position = view.receiver.position;
    all.lobe = view.ltc.lobe.weight * form_of(light, view.ltc.lobe, position);
    all.fresnel = view.ltc.fresnel.weight * form_of(light, view.ltc.fresnel, position);
  }
  if (light.shape == LightShape::point || light.shape == LightShape::ball) {
    const double left = attenuation(light, view.receiver.position);
    all.lobe *= left;
    all.fresnel *= left;
  }
  // Next to a line or a point light there is more than any float holds.
  constexpr double most = 1e200;
  return {std::min(all.lobe, most), std::min(all.fresnel, most)};
}

}  // namespace asos
