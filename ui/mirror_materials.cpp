#include "ui/mirror_materials.h"

#include "renderer/features/surface_look.h"
#include "renderer/settings/settings.h"
#include "renderer/world/ground.h"

#include <fmt/format.h>

#include <algorithm>

namespace asos::ui {

namespace {

bool can_mirror(const Material& material) {
  if (material.unlit) return false;
  return material.dfr || material.metallic_roughness_texture.used() ||
         static_cast<double>(material.roughness) <= RenderSettings{}.mirror.roughest ||
         (material.metallic > 0.0f && material.roughness < 1.0f);
}

std::string material_name(const World& world, std::uint32_t index) {
  const std::string& name = world.materials[index].name;
  if (!name.empty()) return name;
  return index + 1 == materials_without_ground(world) ? std::string("default material")
                                                      : fmt::format("material {}", index + 1);
}

}  // namespace

std::vector<MirrorMaterial> mirror_materials(const World& world) {
  std::vector<bool> shown(world.materials.size(), false);
  for (const Part& part : world.parts)
    if (!part.shows_nothing()) shown[part.material] = true;
  std::vector<MirrorMaterial> mirrors;
  for (std::uint32_t i = 0; i < materials_without_ground(world); ++i) {
    if (!shown[i] || !can_mirror(world.materials[i])) continue;
    const auto like = std::find_if(mirrors.begin(), mirrors.end(), [&](const MirrorMaterial& m) {
      return same_look(world, world.materials[m.members.front()], world.materials[i]);
    });
    if (like != mirrors.end()) {
      like->members.push_back(i);
    } else {
      mirrors.push_back({material_name(world, i), {i}});
    }
  }
  for (MirrorMaterial& mirror : mirrors) {
    if (mirror.members.size() > 1)
      mirror.name += fmt::format(" and {} alike", mirror.members.size() - 1);
  }
  return mirrors;
}

int find_mirror(const std::vector<MirrorMaterial>& mirrors, std::uint32_t material) {
  for (std::size_t i = 0; i < mirrors.size(); ++i) {
    const auto& members = mirrors[i].members;
    if (std::find(members.begin(), members.end(), material) != members.end())
      return static_cast<int>(i);
  }
  return -1;
}

}  // namespace asos::ui
