#pragma once

#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <limits>

namespace asos {

/// A smooth normal may turn away from the viewer near a mesh's outline, where no real surface
/// could. The lobe's denominator needs a positive angle; one this small is within a tenth of a
/// degree.
inline constexpr float grazing_cosine = 1.0f / 512.0f;

/// A point of a surface as it is seen.
struct ViewedPoint {
  const SurfacePoint& point;
  glm::vec3 to_viewer;
  float n_dot_v;     ///< at least grazing_cosine
  Patch patch = {};  ///< of the surface that it stands for; a point where that does not matter
  float distance = std::numeric_limits<float>::infinity();  ///< of the viewer; parallel rays
};

[[nodiscard]] inline ViewedPoint viewed_point(const SurfacePoint& point, glm::vec3 to_viewer) {
  const float n_dot_v = std::max(glm::dot(point.shading_normal, to_viewer), grazing_cosine);
  return {point, to_viewer, n_dot_v};
}

}  // namespace asos
