#include "renderer/shading/patch_lobe.h"

#include "renderer/shading/ggx.h"

#include <algorithm>
#include <cmath>

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

PatchLobe::PatchLobe(const NormalSpread& spread, const Lobe& lobe, glm::vec3 normal) {
  const glm::vec3 stretch = lobe.stretch.along;
  const bool stretched = !lobe.stretch.none();
  if (spread.flat() && !stretched) return;
  // A map's normals are distributed like a lobe and not like a box, so that their variance counts
  // twice (Toksvig 2005, Olano and Baker 2010): `variance` in each of two directions.
  const float turned =
      (glm::dot(spread.right, spread.right) + glm::dot(spread.down, spread.down)) * box_variance;
  const float added = turned + 2.0f * spread.variance;
  const float alpha2 = lobe.alpha() * lobe.alpha();
  const bool spreads = added > least_added * alpha2 && std::isfinite(added);
  if (!spreads && !stretched) return;
  wider_ = true;

  const auto [right, up] = axes_about(normal.x, normal.y, normal.z);
  tangent_ = {right.x, right.y, right.z};
  bitangent_ = {up.x, up.y, up.z};
  const float part = spreads ? std::min(1.0f, most_added / added) : 0.0f;
  const auto along = [&](glm::vec3 axis) -> LobeSpread<float> {
    if (!spreads) return {glm::dot(axis, stretch), 0.0f, 0.0f};
    return {glm::dot(axis, stretch), glm::dot(axis, spread.right), glm::dot(axis, spread.down)};
  };
  const float round = spreads ? alpha2 + part * spread.variance : alpha2;
  const auto [xx, xy, yy] =
      GgxSlopes<float>::of(round, part * box_variance, along(tangent_), along(bitangent_));
  xx_ = xx, xy_ = xy, yy_ = yy;
}

float PatchLobe::round_roughness() const {
  // The determinant is the fourth power of the isotropic lobe's alpha, its squared roughness.
  const float alpha =
      std::sqrt(std::sqrt(std::max(0.0f, GgxSlopes<float>{xx_, xy_, yy_}.determinant())));
  return std::min(1.0f, std::sqrt(alpha));
}

float PatchLobe::value(glm::vec3 half, glm::vec3 to_light, glm::vec3 to_viewer,
                       const BrdfAngles& angles) const {
  const GgxSlopes<float> slopes{xx_, xy_, yy_};
  const auto root = [&](float cosine, glm::vec3 v) {
    return std::sqrt(cosine * cosine +
                     slopes.quadratic(glm::dot(tangent_, v), glm::dot(bitangent_, v)));
  };
  const float det = slopes.determinant();
  const float stretched =
      slopes.stretched(glm::dot(tangent_, half), glm::dot(bitangent_, half), angles.n_dot_h, det);
  return ggx_over(GgxSlopes<float>::alpha2(det), stretched,
                  smith_shadowing(angles.n_dot_l, root(angles.n_dot_l, to_light), angles.n_dot_v,
                                  root(angles.n_dot_v, to_viewer)));
}

}  // namespace asos
