#pragma once

#include "renderer/shading/brdf.h"
#include "renderer/shading/viewed_point.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace asos {

/// A layer of a surface that reflects light by itself, from the top down.
enum class MaterialLayer : std::uint8_t {
  coat,    ///< KHR_materials_clearcoat
  sheen,   ///< KHR_materials_sheen
  base,    ///< the surface itself
  behind,  ///< KHR_materials_diffuse_transmission
};

/// The layers of a surface, from the top down; the surface itself is one of them.
class MaterialLayers {
 public:
  static constexpr std::size_t most = 4;

  MaterialLayers(bool coat, bool sheen, bool behind) {
    if (coat) all_[count_++] = MaterialLayer::coat;
    if (sheen) all_[count_++] = MaterialLayer::sheen;
    base_ = count_;
    all_[count_++] = MaterialLayer::base;
    if (behind) all_[count_++] = MaterialLayer::behind;
  }
  explicit MaterialLayers(const SurfaceMaterial& material)
      : MaterialLayers(material.coat.factor > 0.0f, material.sheen.color != glm::vec3(0.0f),
                       material.diffuse_transmission > 0.0f) {}

  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] MaterialLayer operator[](std::size_t i) const { return all_[i]; }
  [[nodiscard]] const MaterialLayer* begin() const { return all_.data(); }
  [[nodiscard]] const MaterialLayer* end() const { return all_.data() + count_; }
  /// Returns the number of layers above the surface itself.
  [[nodiscard]] std::size_t base() const { return base_; }

 private:
  std::array<MaterialLayer, most> all_{};
  std::size_t count_ = 0;
  std::size_t base_ = 0;
};

/// Returns the viewer's cosine for a layer: mirroring_cosine for the coat and the base, else n.v.
[[nodiscard]] float cosine_for(MaterialLayer layer, const ViewedPoint& view);

/// Computes the values of a layer for a viewer at `cosine`.
[[nodiscard]] ViewedMaterial viewed(const SurfaceMaterial& material, MaterialLayer layer,
                                    float cosine);

/// Returns the fraction of light that passes a layer to those below, from `f0` and `ambient` of its
/// ViewedMaterial: for the coat of mix(base, coat, factor * fresnel(n_c.v)), and for sheen 1 -
/// max3(colour) * E(n.v).
[[nodiscard]] float passed_below(MaterialLayer layer, glm::vec3 f0, glm::vec3 ambient);

/// Returns the fraction of light that passes a transmissive surface at this angle: the rest of its
/// layers and of the dielectric's lobe. The base colour is not included. An unlit surface passes
/// all that it transmits.
[[nodiscard]] float transmitted_share(const SurfaceMaterial& material, float n_dot_v);

}  // namespace asos
