#pragma once

#include "renderer/geometry/view.h"
#include "renderer/prepared/geometry.h"
#include "renderer/pyray/square.h"

#include <vector>

namespace asos {

/// What the near and far planes of a view, or its image plane, do to the boundaries in a frame of
/// it: boundaries count between the planes, and surfaces end where a plane cuts them.
struct PlaneCuts {
  PlaneCuts(const Geometry& geometry, const View& view, const Frame& frame);

  std::vector<HalfSpace> between;  ///< for SearchBounds::within
  std::vector<BorderEdge> lines;   ///< for Pyray::outline
};

}  // namespace asos
