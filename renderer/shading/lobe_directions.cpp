#include "renderer/shading/lobe_directions.h"

#include "renderer/shading/anisotropy.h"
#include "renderer/shading/ggx.h"
#include "renderer/shading/viewed_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {

Tangents::Tangents(glm::vec3 n) : normal(n) {
  const auto axes = axes_about(n.x, n.y, n.z);
  right = {axes.right.x, axes.right.y, axes.right.z};
  up = {axes.up.x, axes.up.y, axes.up.z};
}

Tangents::Tangents(glm::vec3 n, const LobeStretch& stretch) : Tangents(n) {
  if (stretch.none()) return;
  right = glm::normalize(stretch.along);
  up = glm::cross(n, right);
}

glm::vec3 visible_normal(glm::vec3 v, glm::vec2 alpha, glm::vec2 place) {
  const float r = std::sqrt(place.x);
  const float angle = 2.0f * std::numbers::pi_v<float> * place.y;
  const auto [x, y, z] = visible_normal(LobeVector<float>{v.x, v.y, v.z}, alpha.x, alpha.y,
                                        r * std::cos(angle), r * std::sin(angle));
  return glm::normalize(glm::vec3(x, y, z));
}

LobeDirections::LobeDirections(const Lobe& lobe, float spread, glm::vec3 normal,
                               glm::vec3 to_viewer)
    : f0_(lobe.f0), f90_(lobe.f90) {
  const Tangents tangents(normal, lobe.stretch);
  right_ = tangents.right;
  up_ = tangents.up;
  normal_ = tangents.normal;
  viewer_ = viewer_above(tangents.local(to_viewer));
  const float across = lobe.roughness * lobe.roughness;
  const glm::vec2 alpha(lobe.stretch.none() ? across : lobe.alpha_along(), across);
  alpha_ = glm::max(glm::sqrt(alpha * alpha + spread), least_alpha);
}

std::optional<LobeDirections::Direction> LobeDirections::mirrored(glm::dvec2 place) const {
  const glm::vec3 half = visible_normal(viewer_, alpha_, glm::vec2(place));
  const glm::vec3 light = glm::reflect(-viewer_, half);
  if (!(light.z > 0.0f)) return std::nullopt;
  // The weight is Fresnel's term times the height-correlated G2 over G1: the fraction of the facets
  // visible to the viewer that the light reaches.
  const glm::vec3 alpha(alpha_, 1.0f);
  const float met =
      smith_reached(light.z, glm::length(alpha * light), viewer_.z, glm::length(alpha * viewer_));
  const glm::vec3 fresnel = schlick(f0_, f90_, schlick_weight(glm::dot(viewer_, half)));
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
