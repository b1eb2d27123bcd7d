#pragma once

#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace asos {

/// The mean of a triangle's textures over several points, as footprints average them.
class MaterialMean {
 public:
  /// All arguments have to outlive this.
  MaterialMean(const World& world, const RenderFeatures& render_features, std::uint32_t triangle);

  /// Adds a point and returns the material there.
  SurfaceMaterial add(float b1, float b2);
  /// Returns the material of the mean textures.
  [[nodiscard]] SurfaceMaterial mean() const;

 private:
  struct Sum {
    glm::vec4 value{0.0f};
    float weight = 0.0f;  ///< of the colour; that of alpha is the number of points
  };
  static constexpr std::size_t most_textures = 16;

  const World* world_;
  const RenderFeatures* render_features_;
  std::uint32_t triangle_;
  const Material* material_;
  Sum base_;
  std::array<Sum, most_textures> textures_;  // in the order in which a material uses them
  float count_ = 0.0f;
};

}  // namespace asos
