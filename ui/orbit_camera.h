#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace asos::ui {

/// A camera that circles a pivot: azimuth, elevation and roll about it, and a distance. Every file
/// camera can be taken over exactly. +Y is up; at the poles the picture's right stays defined by
/// the azimuth, so nothing flips. Arguments that are not finite are ignored.
class OrbitCamera {
 public:
  /// Takes over `camera` (relative to World::origin) and orbits the point `pivot_distance` ahead of
  /// it. `scene_radius` sets the range of distances; both fall back to 1 where they are not
  /// positive.
  void set(const Camera& camera, double pivot_distance, double scene_radius);

  /// Turns about the pivot; the elevation stops at straight above and straight below.
  void orbit(double azimuth_rad, double elevation_rad);
  /// Moves so that what lies at the pivot's depth follows a pointer that went `right` and `down`,
  /// in heights of the picture.
  void pan(double right, double down);
  /// Multiplies the distance (orthographic: the height seen), within the scene's range.
  void dolly(double factor);
  /// Looks at the pivot from this side, level.
  void turn_to(double azimuth_rad, double elevation_rad);
  /// Shows what lies at the pivot's depth as large as before. An orthographic camera stands far
  /// enough away that it cuts nothing of the scene off. Near and far planes stay where they are.
  void set_projection(Camera::Type type);
  /// Whether the camera that was taken over has a near or a far plane; they move with it.
  [[nodiscard]] bool has_planes() const { return lens_.near_depth || lens_.far_depth; }
  /// Whether these cut the scene; off stays off for cameras that are taken over later.
  void set_planes(bool on);
  [[nodiscard]] bool planes() const { return planes_; }
  /// Full vertical field of view of a perspective, between 0 and pi; others are ignored.
  void set_fov_y(double fov_y_rad);
  /// Sets the lens of a perspective. A lens out of range is ignored.
  void set_lens(const Lens& lens);
  /// Keeps the direction and puts the pivot into the picture's middle.
  void look_at(glm::dvec3 pivot);
  /// Turns the view where it stands: to the left and up; stops at straight up and straight down.
  void look_around(double azimuth_rad, double elevation_rad);
  /// Moves eye and pivot by so many of the scene's radii.
  void fly(double right, double up, double forward);
  /// Back to what another camera was, as a change like any other.
  void restore(const OrbitCamera& other);

  [[nodiscard]] Camera camera() const;
  /// The camera that was taken over, but for its place.
  [[nodiscard]] const Camera& lens() const { return lens_; }
  [[nodiscard]] glm::dvec3 pivot() const { return pivot_; }
  [[nodiscard]] double distance() const { return distance_; }
  [[nodiscard]] glm::dvec3 eye() const { return pivot_ + distance_ * basis().back; }
  /// Grows with every change, so that a render knows when it is out of date.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  struct Basis {
    glm::dvec3 right, up, back;
  };
  [[nodiscard]] Basis basis() const;

  Camera lens_;  // everything but the placement
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
