#include "renderer/shading/material_layers.h"

#include "renderer/geometry/largest.h"

namespace asos {

float cosine_for(MaterialLayer layer, const ViewedPoint& view) {
  const bool mirrors = layer == MaterialLayer::coat || layer == MaterialLayer::base;
  return mirrors ? mirroring_cosine(view) : view.n_dot_v;
}

ViewedMaterial viewed(const SurfaceMaterial& material, MaterialLayer layer, float cosine) {
  switch (layer) {
    case MaterialLayer::coat:
      return viewed(material.coat, cosine);
    case MaterialLayer::sheen:
      return viewed(material.sheen, cosine);
    case MaterialLayer::behind:
      return viewed_from_behind(material, cosine);
    case MaterialLayer::base:
      break;
  }
  return viewed(material, cosine);
}

float passed_below(MaterialLayer layer, glm::vec3 f0, glm::vec3 ambient) {
  if (layer == MaterialLayer::coat) return 1.0f - f0.x;
  return layer == MaterialLayer::sheen ? 1.0f - largest(ambient) : 1.0f;
}

float transmitted_share(const SurfaceMaterial& material, float n_dot_v) {
  if (material.unlit) return material.transmission;
  float left = 1.0f;
  for (const MaterialLayer layer : MaterialLayers(material)) {
    if (layer == MaterialLayer::behind) continue;
    const ViewedMaterial seen = viewed(material, layer, n_dot_v);
    left *= layer == MaterialLayer::base ? seen.below * (1.0f - material.metallic)
                                         : passed_below(layer, seen.lobe.f0, seen.ambient);
  }
  return left * material.transmission;
}

}  // namespace asos
