#pragma once

#include "renderer/geometry/view.h"
#include "renderer/prepared/geometry.h"
#include "renderer/pyray/square.h"

#include <vector>

namespace asos {

/// Cuts a frame's boundaries at the near and far planes of a view, or at its image plane.
/// Boundaries count only between the planes, and the cut through a surface is a boundary, too.
struct PlaneCuts {
  PlaneCuts(const Geometry& geometry, const View& view, const Frame& frame);

  std::vector<HalfSpace> between;  ///< for SearchBounds::within
  std::vector<BorderEdge> lines;   ///< for Pyray::outline
};

}  // namespace asos
