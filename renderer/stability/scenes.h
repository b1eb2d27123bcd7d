#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <limits>
#include <string>
#include <utility>
#include <vector>

// Helpers that make small scenes for the cases.

namespace asos::stability {

// Values that a file may contain and no surface should have.
inline constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
inline constexpr float infinite = std::numeric_limits<float>::infinity();

/// A flat convex surface of one colour that does not depend on light.
struct Face {
  std::vector<glm::dvec3> corners;
  float colour = 1.0f;
};

[[nodiscard]] Material unlit(float grey);
/// A surface without gloss: roughness 1, an index of refraction of 1.
[[nodiscard]] Material matte(float grey);

/// White metal without roughness, which reflects everything.
[[nodiscard]] Material mirror();
/// Returns a mirror with one curve of defocusing ratios for all colours.
[[nodiscard]] Material mirror(const DfrCurve& curve);

/// Stores a mesh and places it.
void place(Scene& scene, Mesh mesh, const Material& material,
           const glm::dmat4& world_from_mesh = glm::dmat4(1.0));
[[nodiscard]] Mesh mesh_of(const std::vector<glm::dvec3>& convex_corners);
void add(Scene& scene, const Face& face);
/// Places an analytic shape.
void add_shape(Scene& scene, const Shape& shape, const Material& material,
               const glm::dmat4& world_from_shape = glm::dmat4(1.0));
[[nodiscard]] Shape ball_shape(double radius);
/// A cone where `top` is 0.
[[nodiscard]] Shape cylinder_shape(double height, double bottom, double top);
[[nodiscard]] Scene scene_of(const std::vector<Face>& faces, const Camera& camera);

/// Adds a light with almost no power, so that the default lighting is not used.
void add_dark_light(Scene& scene);

/// Looks from `eye` at `target`, +Y up (+Z where it looks along Y).
[[nodiscard]] Camera look_at(glm::dvec3 eye, glm::dvec3 target, double fov_y_deg);
/// Looks the same way with parallel rays; `height` of the picture in world units.
[[nodiscard]] Camera parallel(glm::dvec3 eye, glm::dvec3 target, double height);

/// A tilted square of side 2 around the origin that faces +Z. Most pixels of its outline contain
/// one oblique edge. Its corners are multiples of 1/256.
[[nodiscard]] Face tilted_card(float colour = 1.0f);
/// A camera that shows the tilted card and some of its surroundings.
[[nodiscard]] Camera card_camera();

/// A floor, a box and a rectangular light, with shadows. Corners are multiples of 1/256, and the
/// box is 1/8 above the floor, so that nothing touches.
[[nodiscard]] Scene still_life();

/// Returns the scene placed by `similarity`, a uniform scale by `scale` and a move. Lights are not
/// turned.
[[nodiscard]] Scene transformed(Scene scene, const glm::dmat4& similarity, double scale);

}  // namespace asos::stability
