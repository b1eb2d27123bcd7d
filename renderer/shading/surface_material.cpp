#include "renderer/shading/anisotropy.h"
#include "renderer/shading/material_mean.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/texture.h"
#include "renderer/shading/texture_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

// The material at a point of a surface. The point's geometry is in surface.cpp.

namespace asos {
namespace {

/// The textures of a material at a point; `sample(use, kind)` looks up one.
template <typename Sample>
struct TextureValues {
  const RenderFeatures& render_features;
  const Sample& sample;

  /// Returns white for a texture that is not used.
  [[nodiscard]] glm::vec4 at(const TextureUse& use, TexelKind kind = TexelKind::data) const {
    return render_features.textures && use.used() ? sample(use, kind) : glm::vec4(1.0f);
  }
  [[nodiscard]] glm::vec3 color(const TextureUse& use) const {
    return glm::vec3(at(use, TexelKind::color));
  }
};

// The functions of the layers look up their textures in an order that every caller repeats.

template <typename Sample>
void set_cover(const Material& material, glm::vec4 base, const TextureValues<Sample>& texels,
               SurfaceMaterial& surface) {
  surface.base_color = glm::vec3(base);
  surface.transmission = std::clamp(material.transmission, 0.0f, 1.0f);
  if (surface.transmission > 0.0f)
    surface.transmission *= texels.at(material.transmission_texture).r;
  if (material.alpha_mode == AlphaMode::blend) {
    surface.opacity = std::clamp(base.a, 0.0f, 1.0f);
  } else if (material.alpha_mode == AlphaMode::mask && material.transmission > 0.0f) {
    // Without transmission, RayScene has applied the cut-off already.
    surface.opacity = base.a >= material.alpha_cutoff ? 1.0f : 0.0f;
  }
}

template <typename Sample>
void set_metal(const Material& material, const TextureValues<Sample>& texels,
               SurfaceMaterial& surface) {
  const glm::vec4 texel = texels.at(material.metallic_roughness_texture);
  surface.roughness = material.roughness * texel.g;
  surface.metallic = material.metallic * texel.b;
  const float seen = texels.at(material.occlusion_texture).r;
  surface.occlusion = 1.0f + material.occlusion_texture.scale * (seen - 1.0f);
}

/// KHR_materials_specular. An index of 0 means an infinite one: everything is reflected.
template <typename Sample>
void set_reflectance(const Material& material, const TextureValues<Sample>& texels,
                     SurfaceMaterial& surface) {
  const float dielectric = (material.ior - 1.0f) / (material.ior + 1.0f);
  const glm::vec3 color = material.specular_color * texels.color(material.specular_color_texture);
  const float specular = material.specular * texels.at(material.specular_texture).a;
  surface.f0 = glm::min(dielectric * dielectric * color, glm::vec3(1.0f)) * specular;
  surface.f90 = specular;
  surface.dielectric_f0 = std::max({surface.f0.x, surface.f0.y, surface.f0.z});
  surface.dielectric_f90 = surface.f90;
  if (texels.render_features.metals) {
    surface.f0 = glm::mix(surface.f0, surface.base_color, surface.metallic);
    surface.f90 = glm::mix(surface.f90, 1.0f, surface.metallic);
  }
}

template <typename Sample>
SurfaceCoat coat_of(const Clearcoat& coat, const TextureValues<Sample>& texels) {
  if (!(coat.factor > 0.0f)) return {};
  SurfaceCoat at{coat.factor, coat.roughness};
  at.factor *= texels.at(coat.texture).r;
  at.roughness *= texels.at(coat.roughness_texture).g;
  return at;
}

template <typename Sample>
SurfaceSheen sheen_of(const Sheen& sheen, const TextureValues<Sample>& texels) {
  if (!sheen.used()) return {};
  SurfaceSheen at{sheen.color, sheen.roughness};
  at.color *= texels.color(sheen.color_texture);
  at.roughness *= texels.at(sheen.roughness_texture).a;
  return at;
}

template <typename Sample>
SurfaceThinFilm film_of(const Iridescence& film, const TextureValues<Sample>& texels) {
  if (!film.used()) return {};
  SurfaceThinFilm at{film.factor, film.ior, film.thickness_max_nm};
  at.factor *= texels.at(film.texture).r;
  const float thickness = texels.at(film.thickness_texture).g;
  at.thickness_nm = glm::mix(film.thickness_min_nm, film.thickness_max_nm, thickness);
  return at;
}

template <typename Sample>
SurfaceAnisotropy anisotropy_at(const Anisotropy& anisotropy, const TextureValues<Sample>& texels) {
  if (!anisotropy.used()) return {};
  const bool textured = texels.render_features.textures && anisotropy.texture.used();
  return textured ? anisotropy_of(anisotropy, glm::vec3(texels.at(anisotropy.texture)))
                  : anisotropy_of(anisotropy);
}

template <typename Sample>
void set_diffuse_transmission(const DiffuseTransmission& through,
                              const TextureValues<Sample>& texels, SurfaceMaterial& surface) {
  if (!through.used()) return;
  surface.diffuse_transmission = through.factor * texels.at(through.texture).a;
  surface.diffuse_transmission_color = through.color * texels.color(through.color_texture);
}

template <typename Sample>
glm::vec3 emission_of(const Material& material, const TextureValues<Sample>& texels) {
  if (!texels.render_features.emission) return glm::vec3(0.0f);
  glm::vec3 emitted = material.emissive * material.emissive_strength;
  if (material.emissive_texture.used() && emitted != glm::vec3(0.0f))
    emitted *= glm::vec3(texels.sample(material.emissive_texture, emissive_kind(material)));
  return emitted;
}

/// Makes a material from its base colour; `sample(use, kind)` looks up the other textures.
template <typename Sample>
SurfaceMaterial material_with(const Material& material, const RenderFeatures& render_features,
                              glm::vec4 base, const Sample& sample) {
  const TextureValues<Sample> texels{render_features, sample};
  SurfaceMaterial surface;
  surface.unlit = material.unlit;
  set_cover(material, base, texels, surface);
  if (surface.unlit) {
    if (material.stroke) surface.base_color += emission_of(material, texels);
    return surface;
  }
  set_metal(material, texels, surface);
  set_reflectance(material, texels, surface);
  surface.coat = coat_of(material.coat, texels);
  surface.sheen = sheen_of(material.sheen, texels);
  surface.film = film_of(material.film, texels);
  surface.anisotropy = anisotropy_at(material.anisotropy, texels);
  set_diffuse_transmission(material.diffuse_transmission, texels, surface);
  surface.emission = emission_of(material, texels);
  return surface;
}

/// Returns the least alpha of the texture at which a mask is opaque.
std::optional<float> cutoff_of(const Material& material, glm::vec4 tint) {
  if (material.alpha_mode != AlphaMode::mask) return std::nullopt;
  return material.alpha_cutoff / (material.base_color.a * tint.a);
}

/// Makes the material at a hit with its vertex colour, if any; as `material_with`.
template <typename Sample>
SurfaceMaterial tinted_material(const World& world, const RenderFeatures& render_features,
                                const Hit& hit, const glm::vec4* tint, bool averaged,
                                const Sample& sample) {
  const Material& material = world.material_of(hit.triangle);
  glm::vec4 base = material.base_color;
  if (render_features.textures && material.base_color_texture.used()) {
    glm::vec4 texel = sample(material.base_color_texture, base_color_kind(material));
    // The cut-off is tested at a point, as rays do.
    if (averaged && material.alpha_mode == AlphaMode::mask && material.transmission > 0.0f) {
      texel.a = sample_texture(world, material.base_color_texture, hit.triangle, hit.b1, hit.b2,
                               Encoding::srgb)
                    .a;
    }
    base *= texel;
  }
  if (tint) base *= *tint;
  return material_with(material, render_features, base, sample);
}

}  // namespace

SurfaceMaterial surface_material(const World& world, const RenderFeatures& render_features,
                                 const Hit& hit, const Footprint& footprint,
                                 const MipChains* mips) {
  const Material& material = world.material_of(hit.triangle);
  const bool tinted = render_features.vertex_colors && !world.colors.empty();
  const glm::vec4 tint =
      tinted ? vertex_color(world, hit.triangle, hit.b1, hit.b2) : glm::vec4(1.0f);
  const std::optional<float> seen_from = cutoff_of(material, tint);
  const auto sample = [&](const TextureUse& use, TexelKind kind) {
    // The footprint of textures with alpha is not widened: otherwise, each layer would show the
    // holes of others.
    const Footprint shown = kind == TexelKind::color ? of_colours(footprint) : footprint;
    if (mips)
      return filtered_texture(world, *mips, use, {kind, seen_from},
                              {hit.triangle, hit.b1, hit.b2, shown});
    return sample_texture(world, use, hit.triangle, hit.b1, hit.b2,
                          kind == TexelKind::data ? Encoding::linear : Encoding::srgb);
  };

  return tinted_material(world, render_features, hit, tinted ? &tint : nullptr, mips != nullptr,
                         sample);
}

std::vector<TextureLookUp> texture_look_ups(const Material& material,
                                            const RenderFeatures& render_features) {
  std::vector<TextureLookUp> found;
  const auto note = [&](const TextureUse& use, TexelKind kind) {
    found.push_back({use, kind});
    return glm::vec4(1.0f);
  };
  if (render_features.textures && material.base_color_texture.used())
    note(material.base_color_texture, base_color_kind(material));
  (void)material_with(material, render_features, material.base_color, note);
  return found;
}

SurfaceMaterial surface_material(const World& world, const RenderFeatures& render_features,
                                 const Hit& hit, const LookedUpTexels& texels) {
  const bool tinted = render_features.vertex_colors && !world.colors.empty();
  const glm::vec4 tint =
      tinted ? vertex_color(world, hit.triangle, hit.b1, hit.b2) : glm::vec4(1.0f);
  const glm::vec4* next = texels.first;
  const auto sample = [&](const TextureUse&, TexelKind) {
    const glm::vec4 texel = *next;
    next += texels.stride;
    return texel;
  };
  return tinted_material(world, render_features, hit, tinted ? &tint : nullptr, texels.averaged,
                         sample);
}

std::optional<float> texel_cutoff(const World& world, const RenderFeatures& render_features,
                                  const Hit& hit) {
  const Material& material = world.material_of(hit.triangle);
  if (material.alpha_mode != AlphaMode::mask) return std::nullopt;
  const bool tinted = render_features.vertex_colors && !world.colors.empty();
  return cutoff_of(material,
                   tinted ? vertex_color(world, hit.triangle, hit.b1, hit.b2) : glm::vec4(1.0f));
}

MaterialMean::MaterialMean(const World& world, const RenderFeatures& render_features,
                           std::uint32_t triangle)
    : world_(&world),
      render_features_(&render_features),
      triangle_(triangle),
      material_(&world.material_of(triangle)) {}

// With alpha blending, colours are weighted by opacity.
SurfaceMaterial MaterialMean::add(float b1, float b2) {
  glm::vec4 base = material_->base_color;
  if (render_features_->textures && material_->base_color_texture.used())
    base *=
        sample_texture(*world_, material_->base_color_texture, triangle_, b1, b2, Encoding::srgb);
  if (render_features_->vertex_colors && !world_->colors.empty())
    base *= vertex_color(*world_, triangle_, b1, b2);
  const bool blends = material_->alpha_mode == AlphaMode::blend;
  const float there = blends ? std::clamp(base.a, 0.0f, 1.0f) : 1.0f;
  const auto add_to = [](Sum& sum, glm::vec4 value, float weight) {
    sum.value += glm::vec4(weight * glm::vec3(value), value.a);
    sum.weight += weight;
  };
  add_to(base_, base, there);
  std::size_t used = 0;
  const auto sample = [&](const TextureUse& use, TexelKind kind) {
    const glm::vec4 texel =
        sample_texture(*world_, use, triangle_, b1, b2,
                       kind == TexelKind::data ? Encoding::linear : Encoding::srgb);
    add_to(textures_[used++], texel, kind == TexelKind::cover ? there : 1.0f);
    return texel;
  };
  count_ += 1.0f;
  return material_with(*material_, *render_features_, base, sample);
}

SurfaceMaterial MaterialMean::mean() const {
  const auto mean_of = [this](const Sum& sum) {
    const float weight = std::max(sum.weight, std::numeric_limits<float>::min());
    return glm::vec4(glm::vec3(sum.value) / weight, sum.value.a / count_);
  };
  std::size_t used = 0;
  return material_with(*material_, *render_features_, mean_of(base_),
                       [&](const TextureUse&, TexelKind) { return mean_of(textures_[used++]); });
}

void average_colours(const World& world, const RenderFeatures& render_features, const Hit& hit,
                     const Footprint& square, std::span<const WeightedShape> parts,
                     const MipChains& mips, SurfaceMaterial& material) {
  // With alpha blending, colours are weighted by opacity.
  const bool blends = world.material_of(hit.triangle).alpha_mode == AlphaMode::blend;
  glm::vec3 color(0.0f), emission(0.0f);
  float opacity = 0.0f;
  for (const WeightedShape& part : parts) {
    Footprint footprint = shaped(square, part.shape);
    footprint.side *= std::sqrt(part.share);
    const SurfaceMaterial own = surface_material(world, render_features, hit, footprint, &mips);
    const float share = part.share * (blends ? own.opacity : 1.0f);
    color += share * own.base_color;
    emission += share * own.emission;
    opacity += share;
  }
  if (blends) {
    material.opacity = opacity;
    if (!(opacity > 0.0f)) return;
    color /= opacity, emission /= opacity;
  }
  material.base_color = color;
  material.emission = emission;
}

SurfaceMaterial untextured_material(const Material& material,
                                    const RenderFeatures& render_features) {
  return material_with(material, render_features, material.base_color,
                       [](const TextureUse&, TexelKind) { return glm::vec4(1.0f); });
}

glm::vec4 vertex_color(const World& world, std::uint32_t triangle, float b1, float b2) {
  if (world.is_face(triangle)) return glm::vec4(1.0f);
  const glm::uvec3 v = world.triangles[triangle];
  const glm::vec4 c = world.colors[v.x];
  // A hit at an edge may lie beyond it by a rounding error, but a colour must not be negative.
  return glm::max(c + b1 * (world.colors[v.y] - c) + b2 * (world.colors[v.z] - c), 0.0f);
}

}  // namespace asos
