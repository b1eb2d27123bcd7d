#include "renderer/shading/highlight_unevenness.h"

#include "renderer/geometry/largest.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/ggx.h"
#include "renderer/shading/patch_curvature.h"
#include "renderer/shading/patch_lobe.h"
#include "renderer/shading/viewed_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace asos {
namespace {

float light_distance(const PreparedLight& light, glm::vec3 position) {
  if (light.traits().infinite) return std::numeric_limits<float>::infinity();
  return static_cast<float>(glm::distance(light.position, glm::dvec3(position)));
}

glm::vec3 viewer_from(const GlossyPatch& glossy, glm::vec3 offset) {
  return std::isfinite(glossy.viewer_distance)
             ? glm::normalize(glossy.to_viewer - offset / glossy.viewer_distance)
             : glossy.to_viewer;
}

// Returns the factor by which the samples of a line light differ. No ray of the lobe hits a line,
// so samples are places along it. Only those within the lobe contribute, and their weight grows as
// their number falls.
float spread_of_samples(const PreparedLight& line, const GlossyPatch& glossy, float alpha) {
  const auto length = 2.0f * static_cast<float>(glm::length(line.half_u));
  const float in_lobe = 4.0f * alpha * light_distance(line, glossy.point.position);
  return std::sqrt(std::max(1.0f, length / in_lobe));
}

}  // namespace

bool turns(const GlossyPatch& glossy) {
  // Bound on the second derivative of Schlick's term, per radian squared.
  constexpr float steepest = 20.0f, invisible = 1.0f / 4096.0f;
  float turn2 =
      glm::dot(glossy.turn.right, glossy.turn.right) + glm::dot(glossy.turn.down, glossy.turn.down);
  turn2 += glm::dot(glossy.stretch_turn, glossy.stretch_turn);
  if (std::isfinite(glossy.viewer_distance)) {
    const Patch& patch = glossy.patch;
    turn2 += (glm::dot(patch.right, patch.right) + glm::dot(patch.down, patch.down)) /
             (glossy.viewer_distance * glossy.viewer_distance);
  }
  return steepest * turn2 > 24.0f * invisible;
}

float reflectance_error(const GlossyPatch& glossy) {
  if (!turns(glossy)) return 0.0f;
  const Lobe& lobe = glossy.lobe;
  const auto reflectance = [&](glm::vec3 offset, glm::vec3 turn) {
    const glm::vec3 normal = glm::normalize(glossy.point.shading_normal + turn);
    const float n_dot_v = std::max(grazing_cosine, glm::dot(normal, viewer_from(glossy, offset)));
    return largest(environment_specular(lobe, n_dot_v));
  };
  const float middle = reflectance(glm::vec3(0.0f), glm::vec3(0.0f));
  const auto bend = [&](glm::vec3 edge, glm::vec3 turn) {
    const float ends =
        reflectance(0.5f * edge, 0.5f * turn) + reflectance(-0.5f * edge, -0.5f * turn);
    return std::abs(ends - 2.0f * middle) / 6.0f;
  };
  return bend(glossy.patch.right, glossy.turn.right) + bend(glossy.patch.down, glossy.turn.down);
}

HighlightError highlight_error(const PreparedLight& light, const GlossyPatch& glossy) {
  if (!light.extended() || light.rule != LightRule::physical) return {};
  const glm::vec3 n = glossy.point.shading_normal;
  const glm::vec3 mirrored = glm::reflect(-glossy.to_viewer, n);
  const Highlight nearest =
      highlight_of(light, glm::dvec3(glossy.point.position), glm::dvec3(mirrored));
  const glm::vec3 sum = nearest.direction + glossy.to_viewer;
  const float length = glm::length(sum);
  if (!(length > 0.0f)) return {};
  // Bound the highlight by the lobe at the place of the patch that is nearest to the light.
  const glm::vec3 half = sum / length;
  const float alpha = glossy.lobe.alpha();
  const LobeGeometry sight{glossy.to_viewer, glossy.viewer_distance, nearest.direction,
                           light_distance(light, glossy.point.position)};
  const NormalSpread spread = spread_about_half(glossy.turn, glossy.patch, sight);
  float spread2 = glm::dot(spread.right, spread.right) + glm::dot(spread.down, spread.down);
  if (!glossy.lobe.stretch.none()) {
    // A rotating ridge sweeps over the directions along it.
    const float along = glm::dot(half, glm::normalize(glossy.lobe.stretch.along));
    spread2 += along * along * glm::dot(glossy.stretch_turn, glossy.stretch_turn);
  }
  const float away = glossy.lobe.away_from_peak(n, half);
  const float least_away = std::max(0.0f, away - 0.5f * std::sqrt(spread2));
  const float width2 = alpha * alpha + least_away * least_away;
  const float fresnel =
      schlick(largest(glossy.lobe.f0), 1.0f, schlick_weight(glm::dot(half, glossy.to_viewer)));
  // A segment's power is in candela per metre: the segment looks as bright as a strip as wide as
  // the lobe.
  const float brightest =
      light.traits().line
          ? largest(light.power) / (alpha * light_distance(light, glossy.point.position))
          : largest(light.power);
  const float most = brightest * fresnel * alpha * alpha / width2;
  const bool line = light.traits().line;
  const float filled = line ? 1.0f : std::min(1.0f, 0.5f * nearest.half_angle_tangent / alpha);
  const float radiance = most * filled * filled;
  const float contrast = radiance * (line ? spread_of_samples(light, glossy, alpha) : 1.0f);
  const float of_middle =
      std::min(glossy.white, radiance) * std::min(1.0f, spread2 / (6.0f * width2));
  const float highlight = alpha + (line ? 0.0f : 0.5f * nearest.half_angle_tangent);
  const std::optional<PatchCurvature::Parts> parts =
      PatchCurvature::parts_for(spread, std::hypot(highlight, least_away));
  if (!parts) return {of_middle, contrast};
  const glm::vec3 right = spread.right / static_cast<float>(parts->right);
  const glm::vec3 down = spread.down / static_cast<float>(parts->down);
  const float part2 =
      parts->right * parts->down == 1 ? spread2 : glm::dot(right, right) + glm::dot(down, down);
  // Estimate the error of two-point quadrature along each edge of a part: h^4 / 270 of the fourth
  // derivative, where the centre's is h^2 / 6 of the second, with h half of an edge. A GGX lobe has
  // 72 / width^4 for the fourth derivative and 4 / width^2 for the second. The error is doubled,
  // because patches are curved along both edges.
  const float of_part = std::min(glossy.white, radiance) * std::min(1.0f, part2 / (6.0f * width2));
  return {of_part * std::min(1.0f, 0.2f * part2 / width2), contrast};
}

}  // namespace asos
