#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/volume_path.h"

#include <glm/glm.hpp>

#include <span>

namespace asos {

/// A ray whose radiance is asked for, and what it stands for: it comes from the eye, or was
/// reflected.
struct ViewedRay {
  Ray ray;            ///< unit direction
  Hit hit;            ///< its nearest; invalid: the background
  float side = 0.0f;  ///< of the square around it, in pixels of `spacing`; 0: a point
  const PixelSpacing* spacing = nullptr;  ///< of the picture; null: of the eye's
  /// How wide a pyray is, one unit ahead (2 tan(beta / 2)): a pixel, and the lobes of the blurred
  /// reflections on its way. A defocusing ratio widens it.
  float width = 0.0f;
  int bounces = 0;          ///< reflections and refractions on its way
  float throughput = 1.0f;  ///< the most that the picture gets of its radiance, by colour
  /// Lights that shine evenly, and the surfaces that show them, are dark: what reflects the ray has
  /// highlights of them (MirroredLights).
  bool hides_lights = false;
  PartShape shape = {};  ///< of the part that it stands for, beside the square
  /// Shows only what surfaces reflect diffusely, nothing of what they send out themselves: a ray
  /// that brings their light to another surface, which sees lights by itself.
  bool diffuse = false;
  VolumePath passage = {};
  /// Parts that `shape` stands for all together, over which colours are averaged one by one; empty:
  /// it is as exact.
  std::span<const SharedShape> parts = {};
  float colours = 1.0f;  ///< times as wide is the square that colours are averaged over

  /// Whether any surface has reflected it, and not only let it through.
  [[nodiscard]] bool reflected() const { return bounces > passage.refractions; }
};

}  // namespace asos
