#include "renderer/features/intersections.h"

#include "renderer/features/box_pairs.h"
#include "renderer/features/stoppable_loop.h"
#include "renderer/tasks.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>
#include <tbb/enumerable_thread_specific.h>
#include <utility>

namespace asos {
namespace {

using TriangleCorners = std::array<glm::dvec3, 3>;

/// A straight piece of a line.
struct LineSegment {
  glm::dvec3 p, q;
};

// Distances below this fraction of the coordinates are rounding errors.
constexpr double on_plane = 4e-7;
// Lines shorter than this fraction of the smaller triangle's size are contacts at a corner.
constexpr double shortest_line = 1e-6;
// Largest sine of the angle between both triangles' segments. They are on one line, except for
// rounding.
constexpr double askew = 1e-3;

// Largest rounding error of a corner, by axis: a floor of kilometres is exactly level, and a small
// object that stands in it must not count as coplanar with it.
struct Rounding {
  glm::dvec3 of_coordinates;

  // Returns the rounding error of a distance along n, in units of n's length.
  [[nodiscard]] double along(glm::dvec3 n) const { return glm::dot(glm::abs(n), of_coordinates); }
};

// Returns the largest extent of a triangle's box along an axis.
double size_of(const TriangleCorners& t) {
  const glm::dvec3 d = glm::max(t[0], glm::max(t[1], t[2])) - glm::min(t[0], glm::min(t[1], t[2]));
  return std::max({d.x, d.y, d.z});
}

Rounding rounding_of(const TriangleCorners& s, const TriangleCorners& t, glm::dvec3 origin,
                     double size) {
  glm::dvec3 largest(0.0);
  for (int i = 0; i < 3; ++i) largest = glm::max(largest, glm::max(glm::abs(s[i]), glm::abs(t[i])));
  return {on_plane * (largest + glm::abs(origin) + size)};
}

// Returns the triangle's normal, of any length, independent of the winding: its largest coordinate
// is positive.
glm::dvec3 unwound_normal(const TriangleCorners& t) {
  const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
  const glm::dvec3 size = glm::abs(n);
  const int largest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return n[largest] < 0.0 ? -n : n;
}

// Returns the segment of `t` on the plane of `other`. A corner on the plane counts as being on its
// positive side, so that two triangles that meet on the plane cross it once together.
std::optional<LineSegment> crossing(const TriangleCorners& t, const TriangleCorners& other,
                                    const Rounding& rounding) {
  const glm::dvec3 n = unwound_normal(other);
  const double nothing = rounding.along(n);
  double d[3];
  int negative = 0;
  for (int i = 0; i < 3; ++i) {
    d[i] = glm::dot(n, t[i] - other[0]);
    if (std::abs(d[i]) <= nothing) d[i] = 0.0;
    negative += d[i] < 0.0;
  }
  if (negative == 0 || negative == 3) return std::nullopt;
  glm::dvec3 found[2];
  int count = 0;
  for (int i = 0; i < 3 && count < 2; ++i) {
    const int j = (i + 1) % 3;
    if ((d[i] < 0.0) == (d[j] < 0.0)) continue;
    found[count++] = t[i] + (t[j] - t[i]) * (d[i] / (d[i] - d[j]));
  }
  return LineSegment{found[0], found[1]};
}

// Returns the segment along which two triangles pass through each other. There is none where they
// only touch or are coplanar, up to the rounding of coordinates that were floats relative to
// `origin`. Does not depend on winding.
std::optional<LineSegment> common_line(const TriangleCorners& s, const TriangleCorners& t,
                                       glm::dvec3 origin) {
  const double size = std::min(size_of(s), size_of(t));
  const Rounding rounding = rounding_of(s, t, origin, size);
  const std::optional<LineSegment> x = crossing(s, t, rounding);
  if (!x) return std::nullopt;
  const std::optional<LineSegment> y = crossing(t, s, rounding);
  if (!y) return std::nullopt;
  // The common part of the two segments is the intersection.
  const glm::dvec3 d = x->q - x->p;
  const double square = glm::dot(d, d);
  if (!(square > 0.0)) return std::nullopt;
  const glm::dvec3 e = y->q - y->p;
  if (glm::length(glm::cross(d, e)) > askew * std::sqrt(square) * glm::length(e))
    return std::nullopt;
  double y0 = glm::dot(y->p - x->p, d) / square;
  double y1 = glm::dot(y->q - x->p, d) / square;
  glm::dvec3 p0 = y->p, p1 = y->q;
  if (y0 > y1) {
    std::swap(y0, y1);
    std::swap(p0, p1);
  }
  const double length = (std::min(y1, 1.0) - std::max(y0, 0.0)) * std::sqrt(square);
  if (length <= shortest_line * size) return std::nullopt;
  return LineSegment{y0 > 0.0 ? p0 : x->p, y1 < 1.0 ? p1 : x->q};
}

using Corners = glm::mat3;

Corners corners_of(const World& world, std::uint32_t triangle) {
  const glm::uvec3 t = world.triangles[triangle];
  return {world.positions[t.x], world.positions[t.y], world.positions[t.z]};
}

TriangleCorners in_double(const Corners& c) {
  return {glm::dvec3(c[0]), glm::dvec3(c[1]), glm::dvec3(c[2])};
}

// Equal corners of two triangles: their number, and the last such pair.
struct Meeting {
  int count = 0;
  int a = 0;
  int b = 0;
};

template <typename Places>
Meeting meeting(const Places& a, const Places& b) {
  Meeting m;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (a[i] == b[k]) m = {m.count + 1, i, k};
  return m;
}

// Returns whether a plane through the shared corner separates `a` from the rest of `b` by more than
// the error of single precision. Tests the plane of `a`, for most neighbours at a corner, and the
// planes perpendicular to `a` through its sides at the corner, for triangles around a hub. Most
// pairs are separated.
bool beside(const Corners& a, const Corners& b, int corner_a, int corner_b) {
  const glm::vec3 v = a[corner_a];
  const glm::vec3 p = a[(corner_a + 1) % 3] - v, q = a[(corner_a + 2) % 3] - v;
  const glm::vec3 n = glm::cross(p, q);
  const glm::vec3 r = b[(corner_b + 1) % 3] - v, s = b[(corner_b + 2) % 3] - v;
  const float x = glm::dot(n, r), y = glm::dot(n, s);
  const float size = glm::dot(glm::abs(p), glm::vec3(1)) * glm::dot(glm::abs(q), glm::vec3(1));
  constexpr float error = 4e-6f;
  const float least = error * size * (glm::dot(glm::abs(r) + glm::abs(s), glm::vec3(1)));
  if ((x > least && y > least) || (x < -least && y < -least)) return true;
  const auto outside = [&](glm::vec3 inwards, glm::vec3 side) {
    const float beyond = -least * glm::dot(glm::abs(side), glm::vec3(1));
    return glm::dot(inwards, r) < beyond && glm::dot(inwards, s) < beyond;
  };
  return outside(glm::cross(n, p), p) || outside(glm::cross(q, n), q);
}

class Collider {
 public:
  /// The pairs to compare: surfaces; a surface with a line or point; or a placed mesh with another
  /// mesh or place.
  enum class Of { surfaces, lines_and_points, placed };

  Collider(const World& world, std::span<const std::uint32_t> welded, Of of,
           const IntersectionBudget& budget, const std::stop_token& stop)
      : world_(world),
        welded_(welded),
        of_(of),
        count_(of == Of::lines_and_points ? world.triangles.size() : world.solid_triangles()),
        budget_(budget),
        stop_(stop),
        boxes_(world, count_, stop) {}

  /// Compares placed meshes among some triangles.
  Collider(const World& world, std::vector<std::uint32_t> triangles,
           const IntersectionBudget& budget, const std::stop_token& stop)
      : world_(world),
        of_(Of::placed),
        count_(triangles.size()),
        budget_(budget),
        stop_(stop),
        boxes_(world, std::move(triangles), stop) {}

  Intersections run() {
    if (hopeless()) return {{}, false};
    in_tasks(boxes_.leaf_count(), [this](std::size_t leaf) {
      check_stop(stop_);
      if (over_budget_.load(std::memory_order_relaxed)) return;
      Local& local = found_.local();
      boxes_.visit_pairs(leaf, [&](std::uint32_t s, std::uint32_t t) {
        test(s, t, local);
        return ++local.pairs < batch || spend(local);
      });
      if (local.pairs >= batch) (void)spend(local);
    });
    return gather();
  }

 private:
  struct Local {
    std::vector<IntersectionLine> lines;
    std::size_t pairs = 0;  // not yet added to pairs_
  };

  // Returns whether a few leaves, chosen by a fixed rule, have too many pairs. Counting a pair
  // costs far less than testing it.
  [[nodiscard]] bool hopeless() const {
    const std::size_t n = count_;
    const std::size_t leaves = boxes_.leaf_count();
    if (n * (n - 1) / 2 <= survey_slack * budget_.pairs) return false;
    std::vector<std::size_t> pairs(std::clamp<std::size_t>((std::size_t{1} << 26) / n, 32, 256));
    in_tasks(pairs.size(), [&](std::size_t i) {
      const std::uint64_t step = (i + 1) * 0x9e3779b97f4a7c15ULL;
      boxes_.visit_pairs((step >> 32) % leaves, [&](std::uint32_t, std::uint32_t) {
        ++pairs[i];
        return true;
      });
    });
    // Drop the largest counts: a large floor may meet everything, but floors are few.
    std::sort(pairs.begin(), pairs.end());
    pairs.resize(pairs.size() - pairs.size() / 32);
    const double mean =
        static_cast<double>(std::accumulate(pairs.begin(), pairs.end(), std::size_t{0})) /
        static_cast<double>(pairs.size());
    return mean * static_cast<double>(leaves) > static_cast<double>(survey_slack * budget_.pairs);
  }

  void test(std::uint32_t s, std::uint32_t t, Local& local) const {
    if (of_ == Of::lines_and_points &&
        world_.lines_and_points.has_triangle(s) == world_.lines_and_points.has_triangle(t))
      return;
    if (of_ == Of::placed && !of_two_meshes(s, t)) return;
    // Neighbours along an edge meet only there, unless they are coplanar.
    const Meeting m = of_ == Of::placed ? meeting(corners_of(world_, s), corners_of(world_, t))
                                        : meeting(places_of(s), places_of(t));
    if (m.count > 1) return;
    const Corners a = corners_of(world_, s), b = corners_of(world_, t);
    if (m.count == 1 && (beside(a, b, m.a, m.b) || beside(b, a, m.b, m.a))) return;
    const std::optional<LineSegment> line = common_line(in_double(a), in_double(b), world_.origin);
    if (line) local.lines.push_back({glm::vec3(line->p), glm::vec3(line->q), s, t});
  }

  /// Returns whether the pair belongs neither to one mesh nor to the world's own surfaces.
  [[nodiscard]] bool of_two_meshes(std::uint32_t s, std::uint32_t t) const {
    const std::uint32_t later = std::max(s, t);
    if (!world_.is_placed(later)) return false;
    const Placements& all = *world_.placements;
    return std::min(s, t) < all.own_triangles + all.of_triangle(later).first_triangle;
  }

  [[nodiscard]] glm::uvec3 places_of(std::uint32_t triangle) const {
    const glm::uvec3 t = world_.triangles[triangle];
    return {welded_[t.x], welded_[t.y], welded_[t.z]};
  }

  // Returns whether to continue. The decision about the budget does not depend on threads: every
  // pair is counted once, and counting stops early only beyond the budget.
  [[nodiscard]] bool spend(Local& local) {
    pairs_ += std::exchange(local.pairs, 0);
    if (local.lines.size() > budget_.lines || pairs_ > budget_.pairs) over_budget_ = true;
    return !over_budget_;
  }

  Intersections gather() {
    Intersections out;
    for (const Local& local : found_) {
      pairs_ += local.pairs;
      out.lines.insert(out.lines.end(), local.lines.begin(), local.lines.end());
    }
    if (over_budget_ || out.lines.size() > budget_.lines || pairs_ > budget_.pairs)
      return {{}, false};
    std::sort(out.lines.begin(), out.lines.end(),
              [](const IntersectionLine& x, const IntersectionLine& y) {
                return x.first_triangle != y.first_triangle ? x.first_triangle < y.first_triangle
                                                            : x.second_triangle < y.second_triangle;
              });
    return out;
  }

  // Margin of the survey, so that it does not refuse scenes that fit.
  static constexpr std::size_t survey_slack = 2;
  static constexpr std::size_t batch = 1024;

  const World& world_;
  std::span<const std::uint32_t> welded_;
  Of of_;
  std::size_t count_;  // number of triangles to compare
  IntersectionBudget budget_;
  std::stop_token stop_;
  BoxTree boxes_;
  tbb::enumerable_thread_specific<Local> found_;
  std::atomic<std::size_t> pairs_{0};
  std::atomic<bool> over_budget_{false};
};

}  // namespace

IntersectionBudget IntersectionBudget::of(const World& world) {
  const std::size_t n = world.solid_triangles();
  return {std::max<std::size_t>(250'000, 4 * n), (std::size_t{1} << 26) + 256 * n};
}

Intersections find_intersections(const World& world, std::span<const std::uint32_t> welded,
                                 const IntersectionBudget& budget, const std::stop_token& stop) {
  Intersections found;
  if (world.solid_triangles() > 1)
    found = Collider(world, welded, Collider::Of::surfaces, budget, stop).run();
  if (world.solid_triangles() == 0 || !world.lines_and_points.drawn()) return found;
  // Surfaces keep their lines even if lines and points have too many.
  const std::size_t n = world.lines_and_points.triangle_count;
  const IntersectionBudget more{budget.lines + 4 * n, budget.pairs + 256 * n};
  const Intersections of_strokes =
      Collider(world, welded, Collider::Of::lines_and_points, more, stop).run();
  found.lines.insert(found.lines.end(), of_strokes.lines.begin(), of_strokes.lines.end());
  return found;
}

Intersections intersections_among(const World& world, std::vector<std::uint32_t> triangles,
                                  const IntersectionBudget& budget, const std::stop_token& stop) {
  if (triangles.size() < 2) return {};
  return Collider(world, std::move(triangles), budget, stop).run();
}

}  // namespace asos
