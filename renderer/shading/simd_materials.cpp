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

SamplePath path_of(const Material& m, const SurfaceMaterial& surface) {
  if (bounds_volume(m)) return SamplePath::volume;
  if (surface_kind(m) == SurfaceKind::blended) return SamplePath::blended;
  if (m.unlit) return SamplePath::unlit;
  if (m.stroke) return SamplePath::line;
  if (m.coat.factor > 0.0f) return SamplePath::coat;
  if (m.sheen.used()) return SamplePath::sheen;
  if (m.film.used()) return SamplePath::film;
  if (m.anisotropy.used()) return SamplePath::anisotropy;
  if (m.diffuse_transmission.used()) return SamplePath::diffuse_transmission;
  return finite(surface) ? SamplePath::lanes : SamplePath::not_finite;
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
  plain.path = path_of(m, plain.surface);
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
