#pragma once

#include "renderer/film/sample_path.h"
#include "renderer/shading/surface.h"
#include "renderer/world/render_features.h"
#include "renderer/world/world.h"

#include <cstdint>
#include <vector>

namespace asos {

/// Data of a material for shading batches of points.
struct SimdMaterial {
  SurfaceMaterial surface;  ///< without textures and vertex colours
  SamplePath path = SamplePath::lanes;  ///< or the reason why Shader shades it
  bool looked_up = false;               ///< textures or vertex colours change `surface`
  bool normal_map = false;
  bool textured = false;  ///< any texture is used: the patch matters
  bool shiny = false;     ///< with highlights so narrow that curvature matters
  bool own_dfr = false;   ///< has its own defocusing ratio
};

/// Compact copies of the materials on a world's triangles, for the SIMD path. Immutable.
class SimdMaterials {
 public:
  SimdMaterials(const World& world, const RenderFeatures& render_features,
                const MaterialDfrs& dfrs);

  [[nodiscard]] const SimdMaterial& of(const World& world, std::uint32_t triangle) const {
    return materials_[part_material_[world.triangle_part[triangle]]];
  }

 private:
  std::vector<SimdMaterial> materials_;
  std::vector<std::uint32_t> part_material_;
};

}  // namespace asos
