#include "renderer/shading/texture_products.h"

#include "renderer/geometry/largest.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/environment.h"
#include "renderer/shading/ggx.h"
#include "renderer/shading/gloss.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shading/material_mean.h"
#include "renderer/shading/viewed_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace asos {
namespace {

constexpr std::size_t few_places = 8, all_places = 16;  // places in a footprint
/// Brightness of the surroundings, as a fraction of white.
constexpr float surroundings = 0.5f;

/// The radiance of a surface in uniform light as bright as white, by the side that the light comes
/// from.
struct Shown {
  glm::vec3 front{0.0f}, behind{0.0f};

  void add_layer(glm::vec3 radiance, float left) {
    front = radiance + left * front;
    behind *= left;
  }
  /// Returns the largest difference while both sides are dark up to white.
  [[nodiscard]] float difference(const Shown& other) const {
    const glm::vec3 a = front - other.front, b = behind - other.behind, none(0.0f);
    return largest(
        glm::max(glm::max(a, none) + glm::max(b, none), glm::max(-a, none) + glm::max(-b, none)));
  }
};

/// Computes the radiance of coat, sheen and the layers below them.
Shown shown(const SurfaceMaterial& m, float n_dot_v, float roughest_mirror) {
  const auto mirrored = [&](float roughness) {
    return roughness <= roughest_mirror ? 1.0f : mirrored_visibility(roughness);
  };
  const float open = 0.5f + 0.5f * m.occlusion;
  const float matte = 1.0f - m.metallic, scattered = (1.0f - m.transmission) * open;
  const glm::vec3 f0 = m.film.factor > 0.0f ? viewed(m, n_dot_v).specular : m.f0;
  Shown sum;
  sum.front = matte * scattered * (1.0f - m.diffuse_transmission) * m.base_color +
              mirrored(m.roughness) * f0 + m.emission;
  sum.behind = matte * (scattered * m.diffuse_transmission * m.diffuse_transmission_color +
                        m.transmission * m.base_color);
  if (m.sheen.color != glm::vec3(0.0f)) {
    const glm::vec3 sheen = viewed(m.sheen, n_dot_v).ambient;
    sum.add_layer(sheen, 1.0f - largest(sheen));
  }
  if (m.coat.factor > 0.0f) {
    const glm::vec3 coat = viewed(m.coat, n_dot_v).lobe.f0;
    sum.add_layer(mirrored(m.coat.roughness) * coat, 1.0f - coat.x);
  }
  return {m.opacity * sum.front, m.opacity * sum.behind};
}

/// Returns the mean of what several materials show.
Shown mean_shown(std::span<const SurfaceMaterial> materials, float n_dot_v, float roughest_mirror) {
  Shown mean;
  const float each = 1.0f / static_cast<float>(materials.size());
  for (const SurfaceMaterial& m : materials) {
    const Shown one = shown(m, n_dot_v, roughest_mirror);
    mean.front += each * one.front;
    mean.behind += each * one.behind;
  }
  return mean;
}

/// How reflections of a lobe are computed: as a mirror, by directions of its lobe, or from a
/// constant sky.
int reflection_kind(float roughness, float roughest_mirror) {
  if (roughness > roughest_mirror) return 2;
  return roughness >= least_lobe_roughness ? 1 : 0;
}

/// Values at the sampled places.
class Looks {
 public:
  void add(const SurfaceMaterial& m) {
    const std::array<glm::vec3, groups> values{
        m.base_color,
        m.emission,
        glm::vec3(m.metallic),
        glm::vec3(m.occlusion),
        glm::vec3(m.opacity),
        {m.dielectric_f0, m.f90, 0.0f},
        glm::vec3(m.coat.factor),
        m.sheen.color,
        glm::vec3(m.transmission),
        glm::vec3(m.diffuse_transmission),
        m.diffuse_transmission_color,
        glm::vec3(m.film.factor),
        {m.roughness, m.coat.roughness, m.sheen.roughness},
        glm::vec3(m.film.thickness_nm / most_thickness_nm),
    };
    for (std::size_t i = 0; i < groups; ++i) {
      lo_[i] = glm::min(lo_[i], values[i]);
      hi_[i] = glm::max(hi_[i], values[i]);
    }
    most_metal_ = std::max(most_metal_, m.metallic * largest(m.base_color));
    most_coat_ = std::max(most_coat_, m.coat.factor);
    most_sheen_ = std::max(most_sheen_, largest(m.sheen.color));
    most_film_ = std::max(most_film_, m.film.factor);
  }

  /// Returns whether two factors vary that are multiplied, or the roughness or colour of a strongly
  /// reflecting layer.
  [[nodiscard]] bool differ() const {
    constexpr float much = 0.1f;
    int differing = 0;
    for (std::size_t i = 0; i < factors; ++i) differing += differs(i) ? 1 : 0;
    const glm::vec3 apart = hi_[factors] - lo_[factors];
    return differing >= 2 || (apart.x > even && most_metal_ > much) ||
           (apart.y > even && most_coat_ > much) || (apart.z > even && most_sheen_ > much) ||
           (differs(factors + 1) && most_film_ > much);
  }
  /// Returns whether the roughness of a lobe with a highlight varies.
  [[nodiscard]] bool differ_in_gloss() const {
    const glm::vec3 apart = hi_[factors] - lo_[factors], lo = lo_[factors];
    return (apart.x > even && lo.x < least_broad_roughness) ||
           (apart.y > even && lo.y < least_broad_roughness && most_coat_ > 0.0f);
  }

 private:
  static constexpr std::size_t factors = 12, groups = factors + 2;
  static constexpr float even = 1.0f / 64.0f;
  static constexpr float most_thickness_nm = 1000.0f;
  using Values = std::array<glm::vec3, groups>;
  static constexpr Values filled(float value) {
    Values values{};
    values.fill(glm::vec3(value));
    return values;
  }
  [[nodiscard]] bool differs(std::size_t i) const { return largest(hi_[i] - lo_[i]) > even; }

  static constexpr float infinity = std::numeric_limits<float>::infinity();
  Values lo_ = filled(infinity), hi_ = filled(-infinity);
  float most_metal_ = 0.0f, most_coat_ = 0.0f, most_sheen_ = 0.0f, most_film_ = 0.0f;
};

/// Returns the k-th of 16 places in a footprint: one in each sixteenth of both edges, jittered so
/// that no stripes are missed. The first eight places have one in each eighth.
glm::vec2 place(std::size_t k) {
  constexpr std::array<int, 16> sixteenth{0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};
  constexpr glm::vec2 step(0.618034f, 0.7548777f);
  const std::size_t column = k < 8 ? 2 * k : 2 * (k - 8) + 1;
  const glm::vec2 stratum(column, sixteenth[k]);
  return (stratum + glm::fract(static_cast<float>(k) * step)) / 16.0f - 0.5f;
}

/// Returns the fraction of white that places reflect in another way than their mean does. The mean
/// loses these reflections or their surroundings.
float reflected_otherwise(std::span<const SurfaceMaterial> materials, const SurfaceMaterial& mean,
                          float roughest_mirror) {
  const auto kind = [&](float roughness) { return reflection_kind(roughness, roughest_mirror); };
  float sum = 0.0f;
  for (const SurfaceMaterial& m : materials) {
    if (kind(m.roughness) != kind(mean.roughness)) sum += m.opacity * largest(m.f0);
    if (m.coat.factor > 0.0f && kind(m.coat.roughness) != kind(mean.coat.roughness))
      sum += m.opacity * coat_f0 * m.coat.factor;
  }
  return sum / static_cast<float>(materials.size());
}

/// Returns the radiance of a light's highlights at a point, without shadows.
float highlight(const SurfaceMaterial& m, const BrdfAngles& angles, float half_angle,
                float irradiance) {
  const float weight = schlick_weight(angles.v_dot_h);
  const auto lobe = [&](float f0, float roughness) {
    const float alpha = alpha_of(roughness);
    const float wider = std::sqrt(std::hypot(alpha, 0.5f * half_angle));
    return schlick(f0, 1.0f, weight) * ggx_lobe(std::min(wider, 1.0f), angles);
  };
  float sum = lobe(largest(m.f0), m.roughness);
  if (m.coat.factor > 0.0f) sum += m.coat.factor * lobe(coat_f0, m.coat.roughness);
  return m.opacity * irradiance * sum;
}

/// Returns the error of the highlights of a light.
float highlight_error(const PreparedLight& light, const SurfacePoint& point, glm::vec3 to_viewer,
                      std::span<const SurfaceMaterial> materials, const SurfaceMaterial& mean) {
  const glm::vec3 n = point.shading_normal;
  const float irradiance = largest(unshadowed_irradiance(light, receiver_at(point)));
  if (!(irradiance > 0.0f)) return 0.0f;
  const Highlight nearest =
      highlight_of(light, glm::dvec3(point.position), glm::dvec3(glm::reflect(-to_viewer, n)));
  const glm::vec3 half = nearest.direction + to_viewer;
  const float length = glm::length(half);
  if (!(length > 0.0f)) return 0.0f;
  const auto cosine = [](glm::vec3 a, glm::vec3 b) { return std::max(glm::dot(a, b), 0.0f); };
  const BrdfAngles angles{cosine(n, nearest.direction),
                          std::max(cosine(n, to_viewer), grazing_cosine), cosine(n, half / length),
                          cosine(to_viewer, half / length)};
  const auto shines = [&](const SurfaceMaterial& m) {
    return highlight(m, angles, nearest.half_angle_tangent, irradiance);
  };
  float sum = 0.0f;
  for (const SurfaceMaterial& m : materials) sum += shines(m);
  sum /= static_cast<float>(materials.size());
  return std::abs(std::min(1.0f, sum) - std::min(1.0f, shines(mean)));
}

}  // namespace

bool multiplies_textures(const Material& material, const RenderFeatures& render_features) {
  if (!render_features.textures || material.unlit) return false;
  // A mean roughness or thickness is not that of the mean reflection.
  if (material.metallic_roughness_texture.used() || material.coat.roughness_texture.used() ||
      material.sheen.roughness_texture.used() || material.film.thickness_texture.used())
    return true;
  int factors = 0;
  for (const TextureUse* use :
       {&material.base_color_texture, &material.occlusion_texture, &material.specular_texture,
        &material.specular_color_texture, &material.coat.texture, &material.sheen.color_texture,
        &material.transmission_texture, &material.film.texture,
        &material.diffuse_transmission.texture, &material.diffuse_transmission.color_texture})
    factors += use->used() ? 1 : 0;
  const bool blends = material.alpha_mode == AlphaMode::blend;
  return factors >= 2 || (blends && material.base_color_texture.used() &&
                          render_features.emission && material.emissive_texture.used() &&
                          !material.emissive_texture.same_place(material.base_color_texture));
}

ProductError product_error(const World& world, const RenderFeatures& render_features,
                           const Hit& hit, const Footprint& footprint, const ViewedFrom& from) {
  if (footprint.point()) return {};
  const auto of_reflections = [&](std::span<const SurfaceMaterial> materials) {
    if (!from.reflections) return 0.0f;
    const SurfaceMaterial filtered =
        surface_material(world, render_features, hit, footprint, from.reflections);
    return surroundings * reflected_otherwise(materials, filtered, from.roughest_mirror);
  };
  Looks looks;
  MaterialMean textures(world, render_features, hit.triangle);
  std::array<SurfaceMaterial, all_places> materials;
  for (std::size_t k = 0; k < all_places; ++k) {
    const glm::vec2 at = place(k);
    const glm::vec2 by = footprint.offset + at.x * footprint.right + at.y * footprint.down;
    materials[k] = textures.add(hit.b1 + by.x, hit.b2 + by.y);
    looks.add(materials[k]);
    if (k + 1 == few_places && !looks.differ() && !looks.differ_in_gloss())
      return {0.0f, of_reflections(std::span(materials).first(few_places)), 0.0f};
  }
  const SurfaceMaterial mean = textures.mean();
  const SurfacePoint point = surface_point(world, render_features, hit, from.to_viewer);
  const float n_dot_v = viewed_point(point, from.to_viewer).n_dot_v;
  ProductError error{0.0f, of_reflections(materials), 0.0f};
  if (looks.differ()) {
    error.shading = surroundings * mean_shown(materials, n_dot_v, from.roughest_mirror)
                                       .difference(shown(mean, n_dot_v, from.roughest_mirror));
  }
  if (!looks.differ_in_gloss()) return error;
  for (const PreparedLight& light : from.lights) {
    if (error.sum() > from.enough) break;
    error.highlights += highlight_error(light, point, from.to_viewer, materials, mean);
  }
  return error;
}

}  // namespace asos
