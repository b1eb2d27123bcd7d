#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/geometry/bounds2.h"
#include "renderer/reflections/mirrored_pyray.h"
#include "renderer/reflections/ray_bundle.h"
#include "renderer/shading/light_transport.h"

#include <optional>

namespace asos {

/// A mirrored or refracted pyray, and the surface where its axis meets it.
struct ReflectedHit {
  MirroredPyray pyray;
  MirrorSurface surface;
  /// The exact rays after any refraction or blur, instead of `pyray`.
  std::optional<RayBundle> bundle;
  bool exact = true;  ///< the pyray is the exact reflection, to first order
};

/// Returns the reflected or refracted pyray of a part of a viewer's frame at the surface that it
/// meets. `whole` says that the part is the whole frame; `width` is the width of the lobe around
/// the pyray. After a refraction or blur, the pyray is the pyramid around a bundle, and one ray
/// determines its depth. Returns nothing if the part has no extent or its numbers are not finite.
[[nodiscard]] std::optional<ReflectedHit> reflected_hit(const EyeContext& eye,
                                                        const Reflection& reflection,
                                                        const Bounds2& part, bool whole,
                                                        float width, RenderStatistics& counts);

}  // namespace asos
