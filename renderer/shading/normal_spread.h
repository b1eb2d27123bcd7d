#pragma once

#include <glm/glm.hpp>

namespace asos {

/// The variation of a patch's normals about its sample's normal. The default is none.
struct NormalSpread {
  glm::vec3 right{0.0f};  ///< turn of the unit normal along the patch's edges
  glm::vec3 down{0.0f};
  float variance = 0.0f;  ///< added by a normal map: mean squared distance of unit normals

  [[nodiscard]] bool flat() const {
    return right == glm::vec3(0.0f) && down == glm::vec3(0.0f) && variance == 0.0f;
  }
};

}  // namespace asos
