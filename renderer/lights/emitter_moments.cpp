#include "renderer/lights/emitter_moments.h"

#include <cmath>
#include <utility>

namespace asos {
namespace {

// The sum of normals of a box without one of its six faces is a fifth of its area.
constexpr double most_open = 0.25;
constexpr double least_outward = 0.5;

}  // namespace

PrincipalAxes principal_axes(const glm::dmat3& symmetric) {
  glm::dmat3 m = symmetric;
  PrincipalAxes axes;
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
      if (m[p][q] == 0.0) continue;
      const double angle = 0.5 * std::atan2(2.0 * m[p][q], m[q][q] - m[p][p]);
      glm::dmat3 turn(1.0);
      turn[p][p] = turn[q][q] = std::cos(angle);
      turn[q][p] = std::sin(angle);
      turn[p][q] = -turn[q][p];
      m = glm::transpose(turn) * m * turn;
      axes.axis = axes.axis * turn;
    }
  }
  axes.value = {m[0][0], m[1][1], m[2][2]};
  for (const auto& [a, b] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{0, 1}}) {
    if (axes.value[a] >= axes.value[b]) continue;
    std::swap(axes.value[a], axes.value[b]);
    std::swap(axes.axis[a], axes.axis[b]);
  }
  return axes;
}

Moments Moments::of(std::span<const EmitterTriangle> triangles, const Piece& piece) {
  Moments sum;
  if (piece.empty()) return sum;
  // Sums are relative to a point of the piece, so that nothing cancels far from the origin.
  const glm::dvec3 base = triangles[piece.front()].corner[0];
  for (const std::uint32_t i : piece) {
    const EmitterTriangle& t = triangles[i];
    sum.area += t.area;
    sum.power += t.area * t.radiance;
    sum.centre += t.area * (t.middle() - base);
    sum.area_vector += t.area * t.normal;
    sum.normals += t.area * glm::outerProduct(t.normal, t.normal);
  }
  sum.centre = base + sum.centre / sum.area;
  sum.normals *= 1.0 / sum.area;

  double facing = 0.0;
  double distance = 0.0;
  for (const std::uint32_t i : piece) {
    const EmitterTriangle& t = triangles[i];
    const glm::dvec3 middle = t.middle() - sum.centre;
    facing += t.area * glm::dot(t.normal, middle);
    distance += t.area * glm::length(middle);
    // The integral of d d^T over a triangle is area / 12 times the sum over its corners plus nine
    // times the centroid's value.
    glm::dmat3 square = 9.0 * glm::outerProduct(middle, middle);
    for (const glm::dvec3& p : t.corner)
      square += glm::outerProduct(p - sum.centre, p - sum.centre);
    sum.spread += (t.area / sum.area / 12.0) * square;
  }
  sum.outward = distance > 0.0 ? facing / distance : 0.0;
  return sum;
}

bool Moments::encloses() const {
  return glm::length(area_vector) <= most_open * area && std::abs(outward) >= least_outward;
}

}  // namespace asos
