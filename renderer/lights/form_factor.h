#pragma once

#include "renderer/lights/receiver.h"

#include <glm/glm.hpp>

#include <span>

// Projected solid angles: the irradiance that a Lambertian light of radiance 1 gives, 0 to pi.
// Where no receiver is given, everything is relative to its position and both its normals are
// `normal`. Double precision; lights from 1e-4 to 1e4 times their distance in size are good to 1e-5
// of the result. Vectors called unit must be; other input only has to be finite.

namespace asos {

/// One directed side of Lambert's contour sum (Lambert 1760; Baum, Rushmeier and Winget 1989): half
/// the angle between a and b times the cosine of their plane's normal to `normal`. The sum around a
/// region above the horizon is its projected solid angle: positive if the sides run
/// counter-clockwise as seen from the receiver, negative if they run clockwise. A side through the
/// receiver counts nothing.
[[nodiscard]] double contour_side(glm::dvec3 a, glm::dvec3 b, glm::dvec3 normal);

/// A flat polygon, clipped to the horizon of `normal`; concave ones, too. Positive if the corners
/// run counter-clockwise as seen from the receiver, negative if clockwise: holes run the other way
/// round and their (negative) form is added. The receiver must not lie in the polygon's plane.
[[nodiscard]] double polygon_form(std::span<const glm::dvec3> corners, glm::dvec3 normal);
/// The same with the corners in the world, clipped to both horizons of `receiver`.
[[nodiscard]] double polygon_form(std::span<const glm::dvec3> corners, const Receiver& receiver);

/// A flat disk, seen from the side that `facing` (unit) points to, clipped to the horizon; 0 from
/// the other side and from its plane.
[[nodiscard]] double disk_form(glm::dvec3 centre, glm::dvec3 facing, double radius,
                               glm::dvec3 normal);
/// The same with the disk in the world, clipped to both horizons of `receiver`.
[[nodiscard]] double disk_form(glm::dvec3 centre, glm::dvec3 facing, double radius,
                               const Receiver& receiver);

/// A ball, clipped to the horizon; pi for a receiver inside of it.
[[nodiscard]] double ball_form(glm::dvec3 centre, double radius, glm::dvec3 normal);
/// The same with the ball in the world, clipped to both horizons of `receiver`.
[[nodiscard]] double ball_form(glm::dvec3 centre, double radius, const Receiver& receiver);

/// All directions within an angle of `axis` (unit) below 90 degrees, given by its sine and cosine,
/// clipped to both horizons of `receiver`: a sun.
[[nodiscard]] double cone_form(glm::dvec3 axis, double sine, double cosine,
                               const Receiver& receiver);

/// The irradiance from a straight line between two points in the world, of one candela a metre,
/// clipped to both horizons of `receiver`. `lambertian`: a thin tube, whose candelas go with the
/// sine of the angle to the line; otherwise each of its points shines the same in all directions.
/// 0 for a receiver on the line itself.
[[nodiscard]] double line_form(glm::dvec3 begin, glm::dvec3 end, bool lambertian,
                               const Receiver& receiver);

}  // namespace asos
