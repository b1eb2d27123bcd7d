#include "renderer/shading/texture_products.h"

#include "renderer/geometry/largest.h"
#include "renderer/shading/environment.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace asos {
namespace {

/// Values of a surface's textures at a place that affect its look.
struct Look {
  glm::vec3 color{0.0f}, emission{0.0f};
  float opacity = 0.0f, metallic = 0.0f, roughness = 0.0f, occlusion = 0.0f;

  Look() = default;
  explicit Look(const SurfaceMaterial& m)
      : color(m.base_color),
        emission(m.emission),
        opacity(m.opacity),
        metallic(m.metallic),
        roughness(m.roughness),
        occlusion(m.occlusion) {}
};

/// Returns the radiance in uniform light as bright as white.
glm::vec3 shown(const Look& at, const SurfaceMaterial& material, float roughest_mirror) {
  const float open = 0.5f + 0.5f * at.occlusion;
  const float mirrored = at.roughness <= roughest_mirror ? 1.0f : mirrored_visibility(at.roughness);
  const float matte = (1.0f - at.metallic) * (1.0f - material.transmission);
  const glm::vec3 f0 = glm::mix(glm::vec3(material.dielectric_f0), at.color, at.metallic);
  return at.opacity * (open * matte * at.color + mirrored * f0 + at.emission);
}

/// Values at the sampled places.
class Looks {
 public:
  explicit Looks(const Material& material)
      : shines_as_it_covers_(emissive_kind(material) == TexelKind::cover) {}

  void add(const Look& look) {
    const Values values{look.color.x,    look.color.y,    look.color.z,  look.emission.x,
                        look.emission.y, look.emission.z, look.metallic, look.occlusion,
                        look.opacity,    look.roughness};
    for (std::size_t i = 0; i < values.size(); ++i) {
      lo_[i] = std::min(lo_[i], values[i]);
      hi_[i] = std::max(hi_[i], values[i]);
    }
    most_metal_ = std::max(most_metal_, look.metallic * largest(look.color));
    ++count_;
    sum_.color += look.opacity * look.color;
    sum_.emission += (shines_as_it_covers_ ? look.opacity : 1.0f) * look.emission;
    sum_.opacity += look.opacity;
    sum_.metallic += look.metallic;
    sum_.roughness += look.roughness;
    sum_.occlusion += look.occlusion;
  }

  /// Returns whether two factors vary that are multiplied, or the roughness of a strongly
  /// reflecting surface.
  [[nodiscard]] bool differ() const {
    constexpr float much = 0.1f;
    const bool colour = differs(0) || differs(1) || differs(2);
    const bool emission = differs(3) || differs(4) || differs(5);
    const int differing =
        int(colour) + int(emission) + int(differs(6)) + int(differs(7)) + int(differs(8));
    return differing >= 2 || (differs(9) && most_metal_ > much);
  }

  /// Returns the means; colours are weighted by coverage, as in footprints.
  [[nodiscard]] Look mean() const {
    Look mean;
    const float there = std::max(sum_.opacity, std::numeric_limits<float>::min());
    mean.color = sum_.color / there;
    mean.emission = sum_.emission / (shines_as_it_covers_ ? there : count_);
    mean.opacity = sum_.opacity / count_;
    mean.metallic = sum_.metallic / count_;
    mean.roughness = sum_.roughness / count_;
    mean.occlusion = sum_.occlusion / count_;
    return mean;
  }

 private:
  using Values = std::array<float, 10>;
  static constexpr Values filled(float value) {
    Values values{};
    values.fill(value);
    return values;
  }
  [[nodiscard]] bool differs(std::size_t i) const {
    constexpr float even = 1.0f / 64.0f;
    return hi_[i] - lo_[i] > even;
  }

  static constexpr float infinity = std::numeric_limits<float>::infinity();
  Values lo_ = filled(infinity), hi_ = filled(-infinity);
  bool shines_as_it_covers_;
  float most_metal_ = 0.0f, count_ = 0.0f;
  Look sum_;
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

}  // namespace

bool multiplies_textures(const Material& material, const RenderFeatures& render_features) {
  if (!render_features.textures || material.unlit) return false;
  if (material.metallic_roughness_texture.used()) return true;
  const bool blends = material.alpha_mode == AlphaMode::blend;
  return material.base_color_texture.used() &&
         (material.occlusion_texture.used() ||
          (blends && render_features.emission && material.emissive_texture.used() &&
           !material.emissive_texture.same_place(material.base_color_texture)));
}

float product_error(const World& world, const RenderFeatures& render_features, const Hit& hit,
                    const Footprint& footprint, float roughest_mirror) {
  constexpr std::size_t few = 8, all = 16;
  constexpr float brightness = 0.5f;
  if (footprint.point()) return 0.0f;
  Looks looks(world.material_of(hit.triangle));
  SurfaceMaterial material;
  glm::vec3 sum(0.0f);
  for (std::size_t k = 0; k < all; ++k) {
    const glm::vec2 at = place(k);
    const glm::vec2 by = footprint.offset + at.x * footprint.right + at.y * footprint.down;
    Hit there = hit;
    there.b1 += by.x;
    there.b2 += by.y;
    material = surface_material(world, render_features, there);
    const Look look(material);
    looks.add(look);
    sum += shown(look, material, roughest_mirror);
    if (k + 1 == few && !looks.differ()) return 0.0f;
  }
  const glm::vec3 of_means = shown(looks.mean(), material, roughest_mirror);
  return brightness * largest(glm::abs(sum / static_cast<float>(all) - of_means));
}

}  // namespace asos
