#include "renderer/asos/pixel_trace.h"

#include "renderer/asos/fat_pyray.h"

#include <algorithm>
#include <utility>

namespace asos {

namespace {

PixelTracePyray traced_pyray(const FeatureSet& features, const LoggedPyray& logged) {
  PixelTracePyray pyray{logged.kind, logged.light,  logged.bounces, logged.parent,
                        logged.from, logged.weight, logged.result,  {}};
  std::size_t leaf = 0;
  for (const TracedCell& seen : logged.subdivision.cells) {
    PixelTraceCell& cell = pyray.cells.emplace_back();
    cell.level = seen.level;
    cell.corner = {seen.square.u, seen.square.v};
    cell.side = seen.square.side;
    cell.fate = seen.fate;
    cell.clusters = seen.clusters;
    cell.hidden = seen.hidden;
    for (const Segment& s : seen.boundaries) {
      const Clip c = clip(s, seen.square);
      if (c.empty()) continue;
      const glm::vec2 p(s.u0, s.v0), d(s.u1 - s.u0, s.v1 - s.v0);
      // Outlines of lights and of the leaf itself are no edges of the scene.
      const auto kind =
          s.edge < features.edges().size() ? features.edges()[s.edge].kind : FeatureKind::open;
      cell.boundaries.push_back({p + c.t0 * d, p + c.t1 * d, kind});
    }
    for (const TracedLeaf& l : seen.leaves)
      cell.samples.push_back({l.at, l.weight, logged.leaves[leaf++], Hit::none});
  }
  return pyray;
}

}  // namespace

// What the engine saw, in the pixel's own coordinates.
void FatPyray::finish_trace() {
  const std::uint32_t pixel = index(trace_->x - block_.x, trace_->y - block_.y);
  const Square own = pixel_square(trace_->x - block_.x, trace_->y - block_.y);
  const auto place = [&](float u, float v) { return glm::vec2(u - own.u, v - own.v) / own.side; };
  const auto sample = [&](const TracedLeaf& leaf) {
    return PixelTraceSample{place(leaf.at.x, leaf.at.y), leaf.weight,
                            caster_.logged_radiance(leaf.sample), caster_.triangle(leaf.sample)};
  };
  trace_->levels = std::move(subdivision_.levels);
  for (const LoggedPyray& logged : log_.pyrays()) {
    PixelTracePyray& pyray = trace_->pyrays.emplace_back(traced_pyray(scene_.features, logged));
    if (pyray.parent < 0) pyray.from = place(logged.from.x, logged.from.y);
  }
  trace_->unresolved_area = outcomes_[pixel].unresolved_area;
  trace_->missed = missed_[pixel] != 0;
  for (const TracedCell& seen : subdivision_.cells) {
    PixelTraceCell& cell = trace_->cells.emplace_back();
    cell.level = seen.level;
    cell.corner = place(seen.square.u, seen.square.v);
    cell.side = seen.square.side / own.side;
    cell.fate = seen.fate;
    cell.clusters = seen.clusters;
    cell.hidden = seen.hidden;
    const Square reach = detector_.reach(seen.square);
    for (const Segment& s : seen.boundaries) {
      const Clip c = clip(s, reach);
      const auto at = [&](float t) {
        return place(s.u0 + t * (s.u1 - s.u0), s.v0 + t * (s.v1 - s.v0));
      };
      cell.boundaries.push_back({at(c.t0), at(c.t1), scene_.features.edges()[s.edge].kind});
    }
    for (const TracedLeaf& leaf : seen.leaves) cell.samples.push_back(sample(leaf));
  }
  if (!trace_->cells.empty()) return;
  // No boundary is near: one sample, or the safety net's.
  PixelTraceCell& cell = trace_->cells.emplace_back();
  cell.fate = by_samples_[pixel] ? CellFate::by_samples : CellFate::uniform;
  for (const TracedLeaf& leaf : caster_.logged_leaves()) cell.samples.push_back(sample(leaf));
}

PixelTrace trace_pixel(const RenderScene& scene, const View& view, const RenderSettings& asked,
                       int x, int y) {
  const RenderSettings settings = as_published(asked);
  const int fat = settings.asos.fat;
  PixelRect block{x / fat * fat, y / fat * fat, fat, fat};
  block.width = std::min(fat, view.width() - block.x);
  block.height = std::min(fat, view.height() - block.y);
  FatPyrayWorkspace work;
  PixelTrace trace;
  trace.x = x;
  trace.y = y;
  (void)FatPyray(scene, view, settings, block, {}, work).run(trace);
  return trace;
}

}  // namespace asos
