#pragma once

#include "renderer/film/statistics.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/prepared/view_context.h"
#include "renderer/pyray/error_budget.h"
#include "renderer/pyray/observer.h"
#include "renderer/reflections/reflection_mask.h"
#include "renderer/shadows/engine_variant.h"
#include "renderer/shadows/leaf.h"

#include <cmath>
#include <cstdint>
#include <stop_token>

namespace asos {

class Defocus;
struct EyeWorkspace;

/// The viewer, settings and allowance of a block while it is rendered. A block is the camera's
/// block of pixels, or the picture of one reflected pyray, which has a single pixel. Pointers
/// outlive the block's caster.
struct EyeContext {
  const RenderScene* scene = nullptr;
  const RenderSettings* settings = nullptr;
  ViewContext viewer;
  const Frame* frame = nullptr;  ///< (u, v) runs from 0 to 1 across the block
  PixelRect block;               ///< square
  ErrorBudget error_budget{};    ///< of a root
  EngineVariant variant{};
  int seed = 0;                          ///< seed of sampled parts
  const ReflectionMask* mask = nullptr;  ///< weights of the parts of the square; null: their areas
  const Defocus* defocus = nullptr;      ///< blur of the camera's lens; null: a pinhole
  EyeWorkspace* work = nullptr;
  std::stop_token stop{};
  RenderStatistics* counts = nullptr;
  /// Observer and pyray number of the root `observed_root`.
  ObservedLeaf observed{};
  std::uint32_t observed_root = 0;
  Square observed_square{0.0f, 0.0f, 1.0f};  ///< square of that root, in the frame

  /// Returns whether the block is the picture of a reflected pyray.
  [[nodiscard]] bool mirrored() const { return mask != nullptr; }
  /// Returns the side, in pixels, of the square whose area is the weight of a part, whatever its
  /// shape.
  [[nodiscard]] float side_of(double weight) const {
    return viewer.pixel * static_cast<float>(std::sqrt(weight));
  }
  /// Returns the ray of a leaf's sample, with the extent of the leaf.
  [[nodiscard]] ViewedRay viewed(const Leaf& leaf) const {
    return viewer.viewed(leaf.ray, leaf.hit, side_of(leaf.weight), leaf.shape);
  }
  /// Returns the side of a root, in the frame.
  [[nodiscard]] float root_side() const { return viewer.pixel / static_cast<float>(block.width); }
};

}  // namespace asos
