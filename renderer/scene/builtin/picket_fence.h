#pragma once

#include "renderer/scene/scene.h"

namespace asos::builtin {

/// A picket fence along +x from the origin, its front towards +z, standing on y = 0.
struct PicketFence {
  int pickets = 10;
  float spacing = 0.16f;  ///< from picket to picket
  float width = 0.10f;    ///< of a picket
  float height = 1.0f;    ///< of its tip
};

/// Appends pointed pickets (16 triangles each) and, touching their backs, two rails (12 each).
void add_picket_fence(Mesh& mesh, const PicketFence& fence);

}  // namespace asos::builtin
