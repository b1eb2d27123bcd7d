#include "renderer/shading/reflected_light.h"

#include "renderer/geometry/largest.h"
#include "renderer/shading/patch_lobe.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {
namespace {

// Allowed error of a highlight's centre as its mean, relative to the highlight, however dark.
// Evaluating more of a patch is cheap compared with computing the light's visibility.
constexpr float negligible_share = 1.0f / 1024.0f;

/// Returns the distance of a light for its highlight.
float distance_of(const PreparedLight& light, glm::vec3 position) {
  if (light.traits().infinite) return std::numeric_limits<float>::infinity();
  return static_cast<float>(glm::distance(light.position, glm::dvec3(position)));
}

PatchLobe patch_lobe(const Lobe& lobe, const ViewedPoint& view, glm::vec3 to_light,
                     float light_distance) {
  const LobeGeometry sight{view.to_viewer, view.distance, to_light, light_distance};
  return {spread_about_half(view.point.spread, view.patch, sight), lobe, view.point.shading_normal};
}

/// Returns the lobe of a patch for a light with an extent, as an isotropic one. For a highlight
/// wider than the patch the lobe is not widened, since the patch is divided where needed, and
/// widening would add tails that the highlight does not have.
PatchLobe lobe_of_extended(Lobe lobe, const ViewedPoint& view, const Highlight& highlight,
                           const PreparedLight& light, Widening widening) {
  constexpr float widest = 0.5f;  // patch width over highlight width that needs no widening
  const bool line = light.traits().line;
  const float light_distance = distance_of(light, view.point.position);
  const LobeGeometry sight{view.to_viewer, view.distance, highlight.direction, light_distance};
  NormalSpread spread = spread_about_half(view.point.spread, view.patch, sight);
  // Across a line, the highlight is only as wide as the lobe.
  const float light_width = line ? 0.0f : 0.5f * highlight.half_angle_tangent;
  const float shown = widest * (lobe.alpha() + light_width);
  if (widening == Widening::by_bumps ||
      std::max(glm::dot(spread.right, spread.right), glm::dot(spread.down, spread.down)) <
          shown * shown)
    spread.right = spread.down = glm::vec3(0.0f);
  lobe.stretch = {};
  return {spread, lobe, view.point.shading_normal};
}

/// Returns the specular part; 0 below the horizon.
glm::vec3 shine_of(const Lobe& lobe, const ViewedPoint& view, glm::vec3 l, float light_distance) {
  const glm::vec3 n = view.point.shading_normal;
  if (!(glm::dot(n, l) > 0.0f)) return glm::vec3(0.0f);
  const glm::vec3 half = glm::normalize(l + view.to_viewer);
  const BrdfAngles angles{std::max(glm::dot(n, l), grazing_cosine), view.n_dot_v,
                          std::max(0.0f, glm::dot(n, half)),
                          std::max(0.0f, glm::dot(view.to_viewer, half))};
  if (lobe.is_sheen()) return specular_brdf(lobe, angles, round_lobe(lobe, angles));
  const PatchLobe wide = patch_lobe(lobe, view, l, light_distance);
  const float value =
      wide.wider() ? wide.value(half, l, view.to_viewer, angles) : round_lobe(lobe, angles);
  return specular_brdf(lobe, angles, value);
}

glm::vec3 diffuse_towards(const ViewedMaterial& seen, const ViewedPoint& view, glm::vec3 l) {
  return diffuse_brdf(seen, schlick_weight(view.to_viewer, l));
}

}  // namespace

glm::vec3 reflected_towards(const ViewedMaterial& seen, const ViewedPoint& view, glm::vec3 to_light,
                            float light_distance) {
  return diffuse_towards(seen, view, to_light) +
         shine_of(seen.lobe, view, to_light, light_distance);
}

glm::vec3 reflected_share(const PreparedLight& light, const ViewedMaterial& seen,
                          const ViewedPoint& view, const Highlight& highlight) {
  const glm::vec3 l = highlight.direction;
  glm::vec3 shine = shine_of(seen.lobe, view, l, distance_of(light, view.point.position));
  if (highlight.half_angle_tangent > 0.0f) {
    const float width = seen.lobe.alpha();
    const float ratio = width / (width + 0.5f * highlight.half_angle_tangent);
    shine *= light.traits().line ? ratio : ratio * ratio;
  }
  return diffuse_towards(seen, view, l) + shine;
}

glm::vec3 reflected_from(const Illumination& lit, const LightSample& sample) {
  if (!lit.lit || lit.light.rule == LightRule::published) return lit.reflected;
  const LightingQuery& point = *lit.lit;
  const glm::vec3 to_light(sample.direction);
  if (shows(point.mirrored, lit.light))
    return point.share * diffuse_towards(point.material, point.view, to_light);
  return point.share * reflected_towards(point.material, point.view, to_light,
                                         static_cast<float>(sample.distance));
}

bool is_broad(const Illumination& lit) {
  return lit.lit && lit.lit->material.lobe.is_broad();
}

float spread_over(const Illumination& lit) {
  const Receiver receiver = receiver_at(lit.point);
  float least = std::numeric_limits<float>::infinity(), most = 0.0f;
  constexpr double low = 0.05, high = 0.95;
  for (const glm::dvec2 p : {glm::dvec2(0.5), {low, low}, {low, high}, {high, low}, {high, high}}) {
    const LightSample at = sample_light(lit.light, receiver, p.x, p.y);
    if (at.irradiance == glm::vec3(0.0f)) continue;
    const float radiance = largest(reflected_from(lit, at) * lit.unshadowed);
    least = std::min(least, radiance);
    most = std::max(most, radiance);
  }
  return most > least ? most - least : 0.0f;
}

std::optional<MirroredLights> shown_from(const PreparedLight& light) {
  if (light.patterned) return MirroredLights::patterned;
  const bool surface = light.own_part >= 0 || light.traits().has_surface();
  return surface ? std::optional(MirroredLights::all) : std::nullopt;
}

ReflectedLights::ReflectedLights(const LightingQuery& point, std::optional<PatchCurvature> bend)
    : point_(point),
      receiver_(receiver_at(point.view.point)),
      bend_(bend),
      mirrored_(glm::reflect(glm::dvec3(-point.view.to_viewer), receiver_.normal)) {}

LightQuadrature& ReflectedLights::quadrature(float roughness) {
  Lobe lobe = point_.material.lobe;
  const bool wider = roughness != lobe.roughness;
  lobe.roughness = roughness;
  std::optional<LightQuadrature>& kept = wider ? wider_ : own_;
  if (wider || !kept) kept.emplace(receiver_, glm::dvec3(point_.view.to_viewer), lobe);
  return *kept;
}

ReflectedLights::LightReflection ReflectedLights::of(const PreparedLight& light,
                                                     glm::vec3 irradiance) {
  const Highlight highlight = highlight_of(light, receiver_.position, mirrored_);
  LightReflection share;
  if (light.extended() && light.rule == LightRule::physical) {
    share = of_extended(light, highlight, irradiance, Widening::by_patch);
  } else if (shows(point_.mirrored, light)) {
    // A reflection that contains the light replaces its highlight.
    share.reflected = diffuse_towards(point_.material, point_.view, highlight.direction);
  } else {
    share.reflected = reflected_share(light, point_.material, point_.view, highlight);
  }
  share.reflected *= point_.share;
  if (!bend_ || !light.extended() || light.rule != LightRule::physical) return share;
  const auto [error, parts] = bend_->of_middle(point_.view, point_.material.lobe, light, highlight);
  if (!parts) return share;
  // Broad lobes never split a leaf, so only the mean over the patch improves them.
  const float negligible = (point_.material.lobe.is_broad() ? 0.1f : 1.0f) * bend_->negligible;
  const float radiance = largest(share.reflected * irradiance);
  if (error * radiance > std::min(negligible, negligible_share * radiance)) {
    const glm::vec3 found = mean(light, *parts);
    for (int c = 0; c < 3; ++c) {
      if (irradiance[c] > 0.0f) share.reflected[c] = found[c] / irradiance[c];
    }
  } else if (error > 0.0f) {
    // The centre is accurate enough. A lobe widened by the patch would have tails that the
    // highlight does not have.
    share.reflected =
        point_.share * of_extended(light, highlight, irradiance, Widening::by_bumps).reflected;
  }
  return share;
}

glm::vec3 ReflectedLights::mean(const PreparedLight& light,
                                const PatchCurvature::Parts& parts) const {
  glm::vec3 sum(0.0f);
  bend_->for_each_point(point_.view, point_.material, parts, [&](const PatchCurvature::Point& at) {
    const glm::vec3 irradiance = unshadowed_irradiance(light, receiver_at(at.surface));
    if (irradiance == glm::vec3(0.0f)) return;
    const ViewedPoint view = viewed_point(at.surface, at.to_viewer);
    const LightingQuery lit{point_.lights,   view,         at.material,
                            point_.mirrored, point_.share, point_.shadows};
    sum += irradiance * ReflectedLights(lit).of(light, irradiance).reflected;
  });
  return sum / static_cast<float>(4 * parts.right * parts.down);
}

ReflectedLights::LightReflection ReflectedLights::of_extended(const PreparedLight& light,
                                                              const Highlight& highlight,
                                                              glm::vec3 irradiance,
                                                              Widening widening) {
  const ViewedMaterial& seen = point_.material;
  const bool mirrored = shows(point_.mirrored, light);
  if (mirrored && (seen.falloff == 0.0f || seen.diffuse == glm::vec3(0.0f)))
    return {diffuse_brdf(seen, 0.0f)};
  // The ratio of power to irradiance is the same for all colours; the strongest one has the most
  // digits.
  int strongest = 0;
  for (int i = 1; i < 3; ++i) {
    if (irradiance[i] > irradiance[strongest]) strongest = i;
  }
  const double per_irradiance =
      static_cast<double>(light.power[strongest]) / static_cast<double>(irradiance[strongest]);
  if (!(per_irradiance > 0.0)) return {};
  const Lobe& own = seen.lobe;
  const PatchLobe lobe = lobe_of_extended(own, point_.view, highlight, light, widening);
  const bool wider = lobe.wider() && !own.is_sheen();
  const ReflectedIntegral all = quadrature(wider ? lobe.round_roughness() : own.roughness)(light);
  const double schlick = std::clamp(all.scattered * per_irradiance, 0.0, 1.0);
  LightReflection share{diffuse_brdf(seen, static_cast<float>(schlick))};
  if (mirrored) return share;
  const glm::dvec3 specular =
      glm::dvec3(own.f0) * all.lobe + (glm::dvec3(own.f90) - glm::dvec3(own.f0)) * all.fresnel;
  constexpr double most = std::numeric_limits<float>::max();
  const glm::vec3 shine(glm::clamp(specular * per_irradiance, 0.0, most));
  share.reflected += shine;
  share.highlight = largest(point_.share * shine * irradiance);
  return share;
}

}  // namespace asos
