#pragma once

#include "renderer/film/statistics.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace asos {

/// A viewer that gives shadow pyrays more points of a leaf's patch.
class PatchView {
 public:
  virtual ~PatchView() = default;

  /// Computes the surface points visible through points of the viewer's square, in their order.
  /// Where there is none, the triangle is Hit::none.
  virtual void look(std::span<const glm::vec2> at, std::vector<SurfacePoint>& seen,
                    RenderStatistics& counts) = 0;
};

}  // namespace asos
