#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/geometry/bounds2.h"
#include "renderer/reflections/mirrored_pyray.h"
#include "renderer/reflections/ray_bundle.h"
#include "renderer/shading/light_transport.h"

#include <optional>

namespace asos {

/// A mirrored or refracted pyray, and the surface where its axis meets it.
struct MirroredSight {
  MirroredPyray pyray;
  MirrorSurface surface;
  /// That the pyray stands for, once anything has refracted or blurred it.
  std::optional<RayBundle> bundle;
  bool exact = true;  ///< the pyray is what the surface makes of the viewer's, to first order
};

/// What a part of a viewer's frame, all of it or not, becomes at the surface that it meets, where a
/// lobe of `width` is around it. Where anything refracts, or the frame was blurred already, it is
/// the pyramid around a bundle, for which one ray finds out how far it leads. Nothing where it has
/// no extent or its numbers are not finite.
[[nodiscard]] std::optional<MirroredSight> mirrored_sight(const EyeContext& eye,
                                                          const Reflection& reflection,
                                                          const Bounds2& part, bool whole,
                                                          float width, RenderStatistics& counts);

}  // namespace asos
