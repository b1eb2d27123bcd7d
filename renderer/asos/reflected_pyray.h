#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shadows/leaf.h"

#include <glm/glm.hpp>

namespace asos {

/// The radiance that a leaf reflects to the viewer.
struct ReflectionResult {
  glm::vec3 radiance{0.0f};
  bool split = false;      ///< a boundary divided the reflection
  bool misplaces = false;  ///< curved mirrors that reflect each other may misplace a bright light
  bool followed = true;    ///< false: the reflected pyray has no extent or is not finite
};

/// Follows a leaf's reflection with the same engine in the reflected frame. Colours with different
/// blur widths are followed separately (CGF'98 section 5).
[[nodiscard]] ReflectionResult trace_reflection(const EyeContext& eye, const Reflection& reflection,
                                                const Leaf& leaf, RenderStatistics& counts);

}  // namespace asos
