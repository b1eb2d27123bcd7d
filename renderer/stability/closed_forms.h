#pragma once

#include "renderer/scene/scene.h"
#include "renderer/stability/scenes.h"

#include <glm/glm.hpp>

#include <vector>

// Expected values of pictures and lights, computed in double precision without the renderer.

namespace asos::stability {

/// Half a unit in the last place of a float near 1: the relative error of one rounding.
inline constexpr double rounding = 5.9604644775390625e-8;
/// Derivation of the bound on the edges in a pixel; see RoundingCase.
inline constexpr const char* rounding_reason =
    "16 roundings of float32 (vertex, eye, ray and its test) move each of the edges in a pixel";
/// Radiance where there is no surface; see renderer/shading/environment.h.
inline constexpr double background = 0.35;

/// A camera and the size of its picture.
struct PictureView {
  Camera camera;
  int width = 1;
  int height = 1;

  /// Returns the pixels per radian in the picture's centre, or per world unit for parallel rays.
  [[nodiscard]] double pixels_per_unit() const;
};

/// Returns the fraction of pixel (x, y) that a flat convex polygon covers, 0 to 1. The polygon is
/// cut by the planes of the pixel's pyramid before its projection, so it may extend behind the eye.
[[nodiscard]] double coverage(const PictureView& view, const std::vector<glm::dvec3>& polygon,
                              int x, int y);

/// Returns the radiance of a pixel with faces that do not hide each other.
[[nodiscard]] double faces_radiance(const PictureView& view, const std::vector<Face>& faces, int x,
                                    int y);

/// Bound on the error of a pixel's coverage in float32. Each of `edges` straight edges in it moves
/// by at most 16 `roundings`: one of the vertex, one of the eye, two of the ray's direction, and
/// twelve of the ray-triangle test. Each rounding is of `lengths` world units (the largest
/// coordinate relative to the scene's centre), seen at `distance`. An edge's length within a pixel
/// is at most the diagonal. The bound is multiplied by `contrast`, and 16 roundings of the sum
/// itself are added.
struct RoundingCase {
  double lengths = 1.0;
  double distance = 1.0;
  int edges = 2;
  double contrast = 1.0;
  double roundings = 16.0;
};
[[nodiscard]] double rounding_bound(const PictureView& view, const RoundingCase& rounded);

/// Lambert's contour sum. Returns the illuminance in lux from a flat convex polygon of one nit at a
/// point at the origin that faces +Y. The polygon is clipped to the horizon, and both its sides
/// emit.
[[nodiscard]] double contour_illuminance(const std::vector<glm::dvec3>& polygon);

/// Returns the part of a convex polygon where dot(normal, p) + offset >= 0 (Sutherland and Hodgman
/// 1974).
[[nodiscard]] std::vector<glm::dvec3> clipped(const std::vector<glm::dvec3>& polygon,
                                              glm::dvec3 normal, double offset);

}  // namespace asos::stability
