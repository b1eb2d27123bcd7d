#pragma once

#include "renderer/world/world.h"

#include <cstdint>
#include <string>
#include <vector>

namespace asos::ui {

/// A reflecting material with all materials that look the same. They are edited as one, because no
/// edge is searched where they meet.
struct MirrorMaterial {
  std::string name;
  std::vector<std::uint32_t> members;  ///< indices into World::materials, at least one
};

/// The reflecting materials that are visible in `world`, the world of a prepared scene: those with
/// their own defocusing ratio, metals that are not fully rough, and those that a texture or factor
/// makes smooth enough to reflect by default.
[[nodiscard]] std::vector<MirrorMaterial> mirror_materials(const World& world);

/// Index of the entry that contains `material`; -1: none.
[[nodiscard]] int find_mirror(const std::vector<MirrorMaterial>& mirrors, std::uint32_t material);

}  // namespace asos::ui
