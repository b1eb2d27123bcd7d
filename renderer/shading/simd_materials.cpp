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

SimdMaterial plain_material(const World& world, const SceneNeeds& needs, const Material& m) {
  SimdMaterial plain;
  plain.surface = untextured_material(m, needs);
  const auto uses = texture_uses(m);
  const bool used =
      std::any_of(uses.begin(), uses.end(), [](const TextureUse* use) { return use->used(); });
  plain.textured = needs.textures && used;
  plain.looked_up = used || (needs.vertex_colors && !world.colors.empty());
  plain.normal_map = needs.normal_maps && m.normal_texture.used();
  plain.shiny = m.roughness <= least_broad_roughness && needs.lights();
  const bool layered = m.coat.factor > 0.0f || m.sheen.used() || m.film.used() ||
                       m.anisotropy.used() || m.diffuse_transmission.used();
  plain.plain = !m.unlit && !m.stroke && !layered && surface_kind(m) != SurfaceKind::blended &&
                finite(plain.surface);
  return plain;
}

}  // namespace

SimdMaterials::SimdMaterials(const World& world, const SceneNeeds& needs,
                             const MaterialDfrs& dfrs) {
  for (std::size_t i = 0; i < world.materials.size(); ++i) {
    SimdMaterial& plain = materials_.emplace_back(plain_material(world, needs, world.materials[i]));
    plain.own_dfr = i < dfrs.size() && dfrs[i].has_value();
  }
  for (const Part& part : world.parts) part_material_.push_back(part.material);
}

}  // namespace asos
