#include "renderer/shading/light_quadrature.h"

#include "renderer/geometry/largest.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/ggx.h"
#include "renderer/shading/sheen.h"
#include "renderer/shading/viewed_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

// Limits above which cells are divided, from centre to corner: an angle in radians, and the larger
// of a fraction of the way to the mirrored view and a fraction of the lobe.
struct Widest {
  float cell;
  float share_of_way;
  float share_of_lobe;
};
Widest widest_of(const Lobe& lobe) {
  return largest(lobe.f0) <= 0.1f ? Widest{1.0f, 0.7f, 2.0f} : Widest{0.3f, 0.4f, 1.4f};
}
// The integrand has a kink at the horizon.
constexpr float share_across_horizon = 0.4f;
// A round light is one cell if its extent is within this fraction of a cell's limit.
constexpr float share_of_small = 0.35f;
constexpr int deepest = 10;
constexpr int most_cells = 2048;

}  // namespace

LightQuadrature::LightQuadrature(const Receiver& receiver, glm::dvec3 to_viewer, const Lobe& lobe)
    : receiver_(receiver),
      normal_(receiver.normal),
      geometric_(receiver.geometric),
      to_viewer_(to_viewer),
      mirrored_(glm::reflect(-to_viewer, receiver.normal)),
      n_dot_v_(std::max(glm::dot(normal_, to_viewer_), grazing_cosine)),
      alpha2_(lobe.alpha() * lobe.alpha()),
      sheen_(lobe.sheen),
      stretched_({}, lobe, glm::vec3(receiver.normal)) {
  viewer_root_ = smith_root(n_dot_v_, alpha2_);
  // At grazing angles the lobe is narrower across the plane of view.
  const Widest widest = widest_of(lobe);
  widest_ = widest.cell;
  share_of_way_ = widest.share_of_way;
  narrowest_ = widest.share_of_lobe * lobe.alpha() * std::clamp(n_dot_v_, 0.1f, 1.0f);
  if (stretched_.wider()) across_ridge_ = glm::normalize(glm::cross(normal_, lobe.stretch.along));
}

float LightQuadrature::way_to_peak(glm::vec3 direction) const {
  const float to_mirrored = glm::length(mirrored_ - direction);
  if (across_ridge_ == glm::vec3(0.0f)) return to_mirrored;
  // A stretched lobe is bright where the half vector is nearly perpendicular to across_ridge_.
  return std::min(to_mirrored, std::abs(glm::dot(across_ridge_, to_viewer_ + direction)));
}

ReflectedIntegral LightQuadrature::operator()(const PreparedLight& light) {
  sums_ = {};
  cells_ = 0;
  if (light.traits().line) {
    add_segment(light);
  } else {
    find_light_patches(light, receiver_, patches_);
    if (!add_as_one_cell())
      for (const LightPatch& patch : patches_) add_patch(patch);
  }
  const double left = attenuation(light, receiver_.position);
  return {left * static_cast<double>(sums_.lobe), left * static_cast<double>(sums_.fresnel),
          left * static_cast<double>(sums_.scattered)};
}

void LightQuadrature::add_patch(const LightPatch& patch) {
  add_square(patch, {},
             {patch.direction(0.0f, 0.0f), patch.direction(1.0f, 0.0f), patch.direction(0.0f, 1.0f),
              patch.direction(1.0f, 1.0f)},
             0);
}

float LightQuadrature::widest_at(glm::vec3 middle) const {
  return std::min(widest_, std::max(narrowest_, share_of_way_ * way_to_peak(middle)));
}

// Parts share their corners, because computing directions costs as much as a cell.
void LightQuadrature::add_square(const LightPatch& patch, const LightPatch::Square& square,
                                 const Corners& corners, int depth) {
  const float half = 0.5f * square.side;
  const glm::vec3 middle = patch.direction(square.u + half, square.v + half);
  float reach2 = 0.0f;
  int above = 0;
  for (const glm::vec3& corner : corners) {
    const glm::vec3 across = corner - middle;
    reach2 = std::max(reach2, glm::dot(across, across));
    above += glm::dot(corner, normal_) > 0.0f;
  }
  float most = widest_at(middle);
  if (above % 4 != 0) most *= share_across_horizon;
  if (reach2 > most * most && depth < deepest && cells_ < most_cells) {
    const float u = square.u, v = square.v, side = square.side;
    const glm::vec3 foot = patch.direction(u + half, v), top = patch.direction(u + half, v + side);
    const glm::vec3 left = patch.direction(u, v + half),
                    right = patch.direction(u + side, v + half);
    add_square(patch, {u, v, half}, {corners[0], foot, left, middle}, depth + 1);
    add_square(patch, {u + half, v, half}, {foot, corners[1], middle, right}, depth + 1);
    add_square(patch, {u, v + half, half}, {left, middle, corners[2], top}, depth + 1);
    add_square(patch, {u + half, v + half, half}, {middle, right, top, corners[3]}, depth + 1);
    return;
  }
  add_cell(patch.cell(square));
}

bool LightQuadrature::add_as_one_cell() {
  if (patches_.empty() || patches_.front().kind == LightPatch::Kind::trapezoid) return false;
  const glm::vec3 middle = patches_.front().direction(0.0f, 0.0f);
  const float most = share_of_small * widest_at(middle);
  for (const LightPatch& quarter : patches_) {
    const glm::vec3 rim = quarter.direction(1.0f, 0.0f);
    const glm::vec3 across = rim - middle;
    if (glm::dot(across, across) > most * most || !(glm::dot(rim, normal_) > 0.0f)) return false;
  }
  add_cell(LightPatch::cell_of_quarters(std::span<const LightPatch, 4>(patches_)));
  return true;
}

void LightQuadrature::add_cell(const LightPatch::Cell& cell) {
  ++cells_;
  constexpr std::size_t count = LightPatch::cell_nodes;
  std::array<float, count> form, lobe, fresnel, scattered;
  const glm::vec3 n = normal_, g = geometric_, v = to_viewer_;
  const float n_dot_v = glm::dot(n, v), clamped_n_dot_v = n_dot_v_;
  const float a2 = alpha2_, viewer_root = viewer_root_;
  for (std::size_t i = 0; i < count; ++i) {
    const float cosine = n.x * cell.x[i] + n.y * cell.y[i] + n.z * cell.z[i];
    form[i] = (cosine > 0.0f ? cosine : 0.0f) * cell.solid_angle[i];
  }
  if (g != n) {
    for (std::size_t i = 0; i < count; ++i) {
      const float cosine = g.x * cell.x[i] + g.y * cell.y[i] + g.z * cell.z[i];
      form[i] = cosine > 0.0f ? form[i] : 0.0f;
    }
  }
  // Simple enough for the compiler to vectorize over nodes.
  for (std::size_t i = 0; i < count; ++i) {
    const float x = cell.x[i], y = cell.y[i], z = cell.z[i];
    const float n_dot_l = n.x * x + n.y * y + n.z * z;
    const float v_dot_l = v.x * x + v.y * y + v.z * z;
    const float nl = n_dot_l > grazing_cosine ? n_dot_l : grazing_cosine;
    // The squared half vector, and its parts along the normal and across it. The part across is
    // computed separately, because a narrow lobe depends on its last bits.
    const float square = 2.0f + 2.0f * v_dot_l;
    const float half2 = square > 1e-12f ? square : 1e-12f;
    const float hx = v.x + x, hy = v.y + y, hz = v.z + z;
    const float cx = n.y * hz - n.z * hy, cy = n.z * hx - n.x * hz, cz = n.x * hy - n.y * hx;
    const float along = n_dot_l + n_dot_v;
    const float stretched = ggx_stretched(a2, cx * cx + cy * cy + cz * cz, along, half2);
    const float shadowing = smith_shadowing(nl, smith_root(nl, a2), clamped_n_dot_v, viewer_root);
    const float weight = schlick_weight(0.5f * std::sqrt(half2));
    lobe[i] = form[i] * ggx_over(a2, stretched, shadowing);
    fresnel[i] = lobe[i] * weight;
    scattered[i] = form[i] * weight;
  }
  const bool sheen = sheen_ > 0.0f;
  for (std::size_t i = 0; i < count && (sheen || stretched_.wider()); ++i) {
    if (!(form[i] > 0.0f)) continue;
    const glm::vec3 to_light(cell.x[i], cell.y[i], cell.z[i]);
    const glm::vec3 half = glm::normalize(v + to_light);
    const BrdfAngles angles{std::max(glm::dot(n, to_light), grazing_cosine), clamped_n_dot_v,
                            glm::dot(n, half), glm::dot(v, half)};
    lobe[i] = form[i] *
              (sheen ? sheen_lobe(sheen_, angles) : stretched_.value(half, to_light, v, angles));
    fresnel[i] = sheen ? 0.0f : lobe[i] * schlick_weight(angles.v_dot_h);
  }
  for (std::size_t i = 0; i < count; ++i) {
    sums_.lobe += lobe[i];
    sums_.fresnel += fresnel[i];
    sums_.scattered += scattered[i];
  }
}

// Integrates over the angle at the receiver instead of the length, which cancels the squared
// distance. The sine of the angle to the line is the cosine of the angle from its foot.
void LightQuadrature::add_segment(const PreparedLight& light) {
  const glm::dvec3 to_middle = light.position - receiver_.position;
  const double half = glm::length(light.half_u);
  if (!(half > 0.0)) return;
  const glm::dvec3 along = light.half_u / half;
  const double s0 = glm::dot(to_middle, along) - half;
  const glm::dvec3 foot = to_middle - glm::dot(to_middle, along) * along;
  const double height = glm::length(foot);
  if (!(height > 0.0)) return;
  double begin = std::atan2(s0, height), end = std::atan2(s0 + 2.0 * half, height);
  // Use only the part above both horizons, where the integrand is smooth.
  for (const glm::dvec3& up : {receiver_.normal, receiver_.geometric}) {
    const double at_foot = glm::dot(foot, up) / height, rising = glm::dot(along, up);
    const double horizon = std::atan2(-at_foot, std::abs(rising));
    if (rising >= 0.0) begin = std::max(begin, horizon);
    if (rising <= 0.0) end = std::min(end, -horizon);
  }
  const auto direction = [&](double angle) {
    return std::cos(angle) * (foot / height) + std::sin(angle) * along;
  };
  constexpr std::array<double, 4> nodes{0.0694318442029737, 0.3300094782075719, 0.6699905217924281,
                                        0.9305681557970263};
  constexpr std::array<double, 4> weights{0.1739274225687269, 0.3260725774312731,
                                          0.3260725774312731, 0.1739274225687269};
  // Four parts per cell.
  LightPatch::Cell cell;
  std::size_t used = 0;
  double from = begin;
  while (from < end) {
    double part = std::min(end - from, static_cast<double>(widest_));
    const double way = static_cast<double>(share_of_way_ * way_to_peak(glm::vec3(direction(from))));
    const double least = static_cast<double>(narrowest_);
    // No part may skip the peak.
    part = std::min(part, std::max(least, 0.5 * way));
    for (std::size_t i = 0; i < 4; ++i) {
      const double angle = from + part * nodes[i];
      const glm::vec3 d(direction(angle));
      cell.x[used] = d.x, cell.y[used] = d.y, cell.z[used] = d.z;
      cell.solid_angle[used++] = static_cast<float>(weights[i] * part * std::cos(angle) / height);
    }
    from = part >= end - from ? end : from + part;
    if (used == LightPatch::cell_nodes || from >= end) {
      for (; used < LightPatch::cell_nodes; ++used) {
        cell.x[used] = cell.x[0], cell.y[used] = cell.y[0], cell.z[used] = cell.z[0];
        cell.solid_angle[used] = 0.0f;
      }
      add_cell(cell);
      used = 0;
    }
  }
}

}  // namespace asos
