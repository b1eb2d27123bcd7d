#pragma once

#include "renderer/world/world.h"

#include <cstdint>
#include <string>
#include <vector>

namespace asos::ui {

/// A material that can mirror, with those that look like it: they are edited as one, because no
/// boundary is looked for where they meet.
struct MirrorMaterial {
  std::string name;
  std::vector<std::uint32_t> members;  ///< into World::materials, at least one
};

/// The materials that `world`, which is that of a scene as it was prepared, shows and that can
/// mirror: those with a defocusing ratio of their own, metals that are not all rough, and those
/// that a texture or factor makes smooth enough to mirror by default.
[[nodiscard]] std::vector<MirrorMaterial> mirror_materials(const World& world);

/// Index of the one that `material` belongs to; -1: none.
[[nodiscard]] int find_mirror(const std::vector<MirrorMaterial>& mirrors, std::uint32_t material);

}  // namespace asos::ui
