#pragma once

#include "renderer/geometry/largest.h"
#include "renderer/pyray/square.h"
#include "renderer/shading/light_transport.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace asos {

/// A surface of a leaf under the sky, and what its rays have found so far. Errors are of what rays
/// bring beside what they would carry if nothing were in the way, over `unit`.
struct SkyLit {
  std::uint32_t share = 0;  ///< number of the leaf's
  std::uint32_t root = 0;   ///< the leaf's, with its weight and its sample's place in the frame
  double weight = 1.0;
  glm::vec2 at{0.0f};
  std::uint64_t seed = 0;  ///< the leaf's own
  /// The leaf's region; its border, of so many edges, is kept for all leaves together.
  Square square;
  std::size_t first_edge = 0, edges = 0;
  bool flat = false;  ///< the surface is a plane, as far as the leaf shows it
  SurfacePoint point;
  std::uint32_t sheet = 0;  ///< the connected surface that the point is of
  ViewedMaterial material;
  glm::vec3 to_viewer{0.0f};
  float n_dot_v = 1.0f;
  const Sky* sky = nullptr;
  bool mirrors = false;
  glm::vec3 factor{1.0f};
  glm::vec3 open{0.0f};  ///< all of the sky's light, if nothing hid it
  /// The same; with bounces, of white surroundings.
  glm::vec3 unit{0.0f};

  std::uint32_t rays = 0;
  glm::dvec3 arrived{0.0};  ///< of all rays
  glm::dvec3 sent{0.0};     ///< if nothing were in the way
  double error = 0.0;       ///< sum over the rays, and of squares
  double error2 = 0.0;
  std::optional<glm::dvec3> told{};  ///< all that arrives, as others tell it

  [[nodiscard]] SkyLitPoint lit_point(const ViewedPoint& view) const {
    return {sky, view, material, mirrors, factor};
  }
  /// What of all that its rays would carry arrives, at most 1, where they carry anything.
  [[nodiscard]] double seen() const {
    return largest(sent) > 0.0 ? std::min(1.0, largest(arrived) / largest(sent)) : 1.0;
  }
  /// All that arrives. Where most of the sky is seen, rays tell what of it is hidden.
  [[nodiscard]] glm::dvec3 mean() const {
    if (told) return *told;
    const double all = rays;
    if (seen() < 0.5) return arrived / all;
    return glm::max(glm::dvec3(open) - (sent - arrived) / all, 0.0);
  }
  /// A ray has brought so much, and would have carried `whole`. More than white is white.
  void arrive(glm::dvec3 brought, glm::vec3 whole) {
    arrived += brought;
    const glm::dvec3 off = brought - glm::dvec3(whole);
    const double one = static_cast<double>(unit.x + unit.y + unit.z);
    const double by = one > 0.0 ? std::min(3.0, off.x + off.y + off.z) / one : 0.0;
    error += by;
    error2 += by * by;
  }
  /// The sum of squared errors about their mean.
  [[nodiscard]] double squares() const {
    return rays > 0 ? std::max(0.0, error2 - error * error / rays) : 0.0;
  }
  /// What the mean of so many rays of a Sobol sequence errs by, squared, where one ray's error has
  /// this variance: it is told by the strata that the outlines of what hides the sky pass, whose
  /// share of all falls with the root of their number, and grows with the outlines' length, which
  /// is as the root of what is hidden.
  [[nodiscard]] static double variance_of_mean(double variance, double rays) {
    return 0.5 * std::sqrt(variance) / (rays * std::sqrt(rays));
  }
  /// So many rays have that squared error.
  [[nodiscard]] static double rays_for(double variance, double error2) {
    return std::cbrt(0.25 * variance / (error2 * error2));
  }
};

}  // namespace asos
