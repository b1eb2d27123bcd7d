#include "renderer/shading/simd_materials.h"

#include "renderer/shading/brdf.h"
#include "renderer/world/surface_kind.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace asos {
namespace {

bool finite(const SurfaceMaterial& m) {
  const glm::vec3 sum = m.base_color + m.f0 + m.emission;
  return std::isfinite(sum.x + sum.y + sum.z + m.f90 + m.metallic + m.roughness);
}

SimdMaterial plain_material(const World& world, const RenderFeatures& render_features,
                            const Material& m) {
  SimdMaterial plain;
  plain.surface = untextured_material(m, render_features);
  const auto uses = texture_uses(m);
  const bool used =
      std::any_of(uses.begin(), uses.end(), [](const TextureUse* use) { return use->used(); });
  plain.textured = render_features.textures && used;
  plain.looked_up = used || (render_features.vertex_colors && !world.colors.empty());
  plain.normal_map = render_features.normal_maps && m.normal_texture.used();
  plain.shiny = m.roughness <= least_broad_roughness && render_features.lights();
  const bool layered = m.coat.factor > 0.0f || m.sheen.used() || m.film.used() ||
                       m.anisotropy.used() || m.diffuse_transmission.used();
  plain.plain = !m.unlit && !m.stroke && !layered && surface_kind(m) != SurfaceKind::blended &&
                finite(plain.surface);
  return plain;
}

}  // namespace

SimdMaterials::SimdMaterials(const World& world, const RenderFeatures& render_features,
                             const MaterialDfrs& dfrs) {
  for (std::size_t i = 0; i < world.materials.size(); ++i) {
    SimdMaterial& plain =
        materials_.emplace_back(plain_material(world, render_features, world.materials[i]));
    plain.own_dfr = i < dfrs.size() && dfrs[i].has_value();
  }
  for (const Part& part : world.parts) part_material_.push_back(part.material);
}

}  // namespace asos
