#include "renderer/shading/sky_light.h"

#include "renderer/geometry/direction.h"
#include "renderer/geometry/largest.h"
#include "renderer/shading/environment.h"
#include "renderer/shading/ggx.h"
#include "renderer/shading/lobe_directions.h"
#include "renderer/shading/lobe_norms.h"
#include "renderer/shading/patch_lobe.h"
#include "renderer/shading/sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

glm::vec3 by_cosine(glm::vec2 place) {
  const float r = std::sqrt(place.x);
  const float angle = 2.0f * std::numbers::pi_v<float> * place.y;
  return {r * std::cos(angle), r * std::sin(angle), std::sqrt(std::max(0.0f, 1.0f - place.x))};
}

/// Returns the mean of Schlick's weight over all directions to the light, weighted by their cosine,
/// for this n.v. Interpolates a table in steps of 1/64, within 1e-4.
float mean_schlick(float n_dot_v) {
  constexpr int steps = 64;
  static const std::array<float, steps + 1> table = [] {
    std::array<float, steps + 1> means{};
    for (int k = 0; k <= steps; ++k) {
      const float z = static_cast<float>(k) / steps;
      const glm::vec3 viewer(std::sqrt(1.0f - z * z), 0.0f, z);
      double sum = 0.0;
      for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j)
          sum += static_cast<double>(
              schlick_weight(viewer, by_cosine({(static_cast<float>(i) + 0.5f) / steps,
                                                (static_cast<float>(j) + 0.5f) / steps})));
      means[static_cast<std::size_t>(k)] = static_cast<float>(sum / (steps * steps));
    }
    return means;
  }();
  const float at = std::clamp(n_dot_v, 0.0f, 1.0f) * steps;
  const auto below = static_cast<std::size_t>(std::min(at, steps - 1.0f));
  return glm::mix(table[below], table[below + 1], at - static_cast<float>(below));
}

/// Returns D * V of a stretched lobe, for directions in its own frame.
float stretched_lobe(glm::vec2 alpha, glm::vec3 half, glm::vec3 to_light, glm::vec3 to_viewer) {
  Lobe lobe;
  lobe.roughness = std::sqrt(alpha.y);
  lobe.stretch.along.x = std::sqrt(alpha.x * alpha.x - alpha.y * alpha.y);
  return PatchLobe({}, lobe, {0.0f, 0.0f, 1.0f})
      .value(half, to_light, to_viewer, {to_light.z, to_viewer.z, half.z, 0.0f});
}

/// Returns the density of reflections at visible normals (`visible_normal`), per steradian.
float lobe_density(glm::vec3 v, glm::vec3 half, glm::vec2 alpha) {
  const GgxSlopes<float> slopes{alpha.x * alpha.x, 0.0f, alpha.y * alpha.y};
  const float det = slopes.determinant();
  return ggx_over(GgxSlopes<float>::alpha2(det), slopes.stretched(half.x, half.y, half.z, det),
                  v.z + glm::length(glm::vec3(alpha, 1.0f) * v));
}

/// Returns the irradiance of an open sky over pi.
glm::vec3 open_radiance(const SkyQuery& point) {
  return point.sky ? point.sky->ambient(point.view.point.shading_normal) / sky_visibility
                   : background_radiance;
}

constexpr glm::vec3 nothing(0.0f);

}  // namespace

SkySampler::SkySampler(const SkyQuery& point)
    : sky_(point.sky),
      material_(point.material),
      factor_(point.share),
      alpha_(material_.lobe.alpha_along(), material_.lobe.alpha()),
      picture_(point.sky && point.sky->is_picture()),
      sheen_(material_.lobe.is_sheen()) {
  const Tangents tangents(point.view.point.shading_normal, material_.lobe.stretch);
  right_ = tangents.right;
  up_ = tangents.up;
  normal_ = tangents.normal;
  viewer_ = viewer_above(local(point.view.to_viewer));
  const SurfacePoint& surface = point.view.point;
  const glm::vec3 horizon = surface.horizon();
  if (horizon != surface.shading_normal && horizon != glm::vec3(0.0f)) horizon_ = local(horizon);
  // Fractions of the samples by the cosine, by the lobe and by the picture.
  const float by_diffuse = largest(sheen_ ? material_.ambient : material_.diffuse);
  const float by_lobe = point.mirrors ? 0.0f : largest(material_.specular);
  const float by_picture = picture_ ? by_diffuse + by_lobe : 0.0f;
  const float sum = by_diffuse + by_lobe + by_picture;
  reflects_ = sum > 0.0f;
  if (reflects_) share_ = {by_diffuse / sum, by_lobe / sum, by_picture / sum};
}

// Chooses one of the strategies and samples a direction, in the surface's frame. Returns none if
// the direction contributes nothing.
std::optional<glm::vec3> SkySampler::direction_of(glm::dvec2 place) const {
  auto first = static_cast<float>(place.x);
  const auto second = static_cast<float>(place.y);
  glm::vec3 found;
  if (first < share_[0]) {
    found = by_cosine({first / share_[0], second});
  } else if (!picture_ || first < share_[0] + share_[1]) {
    first = std::min((first - share_[0]) / share_[1], 1.0f - 0x1p-24f);
    found = glm::reflect(-viewer_, visible_normal(viewer_, alpha_, {first, second}));
  } else {
    const double rest =
        (place.x - static_cast<double>(share_[0] + share_[1])) / static_cast<double>(share_[2]);
    const SkyDirection bright = sky_->bright_direction({std::clamp(rest, 0.0, 1.0), place.y});
    found = local(glm::vec3(bright.direction));
    // The part of the sky below the surface does not illuminate it.
    if (!(glm::dot(found, horizon_) > 0.0f)) return std::nullopt;
  }
  return found.z > 0.0f ? std::optional(found) : std::nullopt;
}

SkySampler::Reflected SkySampler::reflected_from(glm::vec3 direction) const {
  Reflected found;
  found.density = share_[0] * direction.z * std::numbers::inv_pi_v<float>;
  found.brdf = diffuse_brdf(material_,
                            material_.falloff == 0.0f ? 0.0f : schlick_weight(viewer_, direction));
  if (share_[1] > 0.0f || sheen_) {
    const glm::vec3 half = glm::normalize(direction + viewer_);
    const BrdfAngles angles{direction.z, viewer_.z, half.z, glm::dot(viewer_, half)};
    if (!sheen_) found.density += share_[1] * lobe_density(viewer_, half, alpha_);
    const Lobe& lobe = material_.lobe;
    const float value = lobe.stretch.none() ? round_lobe(lobe, angles)
                                            : stretched_lobe(alpha_, half, direction, viewer_);
    found.brdf += specular_brdf(lobe, angles, value);
  }
  return found;
}

// Adds the contribution from a direction in the shading normal's hemisphere. A picture's radiance
// is that of the ray's own direction, so that its sun does not shine through the surface.
void SkySampler::add(glm::vec3 direction, glm::vec3 brdf, float density, SkySample& sample) const {
  const glm::vec3 own = world(direction);
  const glm::vec3 radiance = sky_ ? sky_->radiance(own) : background_radiance;
  const bool moved = picture_ && own != sample.direction;
  const glm::vec3 weight = factor_ * brdf * (direction.z / density);
  sample.weight += weight;
  sample.carried += weight * (moved ? sky_->radiance(sample.direction) : radiance);
  const float even = std::numbers::inv_pi_v<float> * direction.z / density;
  sample.matte += factor_ * material_.diffuse * even * radiance;
}

std::optional<SkySample> SkySampler::at(glm::dvec2 place) const {
  if (!reflects_) return std::nullopt;
  const std::optional<glm::vec3> direction = direction_of(place);
  if (!direction) return std::nullopt;
  SkySample sample;
  sample.direction = world(above_plane(*direction, horizon_));

  // Divide by the density of all strategies, including that of the direction mirrored at the
  // surface's plane.
  const glm::vec3 other_side = glm::reflect(*direction, horizon_);
  const bool folded = other_side.z > 0.0f;
  const Reflected own = reflected_from(*direction);
  const Reflected other = folded ? reflected_from(other_side) : Reflected{};
  float density = own.density + other.density;
  if (picture_) density += share_[2] * static_cast<float>(sky_->bright_density(sample.direction));
  add(*direction, own.brdf, density, sample);
  if (folded) add(other_side, other.brdf, density, sample);
  return sample;
}

std::optional<SkySample> sample_sky(const SkyQuery& point, glm::dvec2 place) {
  return SkySampler(point).at(place);
}

Ray sky_ray(const SurfacePoint& point, const SkySample& sample) {
  Ray ray;
  ray.direction = sample.direction;
  ray.origin = spawn_origin(point, ray.direction);
  return ray;
}

glm::vec3 open_sky_of_matte(const SkyQuery& point) {
  return point.share * open_radiance(point) * point.material.diffuse;
}

glm::vec3 open_sky_less(const SkyQuery& point, const std::optional<SkySample>& sample) {
  if (const auto whole = unoccluded_sky(point))
    return *whole - (sample ? sample->carried : nothing);
  return open_sky_of_matte(point) - (sample ? sample->matte : nothing);
}

std::optional<glm::vec3> unoccluded_sky(const SkyQuery& point) {
  const ViewedMaterial& material = point.material;
  const bool shiny = !point.mirrors && material.specular != glm::vec3(0.0f);
  const bool sheen = material.lobe.is_sheen();
  const bool even = !shiny && !sheen && material.falloff == 0.0f;
  if (point.sky && (point.sky->is_picture() || !(even || point.sky->constant())))
    return std::nullopt;
  glm::vec3 reflected =
      material.diffuse * (1.0f - material.falloff * mean_schlick(point.view.n_dot_v));
  if (sheen) reflected = material.ambient;
  if (shiny) {
    Lobe lobe = material.lobe;
    lobe.roughness = std::clamp(lobe.roughness, roughness_floor, 1.0f);
    const LobeNorms norms = lobe_norms(lobe, point.view.n_dot_v);
    reflected += lobe.f0 * norms.lobe + (lobe.f90 - lobe.f0) * norms.fresnel;
  }
  return point.share * open_radiance(point) * reflected;
}

}  // namespace asos
