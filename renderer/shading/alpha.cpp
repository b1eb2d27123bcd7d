#include "renderer/shading/shade.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/texture.h"
#include "renderer/world/surface_kind.h"

#include <algorithm>

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

}  // namespace

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
