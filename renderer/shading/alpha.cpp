#include "renderer/rays/surface_kind.h"
#include "renderer/shading/shade.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/texture.h"

#include <algorithm>

namespace asos {

float alpha_at(const World& world, std::uint32_t triangle, float b1, float b2) {
  const Material& material = world.material_of(triangle);
  const float solid = 1.0f - std::clamp(material.transmission, 0.0f, 1.0f);
  if (material.alpha_mode == AlphaMode::opaque) return solid;

  float alpha = material.base_color.a;
  if (material.base_color_texture.used()) {
    alpha *=
        sample_texture(world, material.base_color_texture, triangle, b1, b2, Encoding::linear).a;
  }
  if (!world.colors.empty()) alpha *= vertex_color(world, triangle, b1, b2).a;
  alpha = std::clamp(alpha, 0.0f, 1.0f);
  if (surface_kind(material) == SurfaceKind::masked) return alpha;
  if (material.alpha_mode == AlphaMode::mask) alpha = alpha >= material.alpha_cutoff ? 1.0f : 0.0f;
  return alpha * solid;
}

}  // namespace asos
