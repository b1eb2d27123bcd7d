#pragma once

#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {

/// Smallest cosine to the viewer. A smooth normal may turn away from the viewer near a mesh's
/// outline, which a real surface cannot. The lobe's denominator needs a positive cosine; this one
/// is a tenth of a degree above the horizon.
inline constexpr float grazing_cosine = 1.0f / 512.0f;

/// Returns a unit direction to the viewer in the frame of a shading normal, z. It is raised to
/// grazing_cosine where the normal turns away.
[[nodiscard]] inline glm::vec3 viewer_above(glm::vec3 local) {
  if (local.z >= grazing_cosine) return local;
  local.z = grazing_cosine;
  return glm::normalize(local);
}

/// A surface point with its viewer.
struct ViewedPoint {
  const SurfacePoint& point;
  glm::vec3 to_viewer;
  float n_dot_v;     ///< at least grazing_cosine
  Patch patch = {};  ///< patch of surface that it represents; a point where that does not matter
  float distance = std::numeric_limits<float>::infinity();  ///< of the viewer
};

[[nodiscard]] inline ViewedPoint viewed_point(const SurfacePoint& point, glm::vec3 to_viewer) {
  const float n_dot_v = std::max(glm::dot(point.shading_normal, to_viewer), grazing_cosine);
  return {point, to_viewer, n_dot_v};
}

/// Reflected unit directions rise at least this far above the surface.
inline constexpr float least_mirrored_rise = 1.0f / 1024.0f;

/// Returns how far the direction reflected at the shading normal rises above the surface itself.
/// Returns least_mirrored_rise if that normal is the geometric one.
[[nodiscard]] inline float mirrored_rise(const SurfacePoint& point, glm::vec3 to_viewer) {
  if (point.shading_normal == point.geometric_normal) return least_mirrored_rise;
  const float cosine = glm::dot(point.shading_normal, to_viewer);
  return 2.0f * cosine * glm::dot(point.shading_normal, point.geometric_normal) -
         glm::dot(to_viewer, point.geometric_normal);
}

/// Returns the normal at which a lobe reflects: the shading normal. If that reflects the viewer
/// below the surface, returns the nearest normal that does not (as Cycles'
/// ensure_valid_specular_reflection).
[[nodiscard]] inline glm::vec3 mirroring_normal(const SurfacePoint& point, glm::vec3 to_viewer) {
  const float rise = mirrored_rise(point, to_viewer);
  if (rise >= least_mirrored_rise) return point.shading_normal;
  const glm::vec3 mirrored = glm::reflect(-to_viewer, point.shading_normal);
  const glm::vec3 raised =
      glm::normalize(mirrored + (least_mirrored_rise - rise) * point.geometric_normal);
  return glm::normalize(to_viewer + raised);
}

/// Returns the cosine between mirroring_normal and the viewer, at least grazing_cosine.
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
