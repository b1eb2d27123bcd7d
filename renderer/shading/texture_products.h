#pragma once

#include "renderer/lights/prepared_light.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <limits>
#include <span>

namespace asos {

/// Returns whether shading multiplies several of a material's textures, or a texture affects its
/// reflections. Then the mean of the shading is not the shading of the textures' means.
[[nodiscard]] bool multiplies_textures(const Material& material,
                                       const RenderFeatures& render_features);

/// The viewer and the lights of a footprint.
struct ViewedFrom {
  glm::vec3 to_viewer{0, 0, 1};
  float roughest_mirror = 0.35f;  ///< rougher surfaces reflect a constant sky
  /// Null: reflections of smoother surfaces are not followed. Otherwise they follow the textures'
  /// means in these chains, which may reach beyond the footprint.
  const MipChains* reflections = nullptr;
  std::span<const PreparedLight> lights = {};             ///< those whose highlights are compared
  float enough = std::numeric_limits<float>::infinity();  ///< no larger error has to be found
};

/// Errors of a footprint's display intensity if shading uses the mean of each texture.
struct ProductError {
  float shading = 0.0f;      ///< in light that is uniform on each side
  float reflections = 0.0f;  ///< of places that reflect in another way than their mean does
  float highlights = 0.0f;   ///< of unshadowed lights

  [[nodiscard]] float sum() const { return shading + reflections + highlights; }
};

/// Returns the errors. It compares 16 points of the footprint with their means. The light of each
/// side is up to half as bright as white. Half of the diffuse light comes from the sky and is
/// occluded. Surfaces rougher than `roughest_mirror` reflect a fraction of the sky, and others all
/// of it. Returns 0 if the first eight points do not differ in two factors or in roughness.
[[nodiscard]] ProductError product_error(const World& world, const RenderFeatures& render_features,
                                         const Hit& hit, const Footprint& footprint,
                                         const ViewedFrom& from);

}  // namespace asos
