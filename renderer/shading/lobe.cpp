#include "renderer/shading/lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

// Variance of a turn that is distributed evenly over the patch's edge.
constexpr float box_variance = 1.0f / 12.0f;
// Fraction of a lobe's alpha^2 below which an addition has no visible effect.
constexpr float least_added = 1e-3f;

}  // namespace

NormalSpread spread_about_half(const NormalSpread& normals, const Patch& patch,
                               const LobeGeometry& sight) {
  const glm::vec3 sum = sight.to_viewer + sight.to_light;
  const float length = glm::length(sum);
  if (!(length > 0.0f)) return normals;
  const glm::vec3 half = sum / length;
  const auto turned = [](glm::vec3 edge, glm::vec3 direction, float distance) {
    return (glm::dot(direction, edge) * direction - edge) / distance;
  };
  const auto turn = [&](glm::vec3 edge) {
    const glm::vec3 d = (turned(edge, sight.to_viewer, sight.viewer_distance) +
                         turned(edge, sight.to_light, sight.light_distance)) /
                        length;
    return d - glm::dot(half, d) * half;
  };
  return {normals.right - turn(patch.right), normals.down - turn(patch.down), normals.variance};
}

PatchLobe::PatchLobe(const NormalSpread& spread, float roughness, glm::vec3 normal,
                     glm::vec3 stretch) {
  const bool stretched = stretch != glm::vec3(0.0f);
  if (spread.flat() && !stretched) return;
  // A map's normals are distributed like a lobe and not like a box, so that their variance counts
  // twice (Toksvig 2005, Olano and Baker 2010): `variance` in each of two directions.
  const float turned =
      (glm::dot(spread.right, spread.right) + glm::dot(spread.down, spread.down)) * box_variance;
  const float added = turned + 2.0f * spread.variance;
  const float alpha = std::clamp(roughness, roughness_floor, 1.0f);
  const float alpha2 = alpha * alpha * alpha * alpha;
  const bool spreads = added > least_added * alpha2 && std::isfinite(added);
  if (!spreads && !stretched) return;
  wider_ = true;

  // A tangent frame of any direction (Duff et al. 2017).
  const float sign = std::copysign(1.0f, normal.z);
  const float a = -1.0f / (sign + normal.z);
  const float b = normal.x * normal.y * a;
  tangent_ = {1.0f + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
  bitangent_ = {b, sign + normal.y * normal.y * a, -normal.y};

  const glm::vec2 s(glm::dot(tangent_, stretch), glm::dot(bitangent_, stretch));
  xx_ = alpha2 + s.x * s.x;
  yy_ = alpha2 + s.y * s.y;
  xy_ = s.x * s.y;
  if (!spreads) return;
  const float part = std::min(1.0f, most_added / added);
  const float turn = part * box_variance;
  const float round = alpha2 + part * spread.variance;
  const glm::vec2 r(glm::dot(tangent_, spread.right), glm::dot(bitangent_, spread.right));
  const glm::vec2 d(glm::dot(tangent_, spread.down), glm::dot(bitangent_, spread.down));
  xx_ = round + s.x * s.x + turn * (r.x * r.x + d.x * d.x);
  yy_ = round + s.y * s.y + turn * (r.y * r.y + d.y * d.y);
  xy_ = s.x * s.y + turn * (r.x * r.y + d.x * d.y);
}

float PatchLobe::round_roughness() const {
  // The determinant is the fourth power of the isotropic lobe's alpha, its squared roughness.
  const float alpha = std::sqrt(std::sqrt(std::max(0.0f, xx_ * yy_ - xy_ * xy_)));
  return std::min(1.0f, std::sqrt(alpha));
}

float PatchLobe::quadratic(glm::vec3 v) const {
  const float x = glm::dot(tangent_, v);
  const float y = glm::dot(bitangent_, v);
  return xx_ * x * x + 2.0f * xy_ * x * y + yy_ * y * y;
}

float PatchLobe::value(glm::vec3 half, glm::vec3 to_light, glm::vec3 to_viewer,
                       const BrdfAngles& angles) const {
  // GGX and Smith's height-correlated shadowing with a matrix for alpha^2 (Heitz 2014).
  const float x = glm::dot(tangent_, half);
  const float y = glm::dot(bitangent_, half);
  const float det = xx_ * yy_ - xy_ * xy_;
  const float slopes = (yy_ * x * x - 2.0f * xy_ * x * y + xx_ * y * y) / det;
  const float d = slopes + angles.n_dot_h * angles.n_dot_h;
  const float distribution = std::numbers::inv_pi_v<float> / (std::sqrt(det) * d * d);
  const float nl = angles.n_dot_l;
  const float nv = angles.n_dot_v;
  const float shadowing = nl * std::sqrt(nv * nv + quadratic(to_viewer)) +
                          nv * std::sqrt(nl * nl + quadratic(to_light));
  return distribution * 0.5f / shadowing;
}

}  // namespace asos
