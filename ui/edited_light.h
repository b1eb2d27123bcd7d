#pragma once

#include "renderer/lights/light_kinds.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace asos::ui {

/// A light as the window edits it. A light that is switched off is left out of the scene.
struct EditedLight {
  Light light;
  bool on = true;
  Light original;  ///< as it was opened: a double click restores its values
  /// Index among the lights that the scene was opened with; -1: it was added.
  int source = -1;

  /// Returns the light as tidy_light normalises it.
  [[nodiscard]] static EditedLight of(Light light);
  bool operator==(const EditedLight&) const = default;
};

[[nodiscard]] bool is_flat(const Light& light);
[[nodiscard]] bool has_position(const Light& light);
/// Returns whether the light is aimed; a line's own direction does not count.
[[nodiscard]] bool has_direction(const Light& light);

/// Centre and radius that sizes and distances of lights are relative to: those of the scene, or of
/// the part in view.
struct SceneSize {
  glm::dvec3 middle{0.0};
  double radius = 1.0;  ///< above 0

  /// Bounding sphere of a box; the unit sphere for an empty box.
  [[nodiscard]] static SceneSize of(const Box& bounds);
};

/// Half-width of a light that had no size, per unit of distance to the point that it lights. Its
/// penumbrae are wide enough to see.
inline constexpr double usual_half_size = 0.05;

/// Returns the light as another kind, with its place, orientation and size, and with the same
/// brightness in the centre of `scene`. A light without a size gets usual_half_size. A directional
/// light comes from outside the scene, or from its position if it `has_place`.
[[nodiscard]] Light as_kind(const Light& light, LightKind kind, const SceneSize& scene,
                            bool has_place = false);

/// Emitting area of a flat light; 0 for other lights.
[[nodiscard]] double area_of(const Light& light);

/// Orientation of a light (for a linear light, of its line): compass angle from +Z to +X, elevation
/// above the horizon, and roll about that direction. At a pole the roll is part of the compass
/// angle.
struct LightTurn {
  double azimuth_rad = 0.0;
  double elevation_rad = 0.0;
  double roll_rad = 0.0;
};
[[nodiscard]] LightTurn turn_of(const Light& light);
void turn_light(Light& light, const LightTurn& turn);

/// Moves the light together with its outlines.
void move_light(Light& light, glm::dvec3 by);

/// Rotates the light about the vertical axis through a point, counter-clockwise seen from above.
void carry_around(Light& light, glm::dvec3 about, double by_rad);

/// Distance from a polygon's position to its farthest corner; the setter scales the outlines.
[[nodiscard]] double polygon_radius(const Light& light);
void set_polygon_radius(Light& light, double radius);

/// Predefined outlines of a polygon light.
enum class PolygonShape { triangle, hexagon, star, frame };
inline constexpr std::size_t polygon_shape_count = 4;
void set_polygon_shape(Light& light, PolygonShape shape);
/// Returns the predefined outline that a polygon has; none: it has another one.
[[nodiscard]] std::optional<PolygonShape> polygon_shape(const Light& light);

/// Scales the intensity of a flat light, whose area was `area_before`, to keep its power. Other
/// lights are left alone: their units do not depend on their size.
void keep_power(Light& light, double area_before);

/// Normalises a file's light for editing: colour components of at most 1, and a polygon's position
/// at its centre. Its emission does not change.
void tidy_light(Light& light);

/// The lights that are on.
[[nodiscard]] std::vector<Light> lights_on(const std::vector<EditedLight>& lights);
/// The light as a file stores it. If it is off, its intensity is 0 and its colour is multiplied by
/// the intensity that it has when it is on.
[[nodiscard]] Light stored_light(const EditedLight& edited);

}  // namespace asos::ui
