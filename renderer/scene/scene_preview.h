#pragma once

#include "renderer/geometry/camera.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>

namespace asos {

/// The size of a scene, known before its geometry is decoded: see LoadProgress.
struct ScenePreview {
  glm::dvec3 lo{0.0}, hi{0.0};   ///< bounding box in the file's coordinates, as declared
  std::optional<Camera> camera;  ///< the file's first camera, in the same coordinates
  std::uint64_t triangles = 0;   ///< elements of all copies, as declared
};

}  // namespace asos
