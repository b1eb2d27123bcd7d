#include "renderer/shading/lobe_directions.h"

#include "renderer/shading/anisotropy.h"
#include "renderer/shading/viewed_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {

Tangents::Tangents(glm::vec3 n) : normal(n) {
  const float sign = std::copysign(1.0f, n.z);
  const float a = -1.0f / (sign + n.z);
  const float b = n.x * n.y * a;
  right = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
  up = {b, sign + n.y * n.y * a, -n.y};
}

Tangents::Tangents(glm::vec3 n, const LobeStretch& stretch) : Tangents(n) {
  if (stretch.none()) return;
  right = glm::normalize(stretch.along);
  up = glm::cross(n, right);
}

glm::vec3 visible_normal(glm::vec3 v, glm::vec2 alpha, glm::vec2 place) {
  const glm::vec3 stretched = glm::normalize(glm::vec3(alpha.x * v.x, alpha.y * v.y, v.z));
  const float r = std::sqrt(place.x);
  const float angle = 2.0f * std::numbers::pi_v<float> * place.y;
  const float x = r * std::cos(angle);
  const float s = 0.5f * (1.0f + stretched.z);
  const float length = std::hypot(stretched.x, stretched.y);
  const glm::vec3 t1 = length > 0.0f ? glm::vec3(-stretched.y, stretched.x, 0.0f) / length
                                     : glm::vec3(1.0f, 0.0f, 0.0f);
  const glm::vec3 t2 = glm::cross(stretched, t1);
  const float y = glm::mix(std::sqrt(std::max(0.0f, 1.0f - x * x)), r * std::sin(angle), s);
  const glm::vec3 n = x * t1 + y * t2 + std::sqrt(std::max(0.0f, 1.0f - x * x - y * y)) * stretched;
  return glm::normalize(glm::vec3(alpha.x * n.x, alpha.y * n.y, std::max(0.0f, n.z)));
}

LobeDirections::LobeDirections(const ViewedMaterial& material, float spread, glm::vec3 normal,
                               glm::vec3 to_viewer)
    : f0_(material.f0), f90_(material.f90) {
  const Tangents tangents(normal, material.stretch);
  right_ = tangents.right;
  up_ = tangents.up;
  normal_ = tangents.normal;
  viewer_ = viewer_above(tangents.local(to_viewer));
  const float across = material.roughness * material.roughness;
  const glm::vec2 alpha(
      material.stretch.none() ? across : alpha_along(material.stretch, material.roughness), across);
  alpha_ = glm::max(glm::sqrt(alpha * alpha + spread), least_alpha);
}

std::optional<LobeDirections::Direction> LobeDirections::mirrored(glm::dvec2 place) const {
  const glm::vec3 half = visible_normal(viewer_, alpha_, glm::vec2(place));
  const glm::vec3 light = glm::reflect(-viewer_, half);
  if (!(light.z > 0.0f)) return std::nullopt;
  // The weight is Fresnel's term times the height-correlated G2 over G1: the fraction of the facets
  // visible to the viewer that the light reaches.
  const float by_viewer = light.z * glm::length(glm::vec3(alpha_, 1.0f) * viewer_);
  const float by_light = viewer_.z * glm::length(glm::vec3(alpha_, 1.0f) * light);
  const float met = (by_viewer + light.z * viewer_.z) / (by_viewer + by_light);
  const float m = std::clamp(1.0f - glm::dot(viewer_, half), 0.0f, 1.0f);
  const glm::vec3 fresnel = f0_ + (f90_ - f0_) * (m * m * m * m * m);
  return Direction{world(light), met * fresnel};
}

std::optional<glm::vec3> LobeDirections::refracted(glm::dvec2 place, float ratio) const {
  const glm::vec3 half = visible_normal(viewer_, alpha_, glm::vec2(place));
  if (ratio == 1.0f) {
    const glm::vec3 light = glm::reflect(-viewer_, half);
    return world({light.x, light.y, -std::abs(light.z)});
  }
  const glm::vec3 light = glm::refract(-viewer_, half, ratio);
  return light.z < 0.0f ? std::optional(world(light)) : std::nullopt;
}

}  // namespace asos
