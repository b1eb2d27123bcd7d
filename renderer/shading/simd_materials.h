#pragma once

#include "renderer/film/sample_path.h"
#include "renderer/shading/material_layers.h"
#include "renderer/shading/surface.h"
#include "renderer/world/render_features.h"
#include "renderer/world/world.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// Data of a material for shading batches of points.
struct SimdMaterial {
  SurfaceMaterial surface;              ///< without textures and vertex colours
  SamplePath path = SamplePath::lanes;  ///< or the reason why Shader shades it
  MaterialLayers layers{false, false, false};
  bool looked_up = false;               ///< textures or vertex colours change `surface`
  std::vector<TextureLookUp> look_ups;  ///< textures at a point, as texture_look_ups
  bool normal_map = false;
  bool coat_map = false;  ///< a normal map of its coat
  bool masked = false;    ///< texels have a cut-off
  bool textured = false;  ///< any texture is used: the patch matters
  bool shiny = false;     ///< with highlights so narrow that curvature matters
  bool own_dfr = false;   ///< has its own defocusing ratio
  bool blended = false;   ///< the ray continues behind it
  bool own_lobe = false;  ///< the base has a thin film or an anisotropic lobe

  /// Returns the number of its normal maps, and that of all values that textures have at a point.
  [[nodiscard]] std::size_t maps() const { return (normal_map ? 1u : 0u) + (coat_map ? 1u : 0u); }
  [[nodiscard]] std::size_t texels() const { return maps() + look_ups.size(); }
  [[nodiscard]] bool has_textures() const { return texels() > 0; }
  /// Returns whether the surface needs more than its place, its textures and one lobe.
  [[nodiscard]] bool layered() const { return layers.size() > 1 || blended || own_lobe; }
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
