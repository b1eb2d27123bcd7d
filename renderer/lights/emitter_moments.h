#pragma once

#include "renderer/lights/emitter_mesh.h"

#include <glm/glm.hpp>

#include <span>

namespace asos {

/// Axes and values of a symmetric matrix, the largest first: `axis` has unit eigenvectors.
struct PrincipalAxes {
  glm::dmat3 axis{1.0};
  glm::dvec3 value{0.0};
};
/// Computes the axes by Jacobi rotations.
[[nodiscard]] PrincipalAxes principal_axes(const glm::dmat3& symmetric);

/// Integrals over a set of triangles.
struct Moments {
  double area = 0.0;
  glm::dvec3 power{0.0};        ///< integral of radiance over the front sides: nits times area
  glm::dvec3 centre{0.0};       ///< centroid of area
  glm::dvec3 area_vector{0.0};  ///< integral of the unit normal: 0 for closed surfaces
  glm::dmat3 normals{0.0};      ///< mean of n n^T: a third of the identity for isotropic ones
  glm::dmat3 spread{0.0};       ///< mean of d d^T, with d from the centre
  double outward = 0.0;         ///< mean of n . d / mean of |d|: 1 for a sphere, -1 inside out

  static Moments of(std::span<const EmitterTriangle> triangles, const Piece& piece);

  [[nodiscard]] glm::dvec3 radiance() const { return power / area; }
  /// Returns whether the surface faces away from its centre, or towards it, nearly everywhere: it
  /// is closed, or has one opening.
  [[nodiscard]] bool encloses() const;
};

}  // namespace asos
