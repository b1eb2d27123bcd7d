#pragma once

#include "renderer/lights/emitter_mesh.h"

#include <glm/glm.hpp>

#include <span>

namespace asos {

/// Axes and spreads of a symmetric matrix, the largest first: `axis` holds unit eigenvectors.
struct PrincipalAxes {
  glm::dmat3 axis{1.0};
  glm::dvec3 value{0.0};
};
/// By Jacobi's rotations.
[[nodiscard]] PrincipalAxes principal_axes(const glm::dmat3& symmetric);

/// Integrals over a set of triangles.
struct Moments {
  double area = 0.0;
  glm::dvec3 power{0.0};        ///< integral of radiance over the front sides: nits times area
  glm::dvec3 centre{0.0};       ///< centroid of area
  glm::dvec3 area_vector{0.0};  ///< integral of the unit normal: 0 for closed surfaces
  glm::dmat3 normals{0.0};      ///< mean of n n^T: a third of the identity for isotropic ones
  glm::dmat3 spread{0.0};       ///< mean of d d^T, d the way from the centre
  double outward = 0.0;         ///< mean of n . d / mean of |d|: 1 for a sphere, -1 inside out

  static Moments of(std::span<const EmitterTriangle> triangles, const Piece& piece);

  [[nodiscard]] glm::dvec3 radiance() const { return power / area; }
  /// Whether the surface faces away from its middle nearly all around: a closed one, or one with
  /// an opening, either way round.
  [[nodiscard]] bool encloses() const;
};

}  // namespace asos
