#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/volume_path.h"

#include <glm/glm.hpp>

#include <span>

namespace asos {

/// A ray whose radiance is computed, with the extent that it represents. It comes from the eye or
/// was reflected.
struct ViewedRay {
  Ray ray;            ///< unit direction
  Hit hit;            ///< its nearest hit; invalid: the background
  float side = 0.0f;  ///< side of the square around it, in pixels of `spacing`; 0: a point
  const PixelSpacing* spacing = nullptr;  ///< null: the spacing of eye rays
  /// Width of the pyray one unit ahead (2 tan(beta / 2)): that of a pixel, widened by the lobes of
  /// blurred reflections. A defocusing ratio multiplies it.
  float width = 0.0f;
  int bounces = 0;          ///< reflections and refractions on its way
  float throughput = 1.0f;  ///< largest factor of its radiance in the picture, over the colours
  /// Lights that emit evenly, and the surfaces with their geometry, are dark: the reflecting
  /// surface has highlights of them (MirroredLights).
  bool hides_lights = false;
  FootprintShape shape = {};  ///< shape of the part that it represents, relative to the square
  /// Includes only diffuse reflection, without emission. Used for rays that carry light to another
  /// surface, which samples the lights itself.
  bool diffuse = false;
  VolumePath passage = {};
  /// The parts that `shape` represents together. Colours are averaged over each of them; empty:
  /// `shape` is exact.
  std::span<const WeightedShape> parts = {};
  float colours = 1.0f;  ///< factor of the width over which colours are averaged

  /// Returns whether any surface has reflected it, instead of only transmitting it.
  [[nodiscard]] bool reflected() const { return bounces > passage.refractions; }
};

}  // namespace asos
