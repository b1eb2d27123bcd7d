#pragma once

#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {

/// A smooth normal may turn away from the viewer near a mesh's outline, where no real surface
/// could. The lobe's denominator needs a positive angle; one this small is within a tenth of a
/// degree.
inline constexpr float grazing_cosine = 1.0f / 512.0f;

/// A unit direction to the viewer in the frame of a shading normal, z, raised to a grazing one
/// where the normal turns away.
[[nodiscard]] inline glm::vec3 viewer_above(glm::vec3 local) {
  if (local.z >= grazing_cosine) return local;
  local.z = grazing_cosine;
  return glm::normalize(local);
}

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

/// Mirrored directions rise at least so much, of their length, above the surface.
inline constexpr float least_mirrored_rise = 1.0f / 1024.0f;

/// How far a direction that the shading normal mirrors rises above the surface itself; of a surface
/// that mirrors by its own normal, the least that is enough.
[[nodiscard]] inline float mirrored_rise(const SurfacePoint& point, glm::vec3 to_viewer) {
  if (point.shading_normal == point.geometric_normal) return least_mirrored_rise;
  const float cosine = glm::dot(point.shading_normal, to_viewer);
  return 2.0f * cosine * glm::dot(point.shading_normal, point.geometric_normal) -
         glm::dot(to_viewer, point.geometric_normal);
}

/// The normal that a lobe mirrors about: the shading normal, or, where that mirrors the viewer
/// below the surface, the one next to it that does not (as Cycles'
/// ensure_valid_specular_reflection).
[[nodiscard]] inline glm::vec3 mirroring_normal(const SurfacePoint& point, glm::vec3 to_viewer) {
  const float rise = mirrored_rise(point, to_viewer);
  if (rise >= least_mirrored_rise) return point.shading_normal;
  const glm::vec3 mirrored = glm::reflect(-to_viewer, point.shading_normal);
  const glm::vec3 raised =
      glm::normalize(mirrored + (least_mirrored_rise - rise) * point.geometric_normal);
  return glm::normalize(to_viewer + raised);
}

/// Its cosine to the viewer, at least grazing_cosine.
[[nodiscard]] inline float mirroring_cosine(const ViewedPoint& view) {
  const SurfacePoint& point = view.point;
  const float rise = mirrored_rise(point, view.to_viewer);
  if (rise >= least_mirrored_rise) return view.n_dot_v;
  const float cosine = glm::dot(point.shading_normal, view.to_viewer);
  const float more = least_mirrored_rise - rise;
  const float along =
      2.0f * cosine * cosine - 1.0f + more * glm::dot(view.to_viewer, point.geometric_normal);
  const float length = std::sqrt(1.0f + more * (2.0f * rise + more));
  return std::max(grazing_cosine, std::sqrt(std::max(0.0f, 0.5f * (1.0f + along / length))));
}

}  // namespace asos
