#include "ui/orbit_camera.h"

#include "renderer/geometry/coordinates.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos::ui {

namespace {

// Limits of the distance from the pivot, in radii of the scene.
constexpr double least_distance = 1e-4;
constexpr double farthest = 1e3;

double positive_or_one(double value) {
  return std::isfinite(value) && value > 0.0 ? value : 1.0;
}

}  // namespace

void OrbitCamera::set(const Camera& camera, double pivot_distance, double scene_radius) {
  const glm::dvec3 right(camera.world_from_camera[0]);
  const glm::dvec3 back(camera.world_from_camera[2]);
  const glm::dvec3 eye(camera.world_from_camera[3]);
  lens_ = camera;
  scene_radius_ = positive_or_one(scene_radius);
  distance_ = positive_or_one(pivot_distance);
  pivot_ = eye - distance_ * back;

  // The azimuth follows from the view direction or, at a pole, from the camera's right vector. The
  // rest is roll.
  const double horizontal = std::hypot(back.x, back.z);
  elevation_rad_ = std::atan2(back.y, horizontal);
  azimuth_rad_ = horizontal > 1e-9 ? std::atan2(back.x, back.z) : std::atan2(-right.z, right.x);
  roll_rad_ = 0.0;
  const Basis level = basis();
  roll_rad_ = std::atan2(glm::dot(right, level.up), glm::dot(right, level.right));
  ++revision_;
}

void OrbitCamera::orbit(double azimuth_rad, double elevation_rad) {
  if (!std::isfinite(azimuth_rad) || !std::isfinite(elevation_rad)) return;
  constexpr double pole = std::numbers::pi / 2.0;
  azimuth_rad_ = std::remainder(azimuth_rad_ + azimuth_rad, 2.0 * std::numbers::pi);
  elevation_rad_ = std::clamp(elevation_rad_ + elevation_rad, -pole, pole);
  ++revision_;
}

void OrbitCamera::turn_to(double azimuth_rad, double elevation_rad) {
  if (!std::isfinite(azimuth_rad) || !std::isfinite(elevation_rad)) return;
  azimuth_rad_ = elevation_rad_ = roll_rad_ = 0.0;
  orbit(azimuth_rad, elevation_rad);
}

void OrbitCamera::set_projection(Camera::Type type) {
  if (type == lens_.type) return;
  const double height_to_distance = 2.0 * std::tan(0.5 * lens_.fov_y_rad);
  const double before = distance_;
  if (type == Camera::Type::orthographic) {
    lens_.height = height_to_distance * distance_;
    distance_ = std::max(distance_, glm::length(pivot_) + 2.0 * scene_radius_);
  } else {
    distance_ = lens_.height / height_to_distance;
  }
  lens_.type = type;
  if (lens_.near_depth) *lens_.near_depth += distance_ - before;
  if (lens_.far_depth) *lens_.far_depth += distance_ - before;
  if (lens_.near_depth && *lens_.near_depth < 0.0) lens_.near_depth.reset();
  if (lens_.far_depth && *lens_.far_depth <= 0.0) lens_.far_depth.reset();
  ++revision_;
}

void OrbitCamera::set_planes(bool on) {
  if (on == planes_) return;
  planes_ = on;
  ++revision_;
}

void OrbitCamera::set_fov_y(double fov_y_rad) {
  if (!(fov_y_rad > 0.0 && fov_y_rad < std::numbers::pi)) return;
  lens_.fov_y_rad = fov_y_rad;
  ++revision_;
}

void OrbitCamera::set_lens(const Lens& lens) {
  if (lens == lens_.lens || !validate_lens(lens).empty()) return;
  lens_.lens = lens;
  ++revision_;
}

void OrbitCamera::pan(double right, double down) {
  if (!std::isfinite(right) || !std::isfinite(down)) return;
  const double height = lens_.type == Camera::Type::perspective
                            ? 2.0 * distance_ * std::tan(0.5 * lens_.fov_y_rad)
                            : lens_.height;
  const Basis b = basis();
  pivot_ = brought_within_reach(pivot_ + height * (down * b.up - right * b.right));
  ++revision_;
}

void OrbitCamera::dolly(double factor) {
  if (!std::isfinite(factor) || factor <= 0.0) return;
  double& size = lens_.type == Camera::Type::perspective ? distance_ : lens_.height;
  // A camera from a file may start outside the range. It may move back but not farther out.
  const double lo = std::min(size, least_distance * scene_radius_);
  const double hi = std::max(size, farthest * scene_radius_);
  size = std::clamp(size * factor, lo, hi);
  ++revision_;
}

void OrbitCamera::look_at(glm::dvec3 pivot) {
  if (!std::isfinite(pivot.x + pivot.y + pivot.z)) return;
  pivot_ = brought_within_reach(pivot);
  ++revision_;
}

void OrbitCamera::look_around(double azimuth_rad, double elevation_rad) {
  const glm::dvec3 stands = eye();
  const std::uint64_t before = revision_;
  // Raising the eye around the pivot tilts the view down, so the elevation is negated.
  orbit(azimuth_rad, -elevation_rad);
  if (revision_ != before) pivot_ = stands - distance_ * basis().back;
}

void OrbitCamera::fly(double right, double up, double forward) {
  if (!std::isfinite(right + up + forward)) return;
  const Basis b = basis();
  pivot_ = brought_within_reach(pivot_ +
                                scene_radius_ * (right * b.right + up * b.up - forward * b.back));
  ++revision_;
}

void OrbitCamera::restore(const OrbitCamera& other) {
  const std::uint64_t next = std::max(revision_, other.revision_) + 1;
  *this = other;
  revision_ = next;
}

Camera OrbitCamera::camera() const {
  Camera camera = planes_ ? lens_ : lens_.without_planes();
  if (camera.type != Camera::Type::perspective) camera.lens = {};
  const Basis b = basis();
  camera.world_from_camera =
      glm::dmat4(glm::dvec4(b.right, 0.0), glm::dvec4(b.up, 0.0), glm::dvec4(b.back, 0.0),
                 glm::dvec4(pivot_ + distance_ * b.back, 1.0));
  return camera;
}

// Built from the angles alone: a cross product with "up" would vanish at the poles.
OrbitCamera::Basis OrbitCamera::basis() const {
  const double sa = std::sin(azimuth_rad_), ca = std::cos(azimuth_rad_);
  const double se = std::sin(elevation_rad_), ce = std::cos(elevation_rad_);
  const double sr = std::sin(roll_rad_), cr = std::cos(roll_rad_);
  const glm::dvec3 level_right(ca, 0.0, -sa);
  const glm::dvec3 level_up(-sa * se, ce, -ca * se);
  return {cr * level_right + sr * level_up, cr * level_up - sr * level_right,
          glm::dvec3(sa * ce, se, ca * ce)};
}

}  // namespace asos::ui
