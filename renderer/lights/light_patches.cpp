#include "renderer/lights/light_patches.h"

#include "renderer/lights/light_math.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

constexpr float quarter = 0.5f * std::numbers::pi_v<float>;
constexpr std::array<float, LightPatch::nodes> gauss_nodes{0.0694318442f, 0.3300094782f,
                                                           0.6699905218f, 0.9305681558f};
constexpr std::array<float, LightPatch::nodes> gauss_weights{0.1739274226f, 0.3260725774f,
                                                             0.3260725774f, 0.1739274226f};
constexpr std::array<float, 2> two_nodes{0.2113248654f, 0.7886751346f};  // weights: 1/2

/// Places of a patch at one v: origin + u * step. Their weight is `area` times a factor by u
/// (set_node).
struct Row {
  glm::vec3 origin, step;
  float area = 0.0f;
};

Row row_of(const LightPatch& patch, float v) {
  if (patch.kind == LightPatch::Kind::trapezoid) {
    const float width = patch.width + v * patch.width_on;
    return {patch.origin + (patch.left + v * patch.left_on) * patch.x +
                (patch.foot + v * patch.height) * patch.y,
            width * patch.x, width * patch.height};
  }
  const float angle = quarter * v;
  return {patch.origin, std::cos(angle) * patch.x + std::sin(angle) * patch.y, quarter};
}

/// A direction of a cap, and the solid angle per du and radian of turn.
struct CapPlace {
  glm::vec3 direction;
  float solid_angle;
};
CapPlace cap_place(const LightPatch& patch, const Row& row, float u) {
  const float drop = u * u * patch.one_less_cosine;
  return {(1.0f - drop) * row.origin + std::sqrt(drop * (2.0f - drop)) * row.step,
          2.0f * u * patch.one_less_cosine};
}

// Sets a node at (u, the row's v); `share` is the factor of its area or solid angle.
void set_node(const LightPatch& patch, const Row& row, float u, float share, LightPatch::Cell& cell,
              std::size_t at) {
  if (patch.kind == LightPatch::Kind::cap) {
    const CapPlace place = cap_place(patch, row, u);
    cell.x[at] = place.direction.x, cell.y[at] = place.direction.y, cell.z[at] = place.direction.z;
    cell.solid_angle[at] = share * place.solid_angle;
    return;
  }
  cell.x[at] = row.origin.x + u * row.step.x, cell.y[at] = row.origin.y + u * row.step.y;
  cell.z[at] = row.origin.z + u * row.step.z;
  cell.solid_angle[at] = share * (patch.kind == LightPatch::Kind::sector ? u : 1.0f);
}

}  // namespace

glm::vec3 LightPatch::direction(float u, float v) const {
  const Row row = row_of(*this, v);
  if (kind == Kind::cap) return cap_place(*this, row, u).direction;
  const glm::vec3 offset = row.origin + u * row.step;
  return offset / std::max(1e-30f, glm::length(offset));
}

LightPatch::Cell LightPatch::cell(const Square& square) const {
  Cell cell;
  const float side2 = square.side * square.side;
  for (std::size_t k = 0; k < nodes; ++k) {
    const Row row = row_of(*this, square.v + square.side * gauss_nodes[k]);
    const float share = side2 * gauss_weights[k] * row.area;
    for (std::size_t i = 0; i < nodes; ++i)
      set_node(*this, row, square.u + square.side * gauss_nodes[i], share * gauss_weights[i], cell,
               nodes * k + i);
  }
  if (kind != Kind::cap) look_at_places(cell);
  return cell;
}

LightPatch::Cell LightPatch::cell_of_quarters(std::span<const LightPatch, 4> quarters) {
  Cell cell;
  std::size_t at = 0;
  for (const LightPatch& quarter : quarters) {
    for (const float v : two_nodes) {
      const Row row = row_of(quarter, v);
      for (const float u : two_nodes) set_node(quarter, row, u, 0.25f * row.area, cell, at++);
    }
  }
  if (quarters[0].kind != Kind::cap) quarters[0].look_at_places(cell);
  return cell;
}

// Converts offsets to directions, and areas to solid angles.
void LightPatch::look_at_places(Cell& cell) const {
  const glm::vec3 f = facing;
  const float behind = two_sided ? -1.0f : 0.0f;
  for (std::size_t i = 0; i < cell_nodes; ++i) {
    const float dx = cell.x[i], dy = cell.y[i], dz = cell.z[i];
    const float square = dx * dx + dy * dy + dz * dz;
    const float nearness2 = 1.0f / (square > 1e-20f ? square : 1e-20f);
    const float nearness = std::sqrt(nearness2);
    cell.x[i] = nearness * dx, cell.y[i] = nearness * dy, cell.z[i] = nearness * dz;
    const float cosine = -nearness * (dx * f.x + dy * f.y + dz * f.z);
    cell.solid_angle[i] *= nearness2 * (cosine > 0.0f ? cosine : behind * cosine);
  }
}

void LightPatch::add_quarters(LightPatch patch, std::vector<LightPatch>& patches) {
  for (int i = 0; i < 4; ++i) {
    patches.push_back(patch);
    const glm::vec3 x = patch.x;
    patch.x = patch.y;
    patch.y = -x;
  }
}

void LightPatch::add_cap(glm::dvec3 axis, double one_less_cosine,
                         std::vector<LightPatch>& patches) {
  LightPatch patch;
  patch.kind = Kind::cap;
  const glm::dvec3 x = any_perpendicular(axis);
  patch.origin = glm::vec3(axis);
  patch.x = glm::vec3(x);
  patch.y = glm::vec3(glm::cross(axis, x));
  patch.one_less_cosine = static_cast<float>(one_less_cosine);
  add_quarters(patch, patches);
}

}  // namespace asos
