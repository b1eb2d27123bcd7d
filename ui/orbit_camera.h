#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace asos::ui {

/// A camera that orbits a pivot: azimuth, elevation, roll and distance. Represents every camera of
/// a file exactly. +Y is up. At the poles the azimuth still defines the right vector, so the view
/// does not flip. Non-finite arguments are ignored.
class OrbitCamera {
 public:
  /// Starts from `camera` (relative to World::origin) with the pivot `pivot_distance` ahead of it.
  /// `scene_radius` sets the range of distances. Either becomes 1 if it is not positive.
  void set(const Camera& camera, double pivot_distance, double scene_radius);

  /// Orbits the pivot; the elevation is clamped to straight up and straight down.
  void orbit(double azimuth_rad, double elevation_rad);
  /// Moves the camera so that a point at the pivot's depth follows the pointer; `right` and `down`
  /// are in picture heights.
  void pan(double right, double down);
  /// Multiplies the distance (orthographic: the visible height), within the scene's range.
  void dolly(double factor);
  /// Looks at the pivot from this direction, without roll.
  void turn_to(double azimuth_rad, double elevation_rad);
  /// Changes the projection and keeps the size of objects at the pivot's depth. An orthographic
  /// camera is placed far enough away not to clip the scene. Near and far planes stay where they
  /// are.
  void set_projection(Camera::Type type);
  /// Whether the original camera has a near or a far plane; these move with the camera.
  [[nodiscard]] bool has_planes() const { return lens_.near_depth || lens_.far_depth; }
  /// Sets whether those planes clip the scene. The setting also applies to later cameras.
  void set_planes(bool on);
  [[nodiscard]] bool planes() const { return planes_; }
  /// Sets the full vertical field of view of a perspective camera, in radians between 0 and pi;
  /// other values are ignored.
  void set_fov_y(double fov_y_rad);
  /// Sets the lens of a perspective camera; an invalid lens is ignored.
  void set_lens(const Lens& lens);
  /// Keeps the direction and moves the camera so that the pivot is in the picture's centre.
  void look_at(glm::dvec3 pivot);
  /// Rotates the view about the eye, to the left and up; the elevation is clamped to straight up
  /// and down.
  void look_around(double azimuth_rad, double elevation_rad);
  /// Moves eye and pivot; the distances are in radii of the scene.
  void fly(double right, double up, double forward);
  /// Restores an earlier state; this counts as a change.
  void restore(const OrbitCamera& other);

  [[nodiscard]] Camera camera() const;
  /// The original camera; its placement is not current.
  [[nodiscard]] const Camera& lens() const { return lens_; }
  [[nodiscard]] glm::dvec3 pivot() const { return pivot_; }
  [[nodiscard]] double distance() const { return distance_; }
  [[nodiscard]] glm::dvec3 eye() const { return pivot_ + distance_ * basis().back; }
  /// Grows with every change, so a render can detect that it is out of date.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  struct Basis {
    glm::dvec3 right, up, back;
  };
  [[nodiscard]] Basis basis() const;

  Camera lens_;  // all parameters except the placement
  bool planes_ = true;
  glm::dvec3 pivot_{0.0};
  double distance_ = 1.0;
  double azimuth_rad_ = 0.0;
  double elevation_rad_ = 0.0;
  double roll_rad_ = 0.0;
  double scene_radius_ = 1.0;
  std::uint64_t revision_ = 0;
};

}  // namespace asos::ui
