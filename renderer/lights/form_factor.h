#pragma once

#include "renderer/lights/receiver.h"

#include <glm/glm.hpp>

#include <span>

// Projected solid angles: the irradiance from a Lambertian light of radiance 1, 0 to pi. Without a
// receiver argument, places are relative to the receiver and both its normals are `normal`. Double
// precision: for lights from 1e-4 to 1e4 times their distance in size, the relative error is below
// 1e-5. Vectors called unit must be; other input only has to be finite.

namespace asos {

/// Returns one directed side of Lambert's contour sum (Lambert 1760; Baum, Rushmeier and Winget
/// 1989): half the angle between a and b times the cosine between their plane's normal and
/// `normal`. The sum around a region above the horizon is its projected solid angle. It is positive
/// if the sides run counter-clockwise as seen from the receiver, and negative if they run
/// clockwise. A side through the receiver counts as 0.
[[nodiscard]] double contour_side(glm::dvec3 a, glm::dvec3 b, glm::dvec3 normal);

/// Returns the form of a flat polygon, also a concave one, clipped to the horizon of `normal`.
/// Positive if the corners run counter-clockwise as seen from the receiver, negative if clockwise.
/// Holes run the other way, and their (negative) form is added. The receiver must not lie in the
/// polygon's plane.
[[nodiscard]] double polygon_form(std::span<const glm::dvec3> corners, glm::dvec3 normal);
/// Returns polygon_form for corners in the world, clipped to both horizons of `receiver`.
[[nodiscard]] double polygon_form(std::span<const glm::dvec3> corners, const Receiver& receiver);

/// Returns the form of a flat disk, from the side to which `facing` (unit) points, clipped to the
/// horizon. 0 from the other side and from its plane.
[[nodiscard]] double disk_form(glm::dvec3 centre, glm::dvec3 facing, double radius,
                               glm::dvec3 normal);
/// Returns disk_form for a disk in the world, clipped to both horizons of `receiver`.
[[nodiscard]] double disk_form(glm::dvec3 centre, glm::dvec3 facing, double radius,
                               const Receiver& receiver);

/// Returns the form of a ball, clipped to the horizon; pi for a receiver inside of it.
[[nodiscard]] double ball_form(glm::dvec3 centre, double radius, glm::dvec3 normal);
/// Returns ball_form for a ball in the world, clipped to both horizons of `receiver`.
[[nodiscard]] double ball_form(glm::dvec3 centre, double radius, const Receiver& receiver);

/// Returns the form of a capsule, all points within a radius of the segment between `begin` and
/// `end` in the world, clipped to both horizons of `receiver`.
[[nodiscard]] double capsule_form(glm::dvec3 begin, glm::dvec3 end, double radius,
                                  const Receiver& receiver);

/// Returns the form of a sun: all directions within an angle below 90 degrees of `axis` (unit),
/// given by its sine and cosine, clipped to both horizons of `receiver`.
[[nodiscard]] double cone_form(glm::dvec3 axis, double sine, double cosine,
                               const Receiver& receiver);

/// Returns the irradiance from a straight line between two points in the world, of one candela per
/// metre, clipped to both horizons of `receiver`. `lambertian`: a thin tube, whose candelas vary
/// with the sine of the angle to the line; otherwise each point emits equally in all directions. 0
/// for a receiver on the line itself.
[[nodiscard]] double line_form(glm::dvec3 begin, glm::dvec3 end, bool lambertian,
                               const Receiver& receiver);

}  // namespace asos
