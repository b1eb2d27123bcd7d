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
  if (m.stroke && !m.unlit) return SamplePath::line;
  return finite(surface) ? SamplePath::lanes : SamplePath::not_finite;
}

MaterialLayers layers_of(const Material& m) {
  if (m.unlit) return {false, false, false};
  return {m.coat.factor > 0.0f, m.sheen.used(), m.diffuse_transmission.used()};
}

SimdMaterial plain_material(const World& world, const RenderFeatures& render_features,
                            const Material& m) {
  SimdMaterial plain;
  plain.surface = untextured_material(m, render_features);
  const auto uses = texture_uses(m);
  const bool used =
      std::any_of(uses.begin(), uses.end(), [](const TextureUse* use) { return use->used(); });
  const bool maps = render_features.normal_maps && !world.normals.empty();
  plain.textured = render_features.textures && used;
  plain.look_ups = texture_look_ups(m, render_features);
  plain.looked_up = used || (render_features.vertex_colors && !world.colors.empty());
  plain.normal_map = maps && m.normal_texture.used();
  plain.masked = m.alpha_mode == AlphaMode::mask;
  plain.coat_map = maps && m.coat.normal_texture.used();
  const bool glossy = m.roughness <= least_broad_roughness || m.coat.factor > 0.0f;
  plain.shiny = glossy && !m.unlit && render_features.lights();
  plain.blended = render_features.alpha_blend && surface_kind(m) == SurfaceKind::blended;
  plain.own_lobe = !m.unlit && (m.film.used() || m.anisotropy.used());
  plain.layers = layers_of(m);
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
