#pragma once

#include "renderer/film/film.h"
#include "tests/support/flat_mesh.h"

#include <algorithm>
#include <ostream>
#include <vector>

// Thin things that move before a contrasting background: unlit surfaces seen in parallel, so that
// nothing but visibility changes, and a picture's sum of intensities tells the area that is seen.

namespace asos::test {

/// A pole, or a gap between two walls, sheared by `slope` pixels across a pixel of height.
struct ThinSubject {
  const char* name;
  double slope = 0.0;
  double half = 0.0;  ///< it ends at -half and +half, in pixels; 0: beyond the picture's borders
  bool gap = false;
};
inline std::ostream& operator<<(std::ostream& out, const ThinSubject& subject) {
  return out << subject.name;
}
inline constexpr double thin_width = 1.0 / 8.0;  // pixels

/// The subject with the middle of its width at x pixels from the picture's, and a camera for
/// pictures of `size` x `size` pixels, one unit each.
inline Scene thin_scene(const ThinSubject& subject, double x, int size) {
  Scene scene;
  scene.source = "thin";
  const auto add = [&](const Mesh& mesh, float grey) {
    Material material;
    material.base_color = glm::vec4(glm::vec3(grey), 1.0f);
    material.unlit = true;
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
  Camera camera;
  camera.type = Camera::Type::orthographic;
  camera.height = size;
  camera.world_from_camera[3] = glm::dvec4(0, 0, 20, 1);
  scene.cameras.push_back(camera);
  return scene;
}

/// The amount that the subject adds to the sum of the picture's intensities, or takes from it, over
/// the exact value: its area times its contrast.
inline double thin_share(const ThinSubject& subject, const Film& film) {
  double sum = 0.0;
  for (const glm::vec3& c : film.radiance) sum += static_cast<double>(c.g);
  const double plain = (subject.gap ? 0.9 : 0.2) * film.width * film.height;
  const double contrast = subject.gap ? -0.7 : 0.7;
  const double height = subject.half > 0.0 ? 2.0 * subject.half : film.height;
  return (sum - plain) / (contrast * thin_width * height);
}

/// The spread of the shares at all steps of a movement.
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
