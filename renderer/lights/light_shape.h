#pragma once

#include "renderer/world/render_features.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace asos {

/// Shapes of lights as they are evaluated; docs/light-kinds.md describes how to add one.
enum class LightShape : std::uint8_t {
  point,    ///< point and spot
  distant,  ///< directional: a point at infinity
  ball,     ///< point and spot with a radius
  sun,      ///< directional with an angular diameter
  segment,  ///< linear
  capsule,  ///< linear with a radius
  rectangle,
  polygon,  ///< polygon, sheared rectangle
  disk,
};

/// How samples find the numbers that they need in double precision.
enum class Sampling : std::uint8_t {
  direct,           ///< they need none
  lanes,            ///< in lanes, for all points at once
  solid_angle,      ///< in lanes, partly the same for all samples of a point
  lanes_or_scalar,  ///< in lanes where that is possible
  rows,             ///< from PolygonRows
};

/// Properties of a shape.
struct LightTraits {
  bool RenderFeatures::*feature;  ///< that a scene with such a light needs
  bool extended = false;          ///< its shadows have penumbrae
  bool infinite = false;          ///< infinitely distant
  bool flat = false;              ///< in a plane, within position +- half_u +- half_v
  bool line = false;              ///< without width: no direction hits it
  const char* sized = nullptr;    ///< its own name in `asos info`; null: counted by type alone
  Sampling sampling = Sampling::direct;

  /// Returns whether hits of directions are tested one after another.
  [[nodiscard]] constexpr bool scalar_hits() const {
    return sampling == Sampling::rows || sampling == Sampling::lanes_or_scalar;
  }
  /// Returns whether the light has a radiance, which highlights of narrow lobes show.
  [[nodiscard]] constexpr bool has_area() const { return extended && !line; }
  /// Returns whether rays may hit the light at a distance.
  [[nodiscard]] constexpr bool has_surface() const { return has_area() && !infinite; }
};

/// One row per shape, in the enumeration's order.
inline constexpr auto light_traits = std::to_array<LightTraits>({
    {.feature = &RenderFeatures::punctual_lights},                                 // point
    {.feature = &RenderFeatures::punctual_lights, .infinite = true},               // distant
    {.feature = &RenderFeatures::ball_lights, .extended = true, .sized = "ball"},  // ball
    {.feature = &RenderFeatures::suns, .extended = true, .infinite = true, .sized = "sun"},  // sun
    {.feature = &RenderFeatures::linear_lights,
     .extended = true,
     .line = true,
     .sampling = Sampling::lanes},  // segment
    {.feature = &RenderFeatures::linear_lights,
     .extended = true,
     .sampling = Sampling::lanes_or_scalar},  // capsule
    {.feature = &RenderFeatures::rectangle_lights,
     .extended = true,
     .flat = true,
     .sampling = Sampling::solid_angle},  // rectangle
    {.feature = &RenderFeatures::rectangle_lights,
     .extended = true,
     .flat = true,
     .sampling = Sampling::rows},                                               // polygon
    {.feature = &RenderFeatures::disk_lights, .extended = true, .flat = true},  // disk
});
[[nodiscard]] constexpr const LightTraits& traits_of(LightShape shape) {
  return light_traits[static_cast<std::size_t>(shape)];
}

template <LightShape shape>
using ShapeTag = std::integral_constant<LightShape, shape>;

/// Returns f(ShapeTag<shape>()). This is the only switch over shapes: code for all of them is a
/// template of the tag, and a shape that lacks its case does not compile.
template <typename F>
constexpr decltype(auto) with_shape(LightShape shape, F&& f) {
  switch (shape) {
    case LightShape::point:
      return f(ShapeTag<LightShape::point>());
    case LightShape::distant:
      return f(ShapeTag<LightShape::distant>());
    case LightShape::ball:
      return f(ShapeTag<LightShape::ball>());
    case LightShape::sun:
      return f(ShapeTag<LightShape::sun>());
    case LightShape::segment:
      return f(ShapeTag<LightShape::segment>());
    case LightShape::capsule:
      return f(ShapeTag<LightShape::capsule>());
    case LightShape::rectangle:
      return f(ShapeTag<LightShape::rectangle>());
    case LightShape::polygon:
      return f(ShapeTag<LightShape::polygon>());
    case LightShape::disk:
      break;
  }
  static_assert(light_traits.size() == static_cast<std::size_t>(LightShape::disk) + 1);
  return f(ShapeTag<LightShape::disk>());
}

}  // namespace asos
