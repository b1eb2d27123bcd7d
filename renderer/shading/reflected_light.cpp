#include "renderer/shading/reflected_light.h"

#include "renderer/shading/lobe.h"

#include <algorithm>
#include <limits>

namespace asos {
namespace {

/// How far a light is, as its highlight goes.
float distance_of(const PreparedLight& light, glm::vec3 position) {
  using LightShape = PreparedLight::Shape;
  if (light.shape == LightShape::distant || light.shape == LightShape::sun)
    return std::numeric_limits<float>::infinity();
  return static_cast<float>(glm::distance(light.position, glm::dvec3(position)));
}

PatchLobe lobe_of(const ViewedMaterial& seen, const ViewedPoint& view, glm::vec3 to_light,
                  float light_distance) {
  const LobeSight sight{view.to_viewer, view.distance, to_light, light_distance};
  return {spread_about_half(view.point.spread, view.patch, sight), seen.roughness,
          view.point.shading_normal};
}

struct Shine {
  BrdfAngles angles;
  float lobe = 0.0f;
};

Shine shine_of(const ViewedMaterial& seen, const ViewedPoint& view, glm::vec3 l,
               float light_distance) {
  const glm::vec3 n = view.point.shading_normal;
  const glm::vec3 half = glm::normalize(l + view.to_viewer);
  const BrdfAngles angles{std::max(glm::dot(n, l), grazing_cosine), view.n_dot_v,
                          std::max(0.0f, glm::dot(n, half)),
                          std::max(0.0f, glm::dot(view.to_viewer, half))};
  const PatchLobe lobe = lobe_of(seen, view, l, light_distance);
  return {angles, lobe.wider() ? lobe.value(half, l, view.to_viewer, angles)
                               : ggx_lobe(seen.roughness, angles)};
}

}  // namespace

glm::vec3 reflected_towards(const ViewedMaterial& seen, const ViewedPoint& view, glm::vec3 to_light,
                            float light_distance) {
  // Light from below the horizon is not mirrored.
  if (!(glm::dot(view.point.shading_normal, to_light) > 0.0f)) return brdf(seen, {}, 0.0f);
  const Shine shine = shine_of(seen, view, to_light, light_distance);
  return brdf(seen, shine.angles, shine.lobe);
}

glm::vec3 reflected_share(const PreparedLight& light, const ViewedMaterial& seen,
                          const ViewedPoint& view, const Highlight& highlight) {
  const glm::vec3 l = highlight.direction;
  if (!(glm::dot(view.point.shading_normal, l) > 0.0f)) return brdf(seen, {}, 0.0f);
  Shine shine = shine_of(seen, view, l, distance_of(light, view.point.position));
  if (highlight.half_angle_tangent > 0.0f) {
    const float roughness = std::max(seen.roughness, roughness_floor);
    const float width = roughness * roughness;
    const float ratio = width / (width + 0.5f * highlight.half_angle_tangent);
    shine.lobe *= light.shape == PreparedLight::Shape::segment ? ratio : ratio * ratio;
  }
  return brdf(seen, shine.angles, shine.lobe);
}

glm::vec3 reflected_from(const Illumination& lit, const LightSample& sample) {
  if (!lit.lit || lit.light.rule == LightRule::published) return lit.reflected;
  const LitPoint& point = *lit.lit;
  if (point.mirrors && shown_by_mirrors(lit.light))
    return point.share * brdf(point.material, {}, 0.0f);
  return point.share * reflected_towards(point.material, point.view, glm::vec3(sample.direction),
                                         static_cast<float>(sample.distance));
}

glm::vec3 mirrored_share(const PreparedLight& light, const ViewedMaterial& seen,
                         const ViewedPoint& view, const SpecularView& own,
                         const Highlight& highlight, glm::vec3 irradiance) {
  const glm::vec3 diffuse = brdf(seen, {}, 0.0f);
  // Power over irradiance is the same for all colours: that of the strongest has the most digits.
  int strongest = 0;
  for (int i = 1; i < 3; ++i) {
    if (irradiance[i] > irradiance[strongest]) strongest = i;
  }
  if (!(irradiance[strongest] > 0.0f)) return diffuse;
  const double per_irradiance =
      static_cast<double>(light.power[strongest]) / static_cast<double>(irradiance[strongest]);
  const PatchLobe lobe =
      lobe_of(seen, view, highlight.direction, distance_of(light, view.point.position));
  const SpecularIntegral all =
      lobe.wider()
          ? specular_of(light, SpecularView(own.receiver, own.to_viewer, lobe.round_roughness()))
          : specular_of(light, own);
  const glm::dvec3 mirrored =
      glm::dvec3(seen.f0) * all.lobe + (glm::dvec3(seen.f90) - glm::dvec3(seen.f0)) * all.fresnel;
  constexpr double most = std::numeric_limits<float>::max();
  return diffuse + glm::vec3(glm::clamp(mirrored * per_irradiance, 0.0, most));
}

bool shown_by_mirrors(const PreparedLight& light) {
  using LightShape = PreparedLight::Shape;
  return light.shape == LightShape::ball || light.shape == LightShape::polygon ||
         light.shape == LightShape::disk;
}

}  // namespace asos
