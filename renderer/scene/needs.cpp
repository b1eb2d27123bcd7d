#include "renderer/scene/needs.h"

#include <algorithm>

namespace asos {

namespace {

bool emits(const Material& m) {
  return m.emissive_strength > 0.0f && std::max({m.emissive.x, m.emissive.y, m.emissive.z}) > 0.0f;
}

void add_material(SceneNeeds& needs, const Material& m) {
  needs.textures |= m.base_color_texture.used();
  needs.alpha_mask |= m.alpha_mode == AlphaMode::mask;
  needs.alpha_blend |= m.alpha_mode == AlphaMode::blend;
  if (m.unlit) return;  // an unlit material uses nothing but its base colour
  needs.textures |= m.metallic_roughness_texture.used() || m.normal_texture.used() ||
                    (m.emissive_texture.used() && emits(m));
  needs.normal_maps |= m.normal_texture.used();
  needs.emission |= emits(m);
  needs.metals |= m.metallic > 0.0f;
}

}  // namespace

std::vector<std::string> SceneNeeds::left_out() const {
  std::vector<std::string> names;
  const auto name_unless = [&](bool needed, const char* name) {
    if (!needed) names.emplace_back(name);
  };
  name_unless(textures, "textures");
  name_unless(normal_maps, "normal maps");
  name_unless(vertex_colors, "vertex colours");
  name_unless(alpha_mask, "alpha cut-outs");
  name_unless(alpha_blend, "alpha blending");
  name_unless(punctual_lights, "punctual lights");
  name_unless(emission, "emissive materials");
  name_unless(metals, "metals");
  return names;
}

SceneNeeds find_needs(const World& world) {
  SceneNeeds needs;
  // Only materials that some triangle shows count: files often bring along more.
  std::vector<bool> seen(world.materials.size(), false);
  for (const Part& part : world.parts) {
    if (part.triangle_count == 0 || seen[part.material]) continue;
    seen[part.material] = true;
    add_material(needs, world.materials[part.material]);
  }
  needs.vertex_colors = !world.colors.empty();
  needs.punctual_lights = !world.lights.empty();
  return needs;
}

}  // namespace asos
