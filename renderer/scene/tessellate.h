#pragma once

#include "renderer/geometry/shape.h"
#include "renderer/scene/scene.h"

namespace asos {

/// Returns the shape as a mesh with normals, for programs that do not support shapes: exact for a
/// box, 128 to 4,608 triangles for the others.
[[nodiscard]] Mesh tessellated(const Shape& shape);

}  // namespace asos
