#pragma once

#include "renderer/shading/surface.h"
#include "renderer/world/needs.h"
#include "renderer/world/world.h"

#include <cstdint>
#include <vector>

namespace asos {

/// What shading a batch of points has to know of a material.
struct PlainMaterial {
  SurfaceMaterial surface;  ///< where nothing is looked up
  bool plain = false;       ///< opaque where it is met, lit, of one layer, and finite
  bool looked_up = false;   ///< textures or vertex colours vary it
  bool normal_map = false;
  bool textured = false;  ///< in any way: the patch that is seen matters
  bool shiny = false;     ///< with highlights so narrow that it matters where normals turn
  bool own_dfr = false;   ///< a defocusing ratio
};

/// The materials of a world once more, in few bytes each, by what is on its triangles. Immutable.
class PlainMaterials {
 public:
  PlainMaterials(const World& world, const SceneNeeds& needs, const MaterialDfrs& dfrs);

  [[nodiscard]] const PlainMaterial& of(const World& world, std::uint32_t triangle) const {
    return materials_[part_material_[world.triangle_part[triangle]]];
  }

 private:
  std::vector<PlainMaterial> materials_;
  std::vector<std::uint32_t> part_material_;
};

}  // namespace asos
