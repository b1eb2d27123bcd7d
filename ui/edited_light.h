#pragma once

#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace asos::ui {

/// A light as the window edits it: one that is off is left out of the scene.
struct EditedLight {
  Light light;
  bool on = true;
  Light original;  ///< as it came; what a double click goes back to

  /// Tidied.
  [[nodiscard]] static EditedLight of(Light light);
};

/// The window's kinds of lights: Light's types, with a ball distinguished from a point.
enum class LightKind { point, sphere, spot, directional, linear, rectangle, disk, polygon };
inline constexpr std::size_t light_kind_count = 8;

[[nodiscard]] LightKind kind_of(const Light& light);

/// The scale by which sizes and distances are measured: of the scene, or of what is looked at.
struct SceneSize {
  glm::dvec3 middle{0.0};
  double radius = 1.0;  ///< above 0

  /// The size of a box; an empty one counts as the unit ball.
  [[nodiscard]] static SceneSize of(const Box& bounds);
};

/// Half the width that a light without a size gets, per distance from the point it lights. Its
/// penumbrae are wide enough to see.
inline constexpr double usual_half_size = 0.05;

/// The light as another kind: in the same place, turned the same way, of the same size, and as
/// bright as before in the middle of `scene`. One that had no size gets one of usual_half_size.
[[nodiscard]] Light as_kind(const Light& light, LightKind kind, const SceneSize& scene);

/// Area of the side that shines: flat lights, 0 for others.
[[nodiscard]] double area_of(const Light& light);

/// How a light is turned: where it shines to (linear: where it runs to) as compass angle from +Z to
/// +X and height above the horizon, and how far it is rolled about that. At a pole the roll counts
/// as compass angle.
struct LightTurn {
  double azimuth_rad = 0.0;
  double elevation_rad = 0.0;
  double roll_rad = 0.0;
};
[[nodiscard]] LightTurn turn_of(const Light& light);
void turn_light(Light& light, const LightTurn& turn);

/// Moves it with its outlines.
void move_light(Light& light, glm::dvec3 by);

/// Carries it about the vertical through a point, counter-clockwise as seen from above.
void carry_around(Light& light, glm::dvec3 about, double by_rad);

/// The distance of a polygon's farthest corner from its position, and the way to change it.
[[nodiscard]] double polygon_radius(const Light& light);
void set_polygon_radius(Light& light, double radius);

/// Outlines that a polygon may be given.
enum class PolygonShape { triangle, hexagon, star, frame };
inline constexpr std::size_t polygon_shape_count = 4;
void set_polygon_shape(Light& light, PolygonShape shape);
/// Which of them a polygon has; none: another outline.
[[nodiscard]] std::optional<PolygonShape> polygon_shape(const Light& light);

/// Scales the intensity of a flat light whose area was `area_before`, so that its power stays. The
/// units of other lights do not depend on their size.
void keep_power(Light& light, double area_before);

/// Brings a file's light into the form that the window edits: a colour of 1 at most, and a
/// polygon's position in its middle. It shines as before.
void tidy_light(Light& light);

/// The lights that are on.
[[nodiscard]] std::vector<Light> lights_on(const std::vector<EditedLight>& lights);

}  // namespace asos::ui
