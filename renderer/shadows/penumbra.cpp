#include "renderer/shadows/penumbra.h"

#include "renderer/pyray/tuning.h"
#include "renderer/shadows/linear_shadow.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asos {
namespace {

glm::dvec3 middle_of(const Frame& window) {
  return window.base_corner() + 0.5 * (window.base_u() + window.base_v());
}

/// The size of a patch around a receiver in units of the edges of a window (the frame around the
/// light), along the direction to the light's centre.
struct PatchInWindow {
  double u = 0.0, v = 0.0;  ///< full widths
};

// Returns the patch's size relative to the light's projection onto it (CGF'98 section 4.3.4). Both
// sizes are measured along the line between their centres, in the basis of the light's edges.
PatchInWindow patch_in_window(const Frame& window, const Patch& patch) {
  const glm::dvec3 a = window.base_u(), b = window.base_v();
  const glm::dvec3 m = middle_of(window);
  const double det = glm::dot(m, glm::cross(a, b));
  const auto along_u = [&](glm::vec3 p) { return glm::dot(glm::dvec3(p), glm::cross(b, m)) / det; };
  const auto along_v = [&](glm::vec3 p) { return glm::dot(glm::dvec3(p), glm::cross(m, a)) / det; };
  return {std::abs(along_u(patch.right)) + std::abs(along_u(patch.down)),
          std::abs(along_v(patch.right)) + std::abs(along_v(patch.down))};
}

// Returns the frame around the light. A distant light is placed farther than everything that could
// shade the patch.
std::optional<Frame> window_frame(const PreparedLight& light, const Receiver& receiver,
                                  double reach) {
  const auto pyramid = LightPyramid::of(light, receiver);
  if (!pyramid) return std::nullopt;
  const double scale = pyramid->infinitely_far() ? reach : 1.0;
  const Frame& frame = pyramid->frame();
  return Frame::pyramid(receiver.position, scale * frame.base_corner(), scale * frame.base_u(),
                        scale * frame.base_v());
}

/// Returns the part of a line within `beyond` of the window, if any. Part of a long boundary may
/// cross the window while its ends and its centre are far away.
std::optional<std::pair<glm::dvec2, glm::dvec2>> near_window(glm::dvec2 p, glm::dvec2 q,
                                                             glm::dvec2 beyond) {
  const glm::dvec2 d = q - p;
  const SegmentPart<double> part = clip_segment<double>(p, d, -beyond, 1.0 + beyond);
  if (part.empty()) return std::nullopt;
  return std::pair(p + part.t0 * d, p + part.t1 * d);
}

/// The shadows that boundaries above the patch cast on it. Such boundaries are behind the patch's
/// centre, seen towards the light, but in front of other points of the patch.
class ShadowOnPatch {
 public:
  ShadowOnPatch(const Frame& window, const HalfSpace& plane, glm::dvec3 middle, const Patch& patch)
      : plane_(plane), middle_(middle), light_(middle + middle_of(window)) {
    const glm::dvec3 right(patch.right), down(patch.down);
    const glm::dvec3 n = glm::cross(right, down);
    const double square = glm::dot(n, n);
    across_ = glm::cross(down, n) / square;
    along_ = glm::cross(n, right) / square;
    const glm::dvec2 u = in_patch(fallen(window.base_u())), v = in_patch(fallen(window.base_v()));
    spread_ = 0.5 * (glm::abs(u) + glm::abs(v));
  }

  /// Returns the length of the shadow of a straight piece of a boundary, in sides of the patch. It
  /// includes the surroundings within the width of its penumbra. Boundaries on the surface itself
  /// count as 0.
  [[nodiscard]] double length(glm::dvec3 p, glm::dvec3 q) const {
    constexpr double least = 1e-6;  // of the way to the light
    const double all = plane_.height(light_);
    const double hp = plane_.height(p), hq = plane_.height(q);
    const double highest = std::max(hp, hq);
    if (!(std::min(hp, hq) > least * all) || !(highest < all)) return 0.0;
    const auto shadow = [&](glm::dvec3 from, double height) {
      return in_patch(from - (light_ - from) * (height / (all - height)) - middle_) + 0.5;
    };
    const auto near = near_window(shadow(p, hp), shadow(q, hq), spread_ * (highest / all));
    return near ? glm::distance(near->first, near->second) : 0.0;
  }

 private:
  [[nodiscard]] glm::dvec2 in_patch(glm::dvec3 v) const {
    return {glm::dot(v, across_), glm::dot(v, along_)};
  }
  // Projects a step at the light onto the surface, along the light's direction.
  [[nodiscard]] glm::dvec3 fallen(glm::dvec3 step) const {
    const glm::dvec3 up = plane_.normal, way = light_ - middle_;
    return step - way * (glm::dot(up, step) / glm::dot(up, way));
  }

  HalfSpace plane_;
  glm::dvec3 middle_, light_;
  // Basis in which steps on the patch are in units of its sides.
  glm::dvec3 across_{0.0}, along_{0.0};
  // Half of the light's extent, seen from its place, in that basis.
  glm::dvec2 spread_{0.0};
};

/// The error of the centre's visibility as the patch's mean, summed over boundaries.
class VisibilityCurvature {
 public:
  /// `line`: the light is the window's centre line, along u.
  VisibilityCurvature(const Frame& window, PatchInWindow patch, bool line,
                      std::span<const LightIntersection> cuts, const ShadowOnPatch& over)
      : frame_(window), patch_(patch), line_(line), over_(over) {
    const auto placed = [&](glm::dvec3 p) {
      const glm::dvec3 h = frame_.homogeneous(p);
      return glm::dvec2(h.x / h.z, h.y / h.z);
    };
    for (const LightIntersection& cut : cuts) cuts_.push_back({placed(cut.from), placed(cut.to)});
  }

  // Adds a straight piece of a boundary, in the world.
  void add(glm::dvec3 p, glm::dvec3 q) {
    // Nearness changes along the piece, so use a few steps.
    constexpr int steps = 4;
    const glm::dvec3 hp = frame_.homogeneous(p), hq = frame_.homogeneous(q);
    if (line_) return add_to_line(hp, hq);
    for (int i = 0; i < steps; ++i) {
      const double from = i / static_cast<double>(steps), to = (i + 1) / static_cast<double>(steps);
      const glm::dvec3 h0 = hp + (hq - hp) * from, h1 = hp + (hq - hp) * to;
      if (h0.z > 0.0 && h1.z > 0.0) {
        add_step(h0, h1);
      } else {
        const double length = over_.length(p + (q - p) * from, p + (q - p) * to);
        sum_ += 0.5 * std::min(1.0, length);
      }
    }
  }

  /// Returns the midpoint rule's error of the visibility, 0 to 1/2 and more.
  [[nodiscard]] double sum() const { return sum_; }

 private:
  // A line light sweeps over a band as the receiver moves. A boundary that crosses the whole band
  // moves evenly along the line. One that ends in the band, or runs along it, hides or reveals its
  // whole length suddenly.
  void add_to_line(glm::dvec3 hp, glm::dvec3 hq) {
    if (!(hp.z > 0.0) || !(hq.z > 0.0)) {
      sum_ += 0.5;
      return;
    }
    const glm::dvec2 p(hp.x / hp.z, hp.y / hp.z), q(hq.x / hq.z, hq.y / hq.z);
    const auto sweep = [&](double w) { return 0.5 * patch_.v * std::max(0.0, 1.0 / w - 1.0); };
    const double below = std::min(p.y, q.y), above = std::max(p.y, q.y);
    const double band = std::max(sweep(hp.z), sweep(hq.z));
    const double u0 = std::min(p.x, q.x), u1 = std::max(p.x, q.x);
    const double length = std::max(0.0, std::min(u1, 1.0) - std::max(u0, 0.0));
    const bool across = below < 0.5 - band && above > 0.5 + band;
    if (below > 0.5 + band || above < 0.5 - band) return;
    if (!across) {
      sum_ += 0.5 * length;
    } else if (u0 < 0.0 || u1 > 1.0) {
      sum_ += 0.25 * length;
    }
  }

  void add_step(glm::dvec3 hp, glm::dvec3 hq) {
    const double w = 0.5 * (hp.z + hq.z);
    if (w >= 1.0) return;
    // Movement of the boundary to either side across the window as the receiver moves over the
    // patch.
    const double eu = 0.5 * patch_.u * (1.0 / w - 1.0), ev = 0.5 * patch_.v * (1.0 / w - 1.0);
    const auto near = near_window({hp.x / hp.z, hp.y / hp.z}, {hq.x / hq.z, hq.y / hq.z}, {eu, ev});
    if (!near) return;
    const auto& [p, q] = *near;
    const glm::dvec2 middle = 0.5 * (p + q);
    const bool well_in =
        middle.x > eu && middle.x < 1.0 - eu && middle.y > ev && middle.y < 1.0 - ev;
    const double length = glm::distance(p, q);
    if (!(length > 0.0)) return;
    const glm::dvec2 across = glm::dvec2(std::abs(q.y - p.y), std::abs(q.x - p.x)) / length;
    const double e = eu * across.x + ev * across.y;
    // An occluder attached to a surface that passes through the light hides one side of that
    // surface or the other, so its boundary has twice the effect.
    if (std::any_of(cuts_.begin(), cuts_.end(),
                    [&](const Cut& cut) { return distance(cut, middle) < e; }))
      sum_ += std::min(0.5, 0.5 * e) * std::min(1.0, length);
    if (well_in) return;
    // At a boundary that crosses the light's rim, the visibility has a kink between two linear
    // parts. In the worst case the kink is at the patch's centre; the error is then a quarter of
    // the movement.
    sum_ += std::min(0.5, 0.25 * e) * std::min(1.0, length);
  }

  struct Cut {
    glm::dvec2 from, to;
  };
  [[nodiscard]] static double distance(const Cut& cut, glm::dvec2 p) {
    const glm::dvec2 d = cut.to - cut.from;
    const double t = std::clamp(glm::dot(p - cut.from, d) / glm::dot(d, d), 0.0, 1.0);
    return glm::distance(p, cut.from + t * d);
  }

  const Frame& frame_;
  PatchInWindow patch_;
  bool line_;
  const ShadowOnPatch& over_;
  std::vector<Cut> cuts_;
  double sum_ = 0.0;
};

/// The extended pyray around a patch. Its apex lies behind the surface, so that it contains both
/// the patch and the light. Nothing if the view of the light has no extent.
struct PatchPyray {
  glm::dvec3 middle;  ///< of the patch, above the surface
  Frame light_frame;  ///< the light as seen from the patch's centre
  PatchInWindow size;
  Frame frame;
  /// The surface, and the plane beyond which boundaries move too little to matter.
  HalfSpace between[2];
};

std::optional<PatchPyray> pyray_around(const ShadowContext& block, const PenumbraQuery& query,
                                       double tolerance) {
  const Receiver receiver = receiver_above(query.point, query.light);
  const bool line = query.light.traits().line;
  const auto looked_at = line
                             ? strip_around(query.light, receiver)
                             : window_frame(query.light, receiver, world_reach(block.scene->world));
  if (!looked_at) return std::nullopt;
  const Frame& light = *looked_at;
  const PatchInWindow size = patch_in_window(light, query.patch);
  const double widest = std::max(size.u, size.v);
  if (!(widest > 0.0) || !std::isfinite(widest)) return std::nullopt;

  // Boundaries matter up to this fraction of the way to the light, where a quarter of their
  // movement equals the tolerance.
  const double highest = 1.0 / (1.0 + 8.0 * tolerance / widest);
  // The apex lies behind the surface, by `back` times the way to the light. For patches larger than
  // half of the light, the pyray covers a larger rectangle.
  const double larger_u = std::max(1.0, 2.0 * size.u), larger_v = std::max(1.0, 2.0 * size.v);
  const double covered = std::max(size.u / larger_u, size.v / larger_v);
  const double back = covered / (1.0 - covered);
  const glm::dvec3 m = middle_of(light);
  const glm::dvec3 a = larger_u * light.base_u(), b = larger_v * light.base_v();
  const glm::dvec3 up = receiver.geometric;
  PatchPyray pyray{
      receiver.position,
      light,
      size,
      Frame::pyramid(receiver.position - back * m, (1.0 + back) * m - 0.5 * (a + b), a, b),
      {{up, glm::dot(up, receiver.position)}, {-m, glm::dot(-m, receiver.position + highest * m)}}};
  return pyray;
}

}  // namespace

Penumbra find_penumbra(const ShadowContext& block, const PenumbraQuery& query,
                       RenderStatistics& counts) {
  // There is no penumbra if nothing is in between, or if it does not matter.
  const float tolerance = penumbra_tolerance(block.rules.error_budget);
  if (block.rules.area_shadows) return {};
  const glm::vec3 around = 0.5f * (glm::abs(query.patch.right) + glm::abs(query.patch.down));
  if (!std::isfinite(around.x + around.y + around.z)) return {};
  Box box;
  box.grow(query.point.lit_position() - around);
  box.grow(query.point.lit_position() + around);
  const KnownVisibility known =
      block.groups->ask(query.light, query.index, query.point, box, counts.shadow_rays);
  if (known.passage != KnownVisibility::Passage::open || (known.cut && known.cut->empty()))
    return {};
  const glm::vec3 unshadowed = unshadowed_irradiance(query.light, receiver_at(query.point));
  const float intensity =
      std::min(1.0f, query.reflected * std::max({unshadowed.x, unshadowed.y, unshadowed.z}));
  if (!(intensity > tolerance)) return {};
  if (choose(block.rules.error_budget, query.weight, ErrorBound::none(),
             {LeafCosts::light_view, {}, static_cast<double>(intensity)}) == Estimator::samples)
    return {};

  // Find all boundaries in the pyray around the patch.
  const auto around_patch = pyray_around(block, query, static_cast<double>(tolerance / intensity));
  if (!around_patch) return {};
  Pyray pyray{around_patch->frame};
  pyray.bounds = own_part_ignored(block.scene->world, query.light);
  pyray.bounds.cut = known.cut;
  pyray.bounds.within = around_patch->between;
  pyray.bounds.most_entries =
      most_entries_for_samples(block.rules.error_budget.nested(query.level, 1.0, 1).max_level);
  const bool line = query.light.traits().line;
  const auto boundaries = block.work->tracer.boundaries(
      block.scene->features, pyray, ShadowTuning::finest_in_penumbra, CutLimits{}.most_pieces);
  // Linear lights have no samples to fall back on.
  if (!boundaries) return line ? Penumbra{1.0f, false} : Penumbra{0.0f, true};

  // Sum up the effects of the boundaries.
  const HalfSpace& plane = around_patch->between[0];
  const ShadowOnPatch over(around_patch->light_frame, plane, around_patch->middle, query.patch);
  VisibilityCurvature curvature(around_patch->light_frame, around_patch->size, line,
                                query.light.intersections, over);
  for (const Segment& s : *boundaries) {
    const SegmentPart<float> c = clip(s, pyray.square);
    const auto at = [&](float t) {
      return pyray.frame.world({s.u0 + t * (s.u1 - s.u0), s.v0 + t * (s.v1 - s.v0),
                                s.nearness0 + t * (s.nearness1 - s.nearness0)});
    };
    curvature.add(at(c.t0), at(c.t1));
  }
  return {intensity * static_cast<float>(curvature.sum()), false};
}

}  // namespace asos
