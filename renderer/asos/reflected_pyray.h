#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shadows/leaf_context.h"

#include <glm/glm.hpp>

namespace asos {

/// The radiance that a leaf sends to the viewer by way of a mirror.
struct Mirrored {
  glm::vec3 radiance{0.0f};
  bool split = false;  ///< a boundary divided it
  bool misplaces =
      false;             ///< a bright light: bent mirrors, one in the other, may show it elsewhere
  bool followed = true;  ///< false: the pyray that would show it has no extent or is not finite
};

/// Follows a leaf's reflection: the same engine, in the frame that the surface mirrors, by colour
/// where colours blur by different widths (CGF'98 section 5).
[[nodiscard]] Mirrored trace_reflection(const EyeContext& eye, const Reflection& reflection,
                                        const LeafContext& leaf, RenderStatistics& counts);

}  // namespace asos
