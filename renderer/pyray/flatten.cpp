#include "renderer/pyray/flatten.h"

#include "renderer/pyray/tuning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr int deepest = 14;
// An arc is divided into parts that turn by at most this, in radians, before the centre of each
// part is compared with its chord.
constexpr double widest_turn = 1.1;

}  // namespace

std::span<const Segment> Flattener::flatten(const Frame& frame, const EllipseArc& arc,
                                            std::span<const double> breaks, double finest_side,
                                            const FlattenBounds& bounds) {
  segments_.clear();
  find_angles(frame, arc, breaks, bounds);
  if (angles_.empty()) {
    // A closed arc that crosses nothing.
    if (!inside(frame, arc.at(arc.from), bounds)) return {};
    emit(frame, arc, arc.from, arc.from + two_pi, finest_side);
    return segments_;
  }
  // Emit each run of the arc that is inside, up to the next break.
  const std::size_t last = angles_.size() - 1;
  for (std::size_t i = 0; i < last;) {
    const auto kept = [&](std::size_t k) {
      return k < last && inside(frame, arc.at(0.5 * (angles_[k] + angles_[k + 1])), bounds);
    };
    if (!kept(i)) {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    while (!break_at(angles_[end]) && kept(end)) ++end;
    emit(frame, arc, angles_[i], angles_[end], finest_side);
    i = end;
  }
  return segments_;
}

// Finds and sorts the angles where the arc crosses the bounds, with its ends and breaks.
void Flattener::find_angles(const Frame& frame, const EllipseArc& arc,
                            std::span<const double> breaks, const FlattenBounds& bounds) {
  angles_.clear();
  breaks_.clear();
  // Find where the arc crosses the sides of the square, widened by the margin, and the bounds.
  const auto rows = [&](glm::dvec3 d) {
    return glm::dvec3(glm::dot(frame.row_u(), d), glm::dot(frame.row_v(), d),
                      glm::dot(frame.row_w(), d));
  };
  glm::dvec3 h[3] = {frame.homogeneous(arc.centre), rows(arc.cosine), rows(arc.sine)};
  const auto keep = [&](auto&& value) { add_crossings(value(0), value(1), value(2), angles_); };
  const auto w = [&](int i) { return frame.parallel() ? (i == 0 ? 1.0 : 0.0) : h[i].z; };
  for (int axis = 0; axis < 2; ++axis) {
    keep([&](int i) { return h[i][axis] + bounds.margin * w(i); });
    keep([&](int i) { return (1.0 + bounds.margin) * w(i) - h[i][axis]; });
  }
  keep([&](int i) { return h[i].z; });
  for (std::size_t k = 0; k < bounds.within.size(); ++k) {
    const HalfSpace& half = bounds.within[k];
    const double beyond = k == 0 ? bounds.beyond_first : 0.0;
    keep([&](int i) {
      return i == 0 ? half.height(arc.centre) + beyond
                    : glm::dot(half.normal, i == 1 ? arc.cosine : arc.sine);
    });
  }
  // Add the breaks, and bring all angles into one turn.
  const std::size_t crossings = angles_.size();
  angles_.insert(angles_.end(), breaks.begin(), breaks.end());
  const bool closed = arc.closed();
  // Start at `from`, or at the first of the angles for a closed arc.
  const double from = closed && !angles_.empty() ? angles_[0] : arc.from;
  for (std::size_t i = 0; i < angles_.size(); ++i) {
    const double given = angles_[i];
    if (i > 0 || !closed) angles_[i] -= two_pi * std::floor((given - from) / two_pi);
    if (i >= crossings) breaks_.push_back({angles_[i], given});
  }
  // Add the ends.
  if (!closed) {
    std::erase_if(angles_, [&](double angle) { return angle > arc.to; });
    angles_.push_back(arc.from);
    angles_.push_back(arc.to);
  } else if (!angles_.empty()) {
    angles_.push_back(from + two_pi);
    if (crossings == 0) breaks_.push_back({from + two_pi, from});
  }
  std::sort(angles_.begin(), angles_.end());
}

const Flattener::Break* Flattener::break_at(double angle) const {
  const auto found = std::find_if(breaks_.begin(), breaks_.end(),
                                  [&](const Break& b) { return b.angle == angle; });
  return found == breaks_.end() ? nullptr : &*found;
}

// Returns the place at an angle. A break is placed at the angle as it was given, bit for bit, since
// other boundaries use that angle.
FramePoint Flattener::place(const Frame& frame, const EllipseArc& arc, double angle) const {
  const Break* known = break_at(angle);
  return frame.project(frame.homogeneous(arc.at(known ? known->given : angle)));
}

bool Flattener::inside(const Frame& frame, glm::dvec3 p, const FlattenBounds& bounds) const {
  const glm::dvec3 h = frame.homogeneous(p);
  const double w = frame.parallel() ? 1.0 : h.z;
  if (!(h.z > 0.0) || h.x < -bounds.margin * w || h.y < -bounds.margin * w ||
      h.x > (1.0 + bounds.margin) * w || h.y > (1.0 + bounds.margin) * w)
    return false;
  for (std::size_t k = 0; k < bounds.within.size(); ++k) {
    if (bounds.within[k].height(p) + (k == 0 ? bounds.beyond_first : 0.0) < 0.0) return false;
  }
  return true;
}

void Flattener::emit(const Frame& frame, const EllipseArc& arc, double from, double to,
                     double finest_side) {
  joints_.clear();
  const bool closed = to - from >= two_pi && breaks_.empty();
  const int parts = std::max(1, static_cast<int>(std::ceil((to - from) / widest_turn)));
  Joint start{from, place(frame, arc, from), {}, !closed};
  for (int i = 1; i <= parts; ++i) {
    const double angle = i == parts ? to : from + (to - from) * i / parts;
    Joint end{angle, place(frame, arc, angle), {}, i == parts && !closed};
    split(frame, arc, start, end, finest_side, 0);
    start = end;
  }
  joints_.push_back(start);
  settle(closed);
}

// Appends the joints from `from` on, except the last.
void Flattener::split(const Frame& frame, const EllipseArc& arc, const Joint& from, const Joint& to,
                      double finest_side, int depth) {
  const double angle = 0.5 * (from.angle + to.angle);
  const Joint middle{angle, place(frame, arc, angle), {}, false};
  const glm::dvec2 p(from.at.u, from.at.v), q(to.at.u, to.at.v), m(middle.at.u, middle.at.v);
  const glm::dvec2 chord = q - p;
  const double length2 = glm::dot(chord, chord);
  const double t = length2 > 0.0 ? std::clamp(glm::dot(m - p, chord) / length2, 0.0, 1.0) : 0.0;
  const glm::dvec2 bulge = m - (p + t * chord);
  const double away = glm::length(bulge);
  const bool straight =
      away <= SearchTuning::most_bulge * finest_side &&
      away * std::sqrt(length2) <= SearchTuning::most_area * finest_side * finest_side;
  if (straight || depth >= deepest) {
    joints_.push_back(from);
    joints_.back().bulge = bulge;
    return;
  }
  split(frame, arc, from, middle, finest_side, depth + 1);
  split(frame, arc, middle, to, finest_side, depth + 1);
}

// Moves joints by two thirds of the bulge, so that chord and arc enclose the same area. Each joint
// uses the mean of both its sides.
void Flattener::settle(bool closed) {
  const std::size_t last = joints_.size() - 1;
  std::vector<FramePoint>& at = moved_;
  at.clear();
  for (std::size_t i = 0; i <= last; ++i) {
    at.push_back(joints_[i].at);
    if (joints_[i].fixed || last < 2) continue;
    const glm::dvec2 before = joints_[i > 0 ? i - 1 : last - 1].bulge;
    const glm::dvec2 after = joints_[i < last ? i : 0].bulge;
    const glm::dvec2 by = (before + after) / 3.0;
    at.back().u += by.x;
    at.back().v += by.y;
  }
  if (closed) at[last] = at[0];
  for (std::size_t i = 0; i < last; ++i) {
    Segment s;
    s.u0 = static_cast<float>(at[i].u), s.v0 = static_cast<float>(at[i].v);
    s.nearness0 = static_cast<float>(at[i].nearness);
    s.u1 = static_cast<float>(at[i + 1].u), s.v1 = static_cast<float>(at[i + 1].v);
    s.nearness1 = static_cast<float>(at[i + 1].nearness);
    segments_.push_back(s);
  }
}

}  // namespace asos
