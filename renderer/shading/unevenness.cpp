#include "renderer/shading/unevenness.h"

#include "renderer/geometry/largest.h"
#include "renderer/shading/anisotropy.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/ggx.h"
#include "renderer/shading/gloss.h"
#include "renderer/shading/patch_lobe.h"
#include "renderer/shading/texture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asos {
namespace {

/// Variation of a patch's normals, and its viewer.
struct Bend {
  glm::vec3 normal{0, 0, 1};  // the shading normal, unit, on the viewer's side
  NormalSpread spread;
  Patch patch;
  float viewer_distance = std::numeric_limits<float>::infinity();

  /// Returns the squared turns of the normals along the patch's edges, summed. A uniform turn along
  /// an edge has a variance of 1/12 of its square.
  [[nodiscard]] static float turn2(const NormalSpread& spread) {
    return glm::dot(spread.right, spread.right) + glm::dot(spread.down, spread.down) +
           12.0f * spread.variance;
  }
  /// Returns turn2 of the normals about the half vector of a light, which turns as well.
  [[nodiscard]] float turn2_about_half(glm::vec3 to_viewer, glm::vec3 to_light,
                                       float light_distance) const {
    return turn2(
        spread_about_half(spread, patch, {to_viewer, viewer_distance, to_light, light_distance}));
  }
};

Bend bend_of(const World& world, const Hit& hit, const Patch& patch, glm::vec3 to_viewer,
             float viewer_distance) {
  const auto [n0, n1, n2] = corner_normals(world, hit);
  const glm::vec3 mixed = (1.0f - hit.b1 - hit.b2) * n0 + hit.b1 * n1 + hit.b2 * n2;
  const float length = glm::length(mixed);
  if (!(length > 0.0f)) return {{0, 0, 1}, {}, patch, viewer_distance};
  const glm::vec3 normal = (glm::dot(mixed, to_viewer) < 0.0f ? -1.0f : 1.0f) / length * mixed;
  return {normal, normal_turn(world, hit, patch, normal), patch, viewer_distance};
}

/// Returns the lobe of a surface at a hit, from its textures and without its stretch.
Lobe lobe_at(const World& world, const Hit& hit, const Material& material) {
  float roughness = material.roughness, metallic = material.metallic;
  const TextureUse& use = material.metallic_roughness_texture;
  if (use.used()) {
    const glm::vec4 texel =
        sample_texture(world, use, hit.triangle, hit.b1, hit.b2, Encoding::linear);
    roughness *= texel.g;
    metallic *= texel.b;
  }
  const glm::vec3 c = glm::vec3(material.base_color);
  return {glm::vec3(glm::mix(0.04f, largest(c), metallic)), glm::vec3(1.0f), roughness};
}

/// Returns the anisotropic stretch of the lobe at a hit.
LobeStretch stretch_of(const World& world, const Hit& hit, const Material& material,
                       float roughness, glm::vec3 normal, const Ray& ray) {
  if (!material.anisotropy.used()) return {};
  const TextureUse& use = material.anisotropy.texture;
  const SurfaceAnisotropy at =
      use.used() ? anisotropy_of(material.anisotropy,
                                 glm::vec3(sample_texture(world, use, hit.triangle, hit.b1, hit.b2,
                                                          Encoding::linear)))
                 : anisotropy_of(material.anisotropy);
  const glm::vec3 towards = glm::dot(normal, ray.direction) > 0.0f ? -normal : normal;
  return lobe_stretch(world, hit, at, roughness, towards, -ray.direction);
}

// Returns the error of the centre due to a light's highlight. A GGX lobe of width alpha is peak /
// (1 + (x / alpha)^2)^2 at x from its centre, where its second derivative is 4 / alpha^2 of its
// peak. Farther out its length scale is the distance from the centre.
float highlight_error(const Light& light, const Lobe& lobe, const Bend& bend, glm::vec3 position,
                      glm::vec3 to_viewer, float stretch_turn2 = 0.0f) {
  glm::vec3 to_light = -glm::vec3(light.direction);
  float distance = std::numeric_limits<float>::infinity();
  float irradiance = light.intensity * std::max({light.color.x, light.color.y, light.color.z});
  if (!traits_of(light_shape(light)).infinite) {
    const glm::vec3 d = glm::vec3(light.position) - position;
    distance = glm::length(d);
    irradiance /= distance * distance;
    to_light = d / distance;
  }
  const float alpha = lobe.alpha();
  // The peak, where the normal is the half vector. Light from behind is at a grazing angle there
  // and is reflected almost completely (Schlick's Fresnel term, Smith's shadowing).
  const glm::vec3 half = glm::normalize(to_light + to_viewer);
  const float along = std::clamp(glm::dot(half, to_viewer), 0.0f, 1.0f);
  const float fresnel = schlick(largest(lobe.f0), 1.0f, schlick_weight(along));
  const float a2 = alpha * lobe.alpha_along();
  const float peak = irradiance * fresnel * ggx_over(a2, a2, 2.0f * smith_root(along, a2));
  // The distance of the patch's nearest normal from the half vector, and the lobe there.
  const float away = lobe.away_from_peak(bend.normal, half);
  float turn2 = bend.turn2_about_half(to_viewer, to_light, distance);
  if (stretch_turn2 > 0.0f && !lobe.stretch.none()) {
    // A rotating ridge sweeps over the directions along it.
    const float aside = glm::dot(half, glm::normalize(lobe.stretch.along));
    turn2 += aside * aside * stretch_turn2;
  }
  const float nearest = std::max(0.0f, away - 0.5f * std::sqrt(turn2));
  const float width2 = alpha * alpha + nearest * nearest;
  const float fall = alpha * alpha / width2;
  return std::min(peak * fall * fall, 1.0f) * std::min(1.0f, turn2 / (6.0f * width2));
}

// Returns the patch's squared size over the squared distance of the nearest light with a position.
float nearness2(std::span<const Light> lights, glm::vec3 position, const Patch& patch) {
  const float size2 = glm::dot(patch.right, patch.right) + glm::dot(patch.down, patch.down);
  float nearest = 0.0f;
  for (const Light& light : lights) {
    if (traits_of(light_shape(light)).infinite) continue;
    const glm::vec3 d = glm::vec3(light.position) - position;
    nearest = std::max(nearest, size2 / glm::dot(d, d));
  }
  return nearest;
}

}  // namespace

float midpoint_error(const World& world, std::span<const Light> lights, const Ray& ray,
                     const Hit& hit, const Patch& patch, float viewer_distance, LightRule rule) {
  const Material& material = world.material_of(hit.triangle);
  const glm::vec3 size = glm::abs(patch.right) + glm::abs(patch.down);
  if (material.unlit || !std::isfinite(size.x + size.y + size.z)) return 0.0f;
  const glm::vec3 c =
      diffuse_share(material) * glm::vec3(material.base_color) + material.sheen.color;
  const float reflected = std::clamp(std::max({c.x, c.y, c.z}), 0.0f, 1.0f);
  const Bend bend = bend_of(world, hit, patch, -ray.direction, viewer_distance);
  const glm::vec3 position = ray.at(hit.t);
  const float turn2 = Bend::turn2(bend.spread);
  // The centre of a curved patch has an error of turn^2 / 24, or of up to turn / 8 where part of
  // the patch is beyond grazing. turn^2 / 3 is in between.
  float error = reflected * (turn2 / 3.0f + nearness2(lights, position, patch) / 4.0f);
  Lobe base = lobe_at(world, hit, material);
  base.stretch = stretch_of(world, hit, material, base.roughness, bend.normal, ray);
  const glm::vec2 turn =
      base.stretch.none() ? glm::vec2(0.0f) : tangent_turn(world, hit, patch, bend.normal);
  for (const Lobe& lobe : GlossyLobes(base, material.coat.factor, material.coat.roughness)) {
    if (lobe.is_broad()) continue;
    for (const Light& light : lights) {
      if (rule == LightRule::published || !traits_of(light_shape(light)).extended)
        error += highlight_error(light, lobe, bend, position, -ray.direction, glm::dot(turn, turn));
    }
  }
  return error < 1.0f ? error : 1.0f;
}

float glint_error(std::span<const Light> lights, const Lobe& lobe, const SurfacePoint& point,
                  glm::vec3 to_viewer) {
  const float variance = point.spread.variance;
  if (lobe.is_broad() || !(variance > 0.0f)) return 0.0f;
  const Bend bend{point.shading_normal, {{}, {}, variance}, {}};
  float error = 0.0f;
  for (const Light& light : lights)
    error += highlight_error(light, lobe, bend, point.position, to_viewer);
  return error < 1.0f ? error : 1.0f;
}

float falloff_error(const PreparedLight& light, const Receiver& receiver, const Patch& patch) {
  if (light.traits().infinite) return 0.0f;
  // Beyond this distance, in patch sizes, the second-order change of a light's irradiance is below
  // a thousandth.
  constexpr double near = 16.0;
  const double reach = glm::length(light.half_u) + glm::length(light.half_v) + light.radius;
  const double size = static_cast<double>(glm::length(patch.right) + glm::length(patch.down));
  if (glm::distance(light.position, receiver.position) - reach > near * size) return 0.0f;
  const auto shown = [&](glm::dvec3 offset) {
    Receiver beside = receiver;
    beside.position += offset;
    const glm::vec3 e = unshadowed_irradiance(light, beside);
    return std::min(1.0f, std::max({e.x, e.y, e.z}) * std::numbers::inv_pi_v<float>);
  };
  // Compare Simpson's rule with the midpoint rule.
  const float middle = shown(glm::dvec3(0.0));
  float error = 0.0f;
  for (const glm::vec3& edge : {patch.right, patch.down}) {
    const glm::dvec3 half = 0.5 * glm::dvec3(edge);
    error += std::abs(shown(half) + shown(-half) - 2.0f * middle) / 6.0f;
  }
  return error;
}

float cone_error(const PreparedLight& light, const Receiver& receiver, const Patch& patch) {
  if (light.cone_scale <= 0.0) return 0.0f;
  const glm::dvec3 to_light = light.position - receiver.position;
  const double distance = glm::length(to_light);
  if (!(distance > 0.0)) return 0.0f;
  const double cosine = glm::dot(to_light, light.towards) / distance;
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  // Largest angle of the patch's corners from its centre, seen from the light.
  const double angle =
      static_cast<double>(glm::length(patch.right) + glm::length(patch.down)) / (2.0 * distance);
  const double reach = angle * (sine + 0.5 * angle);
  const auto inside = [&](double c) {
    const double cone = std::clamp(c * light.cone_scale + light.cone_offset, 0.0, 1.0);
    return cone * cone;
  };
  const double least = inside(cosine - reach), most = inside(cosine + reach);
  if (least == most) return 0.0f;
  // Compare Simpson's rule with the midpoint rule, unless the rim is narrower than the patch.
  const bool whole_rim = least == 0.0 && most == 1.0;
  const double bend = whole_rim ? 1.0 : std::abs(least - 2.0 * inside(cosine) + most);
  const glm::vec3 power = light.power;
  const double squared =
      light.traits().has_area() ? std::numbers::pi * light.radius * light.radius : 1.0;
  const double shown = static_cast<double>(std::max({power.x, power.y, power.z})) * squared *
                       std::max(0.0, glm::dot(receiver.normal, to_light) / distance) /
                       (distance * distance) * std::numbers::inv_pi;
  return static_cast<float>(std::min(1.0, shown) * bend / 6.0);
}

}  // namespace asos
