#pragma once

#include "renderer/scene/scene.h"
#include "renderer/stability/scenes.h"

#include <glm/glm.hpp>

#include <vector>

// The values that pictures and lights should give, worked out in double precision without the
// renderer.

namespace asos::stability {

/// Half a unit in the last place of a float near 1: the relative error of one rounding.
inline constexpr double rounding = 5.9604644775390625e-8;
/// Where the bound on the edges in a pixel comes from; see RoundingCase.
inline constexpr const char* rounding_reason =
    "16 roundings of float32 (vertex, eye, ray and its test) move each of the edges in a pixel";
/// The radiance of what no surface covers; see renderer/shading/environment.h.
inline constexpr double background = 0.35;

/// A camera and the size of its picture.
struct PictureView {
  Camera camera;
  int width = 1;
  int height = 1;

  /// Pixels an angle of one radian covers in the middle; parallel rays: pixels a world unit covers.
  [[nodiscard]] double pixels_per_unit() const;
};

/// The share of pixel (x, y) that a flat convex polygon covers, 0 to 1. The polygon is cut by the
/// planes of the pixel's pyramid before it is projected, so that it may reach behind the eye.
[[nodiscard]] double coverage(const PictureView& view, const std::vector<glm::dvec3>& polygon,
                              int x, int y);

/// The radiance of a pixel that shows faces of which none hides another.
[[nodiscard]] double faces_radiance(const PictureView& view, const std::vector<Face>& faces, int x,
                                    int y);

/// How far float32 may put a pixel's coverage off: each of `edges` straight edges in it is moved by
/// at most 16 `roundings` (one of the vertex, one of the eye, two of the ray's direction, twelve of
/// the ray's test against the triangle), each of `lengths` world units (the largest coordinate
/// relative to the scene's middle) seen at `distance`; its length within a pixel is at most the
/// diagonal. Times `contrast`, and with 16 roundings of the sum itself.
struct RoundingCase {
  double lengths = 1.0;
  double distance = 1.0;
  int edges = 2;
  double contrast = 1.0;
  double roundings = 16.0;
};
[[nodiscard]] double rounding_bound(const PictureView& view, const RoundingCase& rounded);

/// Lambert's contour sum: the illuminance in lux that a flat convex polygon of one nit gives to a
/// surface at the origin that faces +Y, clipped to its horizon; of either side of the polygon.
[[nodiscard]] double contour_illuminance(const std::vector<glm::dvec3>& polygon);

/// The part of a convex polygon where dot(normal, p) + offset >= 0 (Sutherland and Hodgman 1974).
[[nodiscard]] std::vector<glm::dvec3> clipped(const std::vector<glm::dvec3>& polygon,
                                              glm::dvec3 normal, double offset);

}  // namespace asos::stability
