#include "renderer/shading/ltc.h"

#include "renderer/lights/light_math.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/ltc_table.h"
#include "renderer/shading/viewed_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

/// Where a view lies among the table's entries: the least of four, and the shares of those next to
/// it.
struct TablePlace {
  std::size_t first = 0;
  double by_cosine = 0.0;
  double by_roughness = 0.0;
};

double clamped_roughness(double roughness) {
  return std::clamp(roughness, static_cast<double>(roughness_floor), 1.0);
}
double clamped_cosine(double n_dot_v) {
  return std::clamp(n_dot_v, static_cast<double>(grazing_cosine), 1.0);
}

TablePlace place_of(double cosine, double roughness) {
  static_assert(ltc_least_cosine == static_cast<double>(grazing_cosine));
  const double share = (cosine - ltc_least_cosine) / (1.0 - ltc_least_cosine);
  // The inverse of t * t * (3 - 2 t).
  const double t = 0.5 - std::sin(std::asin(1.0 - 2.0 * share) / 3.0);
  const double c = std::clamp(t, 0.0, 1.0) * static_cast<double>(ltc_cosines - 1);
  const double floor = roughness_floor;
  const double r = (roughness - floor) / (1.0 - floor) * static_cast<double>(ltc_roughnesses - 1);
  const std::size_t row = std::min(static_cast<std::size_t>(r), ltc_roughnesses - 2);
  const std::size_t column = std::min(static_cast<std::size_t>(c), ltc_cosines - 2);
  return {row * ltc_cosines + column, c - static_cast<double>(column),
          r - static_cast<double>(row)};
}

double interpolate(const LtcTable& table, const TablePlace& at, float LtcEntry::*member) {
  const LtcEntry* const e = table.data() + at.first;
  const auto row = [&](const LtcEntry* entry) {
    return std::lerp(static_cast<double>(entry[0].*member), static_cast<double>(entry[1].*member),
                     at.by_cosine);
  };
  return std::lerp(row(e), row(e + ltc_cosines), at.by_roughness);
}

/// A unit frame at a surface: x leads where the view is mirrored to, z is the normal.
struct ViewFrame {
  glm::dvec3 x, y, z;
  double cosine, sine;  ///< of the angle to the viewer
};

ViewFrame view_frame(glm::dvec3 normal, glm::dvec3 to_viewer) {
  ViewFrame frame;
  frame.z = normal;
  frame.cosine = clamped_cosine(glm::dot(normal, to_viewer));
  frame.sine = std::sqrt((1.0 - frame.cosine) * (1.0 + frame.cosine));
  const glm::dvec3 along = glm::dot(normal, to_viewer) * normal - to_viewer;
  const double length = glm::length(along);
  frame.x = length > 1e-9 ? along / length : any_perpendicular(normal);
  frame.y = glm::cross(frame.z, frame.x);
  return frame;
}

double lobe_norm(const TablePlace& at) {
  return interpolate(ltc_of_lobe, at, &LtcEntry::norm);
}
double fresnel_norm(const TablePlace& at) {
  const double root = interpolate(ltc_of_fresnel, at, &LtcEntry::norm);
  return root * root * root * root * root;
}

/// Without its weight's norm.
Ltc ltc_from(const LtcTable& table, const TablePlace& at, double alpha, const ViewFrame& frame,
             const Receiver& receiver) {
  const double tilt = alpha * interpolate(table, at, &LtcEntry::tilt);
  const double up = alpha / interpolate(table, at, &LtcEntry::width);
  const double stretch = interpolate(table, at, &LtcEntry::stretch);
  const double lean = interpolate(table, at, &LtcEntry::lean) / frame.cosine;
  // The lobe's axis, and what is at right angles to it in the plane of view.
  const double axis_x = frame.sine * std::cos(tilt) + frame.cosine * std::sin(tilt);
  const double axis_z = frame.cosine * std::cos(tilt) - frame.sine * std::sin(tilt);
  const glm::dvec3 axis = axis_x * frame.x + axis_z * frame.z;
  const glm::dvec3 side = axis_z * frame.x - axis_x * frame.z;

  Ltc ltc;
  ltc.to_cosine = glm::transpose(glm::dmat3(side, frame.y / stretch, up * (axis + lean * side)));
  const auto transformed_normal = [&](glm::dvec3 normal) {
    const double along = glm::dot(normal, axis);
    return glm::dvec3(glm::dot(normal, side) - lean * along, stretch * glm::dot(normal, frame.y),
                      along / up);
  };
  const glm::dvec3 horizon = transformed_normal(receiver.normal);
  ltc.horizons.add(horizon);
  if (receiver.geometric != receiver.normal)
    ltc.horizons.add(transformed_normal(receiver.geometric));
  // All of the lobe lies above the normal's horizon: the cosine's part there stands for it.
  const double above = 0.5 * (1.0 + horizon.z / glm::length(horizon));
  ltc.weight = std::numbers::inv_pi / above;
  return ltc;
}

}  // namespace

LtcPair ltc_of(const Receiver& receiver, glm::dvec3 to_viewer, double roughness) {
  const ViewFrame frame = view_frame(receiver.normal, to_viewer);
  const double rough = clamped_roughness(roughness);
  const TablePlace at = place_of(frame.cosine, rough);
  const double alpha = rough * rough;
  LtcPair pair{ltc_from(ltc_of_lobe, at, alpha, frame, receiver),
               ltc_from(ltc_of_fresnel, at, alpha, frame, receiver)};
  pair.lobe.weight *= lobe_norm(at);
  pair.fresnel.weight *= fresnel_norm(at);
  return pair;
}

LtcError ltc_error(double n_dot_v, double roughness) {
  const TablePlace at = place_of(clamped_cosine(n_dot_v), clamped_roughness(roughness));
  return {interpolate(ltc_of_lobe, at, &LtcEntry::error),
          interpolate(ltc_of_fresnel, at, &LtcEntry::error)};
}

LtcNorms ltc_norms(double n_dot_v, double roughness) {
  const TablePlace at = place_of(clamped_cosine(n_dot_v), clamped_roughness(roughness));
  return {lobe_norm(at), fresnel_norm(at)};
}

}  // namespace asos
