#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <string>

namespace asos {

/// A thin lens of a perspective camera. Points of the focus plane are sharp; others are blurred
/// over a circle of confusion that has the shape of the aperture.
struct Lens {
  static constexpr int fewest_blades = 3, most_blades = 32;
  static constexpr double smallest_f_stop = 0.1, largest_f_stop = 1e6;
  /// Height of the sensor that f-stops refer to, in metres.
  static constexpr double sensor_height = 0.024;

  double radius = 0.0;          ///< of the aperture, in world units; 0: a pinhole
  std::optional<double> focus;  ///< depth of the focus plane along the view axis; none: automatic
  int blades = 0;               ///< corners of the aperture, on the circle of `radius`; 0: a disk
  double turn_rad = 0.0;        ///< counter-clockwise turn of the first corner from the right

  [[nodiscard]] bool blurs() const { return radius > 0.0; }
  bool operator==(const Lens&) const = default;
};

/// Where a camera's ray starts: a point of the lens, in world units to the right and up from its
/// centre.
struct ExposurePoint {
  glm::dvec2 lens{0.0};
};

/// Returns the first property of a lens that is out of range, in the words of saved pictures;
/// empty: none.
[[nodiscard]] std::string validate_lens(const Lens& lens);

/// Maps the unit square to the aperture; equal areas go to equal areas, and neighbours to
/// neighbours. Disks are mapped concentrically (Shirley and Chiu 1997, "A low distortion map
/// between disk and square"), and polygons by way of the disk.
[[nodiscard]] glm::dvec2 point_on_aperture(const Lens& lens, glm::dvec2 uv);

/// Returns the aperture's area as a fraction of its circle's area.
[[nodiscard]] double aperture_share(const Lens& lens);

/// Returns the variance, along an axis, of uniform points on an aperture of radius 1.
[[nodiscard]] double aperture_variance(const Lens& lens);

/// Returns the radius of the aperture, in metres, at f/`f_stop`: half of the focal length over
/// `f_stop`. The focal length is that of the field of view on a sensor of Lens::sensor_height.
[[nodiscard]] double aperture_of_f_stop(double f_stop, double fov_y_rad);
/// Returns the f-stop of a radius in metres.
[[nodiscard]] double f_stop_of_aperture(double radius, double fov_y_rad);

}  // namespace asos
