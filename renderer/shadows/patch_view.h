#pragma once

#include "renderer/film/statistics.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace asos {

/// A viewer, as shadow pyrays ask it for more of the patch that a leaf shows.
class PatchView {
 public:
  virtual ~PatchView() = default;

  /// The points that are seen through points of the viewer's square, in their order; nothing is one
  /// whose triangle is Hit::none.
  virtual void look(std::span<const glm::vec2> at, std::vector<SurfacePoint>& seen,
                    RenderStatistics& counts) = 0;
};

}  // namespace asos
