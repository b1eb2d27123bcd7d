#pragma once

#include "renderer/film/film.h"
#include "tests/support/flat_mesh.h"

#include <algorithm>
#include <ostream>
#include <vector>

// Thin moving objects in front of a contrasting background. Surfaces are unlit and the view is
// orthographic, so only visibility changes, and the sum of a picture's intensities measures the
// visible area.

namespace asos::test {

/// A pole, or a gap between two walls, sheared by `slope` pixels per pixel of height.
struct ThinSubject {
  const char* name;
  double slope = 0.0;
  double half = 0.0;  ///< it ends at -half and +half, in pixels; 0: beyond the picture
  bool gap = false;
};
inline std::ostream& operator<<(std::ostream& out, const ThinSubject& subject) {
  return out << subject.name;
}
inline constexpr double thin_width = 1.0 / 8.0;  // pixels

/// The subject with its centre line x pixels from the picture's centre, and a camera for pictures
/// of `size` x `size` pixels of one unit.
inline Scene thin_scene(const ThinSubject& subject, double x, int size) {
  Scene scene{.source = "thin"};
  const auto add = [&](const Mesh& mesh, float grey) {
    Material material{.base_color = glm::vec4(glm::vec3(grey), 1.0f), .unlit = true};
    place(scene, mesh, material);
  };
  const double far = 4.0 * size;
  const double half = subject.half > 0.0 ? subject.half : far;
  const double left = x - thin_width / 2.0;
  const double right = x + thin_width / 2.0;
  add(slanted_strip(-far, far, 0.0, far, -10.0), 0.2f);
  if (subject.gap) {
    add(slanted_strip(-2.0 * far, left, subject.slope, half, 0.0), 0.9f);
    add(slanted_strip(right, 2.0 * far, subject.slope, half, 0.0), 0.9f);
  } else {
    add(slanted_strip(left, right, subject.slope, half, 0.0), 0.9f);
  }
  Camera camera{.type = Camera::Type::orthographic, .height = 1.0 * size};
  camera.world_from_camera[3] = glm::dvec4(0, 0, 20, 1);
  scene.cameras.push_back(camera);
  return scene;
}

/// The subject's contribution to the sum of the picture's intensities (negative for a gap),
/// relative to the exact value: its area times its contrast.
inline double thin_share(const ThinSubject& subject, const Film& film) {
  double sum = 0.0;
  for (const glm::vec3& c : film.radiance) sum += static_cast<double>(c.g);
  const double plain = (subject.gap ? 0.9 : 0.2) * film.width * film.height;
  const double contrast = subject.gap ? -0.7 : 0.7;
  const double height = subject.half > 0.0 ? 2.0 * subject.half : film.height;
  return (sum - plain) / (contrast * thin_width * height);
}

/// The range of contributions over all steps of a movement.
struct Steadiness {
  double range = 0.0;  ///< (max - min) / mean
  double mean = 0.0;
};
inline Steadiness steadiness(const std::vector<double>& shares) {
  const auto [lo, hi] = std::minmax_element(shares.begin(), shares.end());
  double mean = 0.0;
  for (const double share : shares) mean += share / static_cast<double>(shares.size());
  return {(*hi - *lo) / mean, mean};
}

}  // namespace asos::test
