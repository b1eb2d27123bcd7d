#pragma once

#include "renderer/scene/scene.h"
#include "renderer/settings/names.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace asos {

/// Kinds of lights in the window: the types of Light, with a sphere light separate from a point
/// light. docs/light-kinds.md describes how to add one.
enum class LightKind { point, sphere, spot, directional, linear, rectangle, disk, polygon, count };
inline constexpr auto light_kind_count = static_cast<std::size_t>(LightKind::count);

/// A size of a light, with its control: a radius, an angle, or the side whose half is a vector.
/// Without a member it is the radius of the outlines.
struct LightSize {
  const char* name = nullptr;  ///< null: the kind has no such size
  const char* tooltip = nullptr;
  double Light::*value = nullptr;
  glm::dvec3 Light::*half = nullptr;
  bool may_be_zero = false;                       ///< of a length
  double least = 0.0, most = 0.0, initial = 0.0;  ///< of an angle, in degrees

  [[nodiscard]] constexpr bool is_angle() const { return most > 0.0; }
};

namespace light_sizes {

inline constexpr LightSize radius{
    "Radius", "Radius in metres. Larger lights cast softer shadows. Ctrl+click to type a value.",
    &Light::radius};
inline constexpr LightSize radius_or_none{
    "Radius", "Radius in metres. 0: sharp shadows. Ctrl+click to type a value.", &Light::radius,
    nullptr, true};
inline constexpr LightSize length{.name = "Length",
                                  .tooltip = "Length in metres. Ctrl+click to type a value.",
                                  .half = &Light::half_u};
inline constexpr LightSize width{
    .name = "Width",
    .tooltip = "Side of the rectangle in metres. Ctrl+click to type a value.",
    .half = &Light::half_u};
inline constexpr LightSize height{
    .name = "Height",
    .tooltip = "Side of the rectangle in metres. Ctrl+click to type a value.",
    .half = &Light::half_v};
inline constexpr LightSize outlines{
    "Radius", "Distance from centre to farthest corner, in metres. Ctrl+click to type a value."};
inline constexpr LightSize sun{
    .name = "Sun's angle",
    .tooltip = "Apparent size of the sun in degrees. 0: sharp shadows. The real sun has 0.5.",
    .value = &Light::angular_diameter_rad,
    .most = 90.0};
inline constexpr LightSize cone{.name = "Cone",
                                .tooltip = "Half angle of the cone in degrees.",
                                .value = &Light::outer_cone_rad,
                                .least = 0.1,
                                .most = 89.9,
                                .initial = 45.0};

}  // namespace light_sizes

/// A kind of light. A light that changes to it gets the first size, and both sides if it has two.
struct LightKindRow {
  Light::Type type;
  const char* type_name;  ///< in options, reports and saved pictures
  const char* name;       ///< in the window
  const char* tooltip;
  LightSize size{}, second{};

  [[nodiscard]] constexpr bool has_cone() const { return second.value == &Light::outer_cone_rad; }
  [[nodiscard]] constexpr bool has_outlines() const {
    return size.name && !size.value && !size.half;
  }
  /// Returns whether the light lies along half_u instead of having a direction.
  [[nodiscard]] constexpr bool line() const { return size.half && !second.half; }
  /// Returns whether the light may be rotated about its direction.
  [[nodiscard]] constexpr bool rolls() const { return second.half || has_outlines(); }
};

/// One row per kind, in the enumeration's order.
inline constexpr std::array light_kinds{
    LightKindRow{Light::Type::point, "point", "Point",
                 "Point light: sharp shadows. Unit: candela."},
    LightKindRow{Light::Type::point, "point", "Sphere",
                 "Sphere light: soft shadows. Unit: candela.", light_sizes::radius},
    LightKindRow{Light::Type::spot, "spot", "Spot",
                 "Point or sphere light limited to a cone. Unit: candela.",
                 light_sizes::radius_or_none, light_sizes::cone},
    LightKindRow{Light::Type::directional, "directional", "Directional",
                 "Parallel light, such as the sun. Unit: lux.", light_sizes::sun},
    LightKindRow{Light::Type::linear, "linear", "Line",
                 "Line light. Unit: candela of the whole line, seen from the side.",
                 light_sizes::length, light_sizes::radius_or_none},
    LightKindRow{Light::Type::rectangle, "rectangle", "Rectangle",
                 "Flat rectangle, one-sided. Unit: cd/m².", light_sizes::width,
                 light_sizes::height},
    LightKindRow{Light::Type::disk, "disk", "Disk", "Flat disk, one-sided. Unit: cd/m².",
                 light_sizes::radius},
    LightKindRow{Light::Type::polygon, "polygon", "Polygon",
                 "Flat polygon, one-sided, may have a hole. Unit: cd/m².", light_sizes::outlines},
};
static_assert(light_kinds.size() == light_kind_count, "a kind has no row");

/// Names of the types, in the order of Light::Type.
inline constexpr auto light_type_names = [] {
  std::array<Named<Light::Type>, static_cast<std::size_t>(Light::Type::polygon) + 1> names{};
  for (const LightKindRow& row : light_kinds)
    names[static_cast<std::size_t>(row.type)] = {row.type_name, row.type};
  return names;
}();
static_assert(std::ranges::all_of(light_type_names, &Named<Light::Type>::name),
              "a type has no row");

[[nodiscard]] constexpr const LightKindRow& row_of(LightKind kind) {
  return light_kinds[static_cast<std::size_t>(kind)];
}
[[nodiscard]] inline LightKind kind_of(const Light& light) {
  if (light.type == Light::Type::point && light.radius > 0.0) return LightKind::sphere;
  const auto row = std::find_if(light_kinds.begin(), light_kinds.end(),
                                [&](const LightKindRow& r) { return r.type == light.type; });
  return static_cast<LightKind>(row - light_kinds.begin());
}
[[nodiscard]] inline const LightKindRow& row_of(const Light& light) {
  return row_of(kind_of(light));
}

}  // namespace asos
