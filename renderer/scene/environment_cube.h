#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <array>
#include <string>

namespace asos {

/// An image-based light of a file (EXT_lights_image_based): infinitely far away, the six sides of a
/// cube around the scene.
struct EnvironmentCube {
  struct Side {
    Image image;  ///< square, sRGB, as seen by a camera at the centre of the cube
    /// The colours are to be divided by alpha (RGBD), as in images with radiances above 1.
    bool divided = false;
  };

  std::string name;
  /// In the order +X, -X, +Y, -Y, +Z, -Z, all of the same size. The upper edge of the +Y side is
  /// towards -Z, that of the -Y side towards +Z.
  std::array<Side, 6> sides;
  glm::dmat3 world_from_cube{1.0};  ///< a rotation
  float intensity = 1.0f;           ///< radiance of white
};

}  // namespace asos
