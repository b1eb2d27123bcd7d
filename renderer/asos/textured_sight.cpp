#include "renderer/asos/textured_sight.h"

#include "renderer/asos/texture_samples.h"
#include "renderer/shading/texture_products.h"

#include <algorithm>
#include <cmath>

namespace asos {

bool reaches_beyond_triangle(const World& world, const Hit& hit, const Patch& patch) {
  constexpr float far = 0.5f;  // of the triangle
  const Footprint seen = footprint_on(world, hit, patch);
  const auto reach = [](glm::vec2 edge) {
    return std::max({std::abs(edge.x), std::abs(edge.y), std::abs(edge.x + edge.y)});
  };
  return std::max(reach(seen.right), reach(seen.down)) > far;
}

bool textured_by_several(const EyeContext& eye, const Hit& hit, const Patch& patch) {
  const RenderScene& scene = *eye.scene;
  return eye.settings->texture.filter != TextureFilter::point &&
         is_textured(scene.world().material_of(hit.triangle), scene.needs) &&
         scene.features().deviation(hit.triangle) > 0.0f &&
         reaches_beyond_triangle(scene.world(), hit, patch);
}

bool uneven_products(const EyeContext& eye, const Hit& hit, const Patch& square,
                     const PartShape& part, double share) {
  const RenderScene& scene = *eye.scene;
  if (eye.settings->texture.filter == TextureFilter::point ||
      !multiplies_textures(scene.world().material_of(hit.triangle), scene.needs))
    return false;
  Footprint seen = shaped(footprint_on(scene.world(), hit, square), part);
  seen.side = eye.side_of(share);
  const float roughest = eye.viewer.shader.settings().roughest_mirror;
  return product_error(scene.world(), scene.needs, hit, seen, roughest) >
         eye.budget.for_samples().tolerance;
}

}  // namespace asos
