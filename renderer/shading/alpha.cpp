#include "renderer/rays/back_face.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/hit_triangle.h"
#include "renderer/shading/material_layers.h"
#include "renderer/shading/shade.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/texture.h"
#include "renderer/shading/viewed_point.h"
#include "renderer/world/surface_kind.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asos {
namespace {

float base_alpha_at(const World& world, const Material& material, std::uint32_t triangle, float b1,
                    float b2) {
  float alpha = material.base_color.a;
  if (material.base_color_texture.used()) {
    alpha *=
        sample_texture(world, material.base_color_texture, triangle, b1, b2, Encoding::linear).a;
  }
  if (!world.colors.empty()) alpha *= vertex_color(world, triangle, b1, b2).a;
  return std::clamp(alpha, 0.0f, 1.0f);
}

/// The features of a material that affect transmission.
constexpr RenderFeatures needs_of_passage() {
  RenderFeatures render_features;
  render_features.textures = render_features.vertex_colors = render_features.metals = true;
  return render_features;
}

/// Returns the extinction coefficients of Beer and Lambert's law.
glm::vec3 extinction_of(const Volume& volume) {
  // Limit for colours of 0: the medium is opaque after a millionth of its attenuation distance.
  constexpr float opaque = 1e6f;
  glm::vec3 extinction(0.0f);
  if (!std::isfinite(volume.attenuation_distance)) return extinction;
  for (int c = 0; c < 3; ++c) {
    const float color = volume.attenuation_color[c];
    const float depth = color > 0.0f ? std::min(opaque, -std::log(color)) : opaque;
    extinction[c] = std::min(depth / volume.attenuation_distance, 1e30f);
  }
  return extinction;
}

}  // namespace

StraightTransmission passage_at(const World& world, const Hit& hit, glm::vec3 direction) {
  const Material& material = world.material_of(hit.triangle);
  if (!(material.transmission > 0.0f)) {
    const float opacity = opacity_at(world, hit.triangle, hit.b1, hit.b2);
    return {glm::vec3(1.0f - opacity)};
  }
  constexpr RenderFeatures render_features = needs_of_passage();
  const SurfaceMaterial surface = surface_material(world, render_features, hit);
  StraightTransmission passage;
  float cosine = 1.0f;
  if (!surface.unlit) {
    const std::array<glm::vec3, 3> corners = corner_normals(world, hit);
    const glm::vec3 normal = HitTriangle(world, hit).mix(corners[0], corners[1], corners[2]);
    const float lengths = glm::length(normal) * glm::length(direction);
    if (lengths > 0.0f) cosine = std::abs(glm::dot(normal, direction)) / lengths;
  }
  const float left = transmitted_share(surface, std::clamp(cosine, grazing_cosine, 1.0f));
  passage.share = glm::vec3(1.0f - surface.opacity) + surface.opacity * left * surface.base_color;
  if (bounds_volume(material)) {
    passage.extinction = extinction_of(material.volume);
    passage.enters = !meets_back(world, hit, direction);
  }
  return passage;
}

float opacity_at(const World& world, std::uint32_t triangle, float b1, float b2) {
  const Material& material = world.material_of(triangle);
  if (material.alpha_mode == AlphaMode::opaque) return 1.0f;
  const float alpha = base_alpha_at(world, material, triangle, b1, b2);
  if (material.alpha_mode == AlphaMode::blend) return alpha;
  return alpha >= material.alpha_cutoff ? 1.0f : 0.0f;
}

float alpha_at(const World& world, std::uint32_t triangle, float b1, float b2) {
  const Material& material = world.material_of(triangle);
  if (surface_kind(material) == SurfaceKind::masked)
    return base_alpha_at(world, material, triangle, b1, b2);
  float transmission = std::clamp(material.transmission, 0.0f, 1.0f);
  if (transmission > 0.0f && material.transmission_texture.used()) {
    transmission *=
        sample_texture(world, material.transmission_texture, triangle, b1, b2, Encoding::linear).r;
  }
  return opacity_at(world, triangle, b1, b2) * (1.0f - transmission);
}

}  // namespace asos
