#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shadows/leaf.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

/// The radiance that a leaf reflects to the viewer. Its error is infinite where curved mirrors that
/// reflect each other may misplace a bright light, else within the reflection's allowance: 0.
struct ReflectionEstimate : Estimate {
  bool cut = false;  ///< a boundary divided the reflection
};

/// Follows a leaf's reflection with the same engine in the reflected frame. Colours with different
/// blur widths are followed separately (CGF'98 section 5). Returns nothing if a reflected pyray has
/// no extent or is not finite.
[[nodiscard]] std::optional<ReflectionEstimate> trace_reflection(const EyeContext& eye,
                                                                 const Reflection& reflection,
                                                                 const Leaf& leaf,
                                                                 RenderStatistics& counts);

}  // namespace asos
