#pragma once

#include "renderer/geometry/shape.h"
#include "renderer/scene/scene.h"

namespace asos {

/// The shape as a mesh with normals: exact for a box, some thousand triangles for the others. What
/// programs see that know no shapes.
[[nodiscard]] Mesh tessellated(const Shape& shape);

}  // namespace asos
