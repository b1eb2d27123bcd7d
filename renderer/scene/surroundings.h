#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <array>
#include <string>

namespace asos {

/// Light from all around, infinitely far away, that a file brings along (EXT_lights_image_based):
/// the six sides of a cube around the scene.
struct Surroundings {
  struct Side {
    Image image;  ///< square, sRGB, as a camera in the cube's middle shows it
    /// Its colours are to be divided by its alpha (RGBD), as pictures of more than white are.
    bool divided = false;
  };

  std::string name;
  /// Towards +X, -X, +Y, -Y, +Z and -Z, all as large. Those of +Y and -Y have -Z, and +Z, at their
  /// upper edge.
  std::array<Side, 6> sides;
  glm::dmat3 world_from_cube{1.0};  ///< a rotation
  float intensity = 1.0f;           ///< radiance of white
};

}  // namespace asos
