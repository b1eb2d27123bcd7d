#include "renderer/asos/plane_cuts.h"

#include "renderer/geometry/clip_segment.h"
#include "renderer/prepared/plane_section.h"

#include <optional>

namespace asos {
namespace {

// Returns the part of a line near the frame's square. Floats are too coarse for ends far away.
std::optional<BorderEdge> near_square(glm::dvec2 from, glm::dvec2 to) {
  constexpr double lo = -1.0, hi = 2.0;
  EdgeRange range;
  for (int axis = 0; axis < 2; ++axis) {
    range.keep(from[axis] - lo, to[axis] - lo);
    range.keep(hi - from[axis], hi - to[axis]);
  }
  if (!(range.t0 < range.t1)) return std::nullopt;
  const glm::dvec2 a = range.t0 > 0.0 ? glm::mix(from, to, range.t0) : from;
  const glm::dvec2 b = range.t1 < 1.0 ? glm::mix(from, to, range.t1) : to;
  if (glm::any(glm::lessThan(glm::max(a, b), glm::dvec2(0.0))) ||
      glm::any(glm::greaterThan(glm::min(a, b), glm::dvec2(1.0))))
    return std::nullopt;
  return BorderEdge{glm::vec2(a), glm::vec2(b)};
}

void add_lines(const Geometry& geometry, const Frame& frame, const HalfSpace& plane,
               std::vector<BorderEdge>& lines) {
  for (const SectionLine& line : *geometry.sections.of(geometry.world, plane)) {
    const FramePoint p = frame.project(frame.homogeneous(line.from));
    const FramePoint q = frame.project(frame.homogeneous(line.to));
    if (const auto edge = near_square({p.u, p.v}, {q.u, q.v})) lines.push_back(*edge);
  }
}

}  // namespace

PlaneCuts::PlaneCuts(const Geometry& geometry, const View& view, const Frame& frame) {
  if (const auto ahead = view.ahead()) {
    add_lines(geometry, frame, *ahead, lines);
    // A frame of parallel rays begins in its image plane.
    if (view.near_depth() > 0.0) between.push_back(*ahead);
  }
  if (const auto before = view.before()) {
    add_lines(geometry, frame, *before, lines);
    between.push_back(*before);
  }
}

}  // namespace asos
