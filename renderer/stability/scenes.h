#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <limits>
#include <string>
#include <utility>
#include <vector>

// Makers of small scenes for the cases.

namespace asos::stability {

// Numbers that a file may hold and no surface should have.
inline constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
inline constexpr float infinite = std::numeric_limits<float>::infinity();

/// A flat convex surface of one colour that is shown as it is, whatever the light.
struct Face {
  std::vector<glm::dvec3> corners;
  float colour = 1.0f;
};

[[nodiscard]] Material unlit(float grey);
/// A surface without gloss: roughness 1, an index of refraction of 1.
[[nodiscard]] Material matte(float grey);

/// White metal without roughness, which mirrors all.
[[nodiscard]] Material mirror();
/// The same with one curve of defocusing ratios for all colours.
[[nodiscard]] Material mirror(const DfrCurve& curve);

/// Keeps a mesh and places it.
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

/// Gives the scene a light that gives next to nothing, so that no studio's lights are put around
/// it.
void add_dark_light(Scene& scene);

/// Looks from `eye` at `target`, +Y up (+Z where it looks along Y).
[[nodiscard]] Camera look_at(glm::dvec3 eye, glm::dvec3 target, double fov_y_deg);
/// Looks the same way with parallel rays; `height` of the picture in world units.
[[nodiscard]] Camera parallel(glm::dvec3 eye, glm::dvec3 target, double height);

/// A tilted square of side 2 around the origin that faces +Z: an edge of it crosses most pixels of
/// its outline askew. Its corners are multiples of 1/256.
[[nodiscard]] Face tilted_card(float colour = 1.0f);
/// Sees the tilted card, with some of what is around it.
[[nodiscard]] Camera card_camera();

/// A floor, a box and a rectangular light, with corners that are multiples of 1/256, lit and
/// shadowed; the box 1/8 above the floor, so that nothing touches.
[[nodiscard]] Scene still_life();

/// The same scene placed by `similarity`, a uniform scale by `scale` and any move.
[[nodiscard]] Scene transformed(Scene scene, const glm::dmat4& similarity, double scale);

}  // namespace asos::stability
