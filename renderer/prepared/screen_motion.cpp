#include "renderer/prepared/screen_motion.h"

#include "renderer/world/placements.h"
#include "renderer/world/surface_kind.h"

#include <algorithm>
#include <array>
#include <utility>

namespace asos {
namespace {

using ScreenPoint = std::optional<glm::dvec2>;

// The part of the plane of the picture that is looked at, as a square from 0 to 1.
constexpr double from_border = -0.25, to_border = 1.25;
constexpr int ray_columns = 48, ray_rows = 27;

bool near_picture(const ScreenPoint& p, glm::dvec2 size) {
  return p && glm::all(glm::greaterThan(*p, from_border * size)) &&
         glm::all(glm::lessThan(*p, to_border * size));
}

double moved(const ScreenPoint& a, const ScreenPoint& b) {
  return a && b ? glm::length(*b - *a) : 0.0;
}

/// The motion from one moment to the next.
class StepWay {
 public:
  StepWay(const SeenMoment& from, const SeenMoment& to)
      : from_(from.scene->world()), to_(to.scene->world()), seen_(from.view), next_(to.view) {}

  /// Returns the farthest motion of points on edges of triangles with a corner far from the
  /// picture.
  [[nodiscard]] double of_cut_edges(const std::vector<ScreenPoint>& points) const {
    double farthest = 0.0;
    for (const glm::uvec3 t : from_.triangles) {
      const auto is_near = [&](std::uint32_t i) { return near_picture(points[i], seen_.size()); };
      if (is_near(t.x) && is_near(t.y) && is_near(t.z)) continue;
      for (const auto& [a, b] : {std::pair{t.x, t.y}, std::pair{t.y, t.z}, std::pair{t.z, t.x}})
        farthest = std::max(farthest, of_edge(a, b));
    }
    return farthest;
  }

  /// Returns the farthest way of the points that rays meet.
  [[nodiscard]] double of_hits(const SeenMoment& from) const {
    std::vector<Ray> rays;
    const glm::dvec2 size = seen_.size();
    for (int i = 0; i < ray_columns * ray_rows; ++i)
      rays.push_back(from.view.ray(size.x * (i % ray_columns + 0.5) / ray_columns,
                                   size.y * (i / ray_columns + 0.5) / ray_rows));
    std::vector<Hit> hits(rays.size());
    from.scene->rays().closest(rays, hits);
    double farthest = 0.0;
    for (std::size_t i = 0; i < hits.size(); ++i)
      if (hits[i].valid())
        farthest = std::max(farthest, of_point(glm::dvec3(rays[i].at(hits[i].t)), hits[i]));
    return farthest;
  }

 private:
  [[nodiscard]] double of_edge(std::uint32_t a, std::uint32_t b) const {
    const glm::dvec3 p(from_.positions[a]), q(from_.positions[b]);
    const glm::dvec3 h = seen_.homogeneous(p), k = seen_.homogeneous(q);
    double first = 0.0, last = 1.0;
    // Keeps the part of the edge where a linear function is not negative.
    const auto clip = [&](double at_a, double at_b) {
      if (at_a < 0.0 && at_b < 0.0) last = -1.0;
      if (at_a < 0.0 && at_b >= 0.0) first = std::max(first, at_a / (at_a - at_b));
      if (at_a >= 0.0 && at_b < 0.0) last = std::min(last, at_a / (at_a - at_b));
    };
    for (int axis = 0; axis < 2; ++axis) {
      clip(h[axis] - from_border * h.z, k[axis] - from_border * k.z);
      clip(to_border * h.z - h[axis], to_border * k.z - k[axis]);
    }
    double farthest = 0.0;
    for (const double s : {first, 0.5 * (first + last), last}) {
      if (first > last) break;
      const glm::dvec3 then =
          glm::mix(glm::dvec3(to_.positions[a]), glm::dvec3(to_.positions[b]), s);
      farthest = std::max(farthest, moved(seen_.at(glm::mix(p, q, s)), next_.at(then)));
    }
    return farthest;
  }

  [[nodiscard]] double of_point(glm::dvec3 p, const Hit& hit) const {
    return moved(seen_.at(p), next_.at(point_at(from_, to_, p, hit)));
  }

  const World &from_, &to_;
  ScreenProjection seen_, next_;
};

}  // namespace

std::vector<ScreenPoint> screen_points(const World& world, const View& view) {
  const ScreenProjection screen(view);
  std::vector<ScreenPoint> points;
  points.reserve(world.positions.size());
  for (const glm::vec3 p : world.positions) points.push_back(screen.at(glm::dvec3(p)));
  for (const Part& part : world.parts) {
    if (part.face_count == 0) continue;
    const Box& box = part.bounds;
    for (int i = 0; i < 8; ++i)
      points.push_back(screen.at(
          {i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y, i & 4 ? box.hi.z : box.lo.z}));
  }
  return points;
}

glm::dvec3 point_at(const World& from, const World& to, glm::dvec3 p, const Hit& hit) {
  if (from.is_face(hit.triangle))
    return to.face(hit.triangle).world(from.face(hit.triangle).unit(p));
  const glm::uvec3 t = to.triangles[hit.triangle];
  const double b1 = static_cast<double>(hit.b1), b2 = static_cast<double>(hit.b2);
  return (1.0 - b1 - b2) * glm::dvec3(to.positions[t.x]) + b1 * glm::dvec3(to.positions[t.y]) +
         b2 * glm::dvec3(to.positions[t.z]);
}

bool same_surfaces(const World& a, const World& b) {
  // Placed meshes are other objects at each moment.
  if (a.placements || b.placements) return false;
  return a.positions == b.positions && a.normals == b.normals && a.tangents == b.tangents &&
         a.texcoords[0] == b.texcoords[0] && a.texcoords[1] == b.texcoords[1] &&
         a.colors == b.colors && a.triangles == b.triangles && a.faces == b.faces &&
         a.materials == b.materials && a.cameras == b.cameras;
}

bool same_but_moved(const World& a, const World& b) {
  const auto same_mesh = [](const auto& x, const auto& y) {
    return x == y || (x->positions == y->positions && x->triangles == y->triangles);
  };
  const auto same_place = [](const Placement& x, const Placement& y) {
    return x.mesh == y.mesh && x.part == y.part && x.first_triangle == y.first_triangle &&
           x.mirrored == y.mirrored;
  };
  const auto same_face = [](const ShapeFace& x, const ShapeFace& y) {
    return x.kind == y.kind && x.part == y.part;
  };
  const auto same_kind = [](const Material& x, const Material& y) {
    return surface_kind(x) == surface_kind(y) && shows_both_sides(x) == shows_both_sides(y);
  };
  const auto same = [](const auto& x, const auto& y, auto equal) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), equal);
  };
  if (!a.placements != !b.placements) return false;
  return a.positions.size() == b.positions.size() && a.triangles.own() == b.triangles.own() &&
         a.triangle_part.own() == b.triangle_part.own() && same(a.faces, b.faces, same_face) &&
         same(a.materials, b.materials, same_kind) &&
         (!a.placements || (same(a.placements->meshes, b.placements->meshes, same_mesh) &&
                            same(a.placements->places, b.placements->places, same_place)));
}

glm::dvec3 way_of_point(const World& from, const World& to, const Hit& hit) {
  const auto b1 = static_cast<double>(hit.b1), b2 = static_cast<double>(hit.b2);
  if (from.is_face(hit.triangle))
    return face_point(to.face(hit.triangle), b1, b2).position -
           face_point(from.face(hit.triangle), b1, b2).position;
  const glm::uvec3 t = from.triangles[hit.triangle];
  const auto way = [&](std::uint32_t i) {
    return glm::dvec3(to.positions[i]) - glm::dvec3(from.positions[i]);
  };
  return (1.0 - b1 - b2) * way(t.x) + b1 * way(t.y) + b2 * way(t.z);
}

ScreenWay screen_way(std::span<const SeenMoment> moments) {
  ScreenWay way;
  std::vector<ScreenPoint> before =
      screen_points(moments.front().scene->world(), moments.front().view);
  std::vector<double> so_far(before.size(), 0.0);
  double of_others = 0.0;
  for (std::size_t i = 1; i < moments.size(); ++i) {
    const SeenMoment &from = moments[i - 1], &to = moments[i];
    const World &a = from.scene->world(), &b = to.scene->world();
    std::vector<ScreenPoint> after = screen_points(b, to.view);
    if (after.size() != before.size() || a.triangles.size() != b.triangles.size() ||
        a.faces.size() != b.faces.size())
      return {0.0, 0.0, false};
    const glm::dvec2 size(from.view.width(), from.view.height());
    double farthest = 0.0;
    for (std::size_t k = 0; k < after.size(); ++k) {
      if (!near_picture(before[k], size) && !near_picture(after[k], size)) continue;
      const double step = moved(before[k], after[k]);
      farthest = std::max(farthest, step);
      so_far[k] += step;
      way.in_all = std::max(way.in_all, so_far[k]);
    }
    const StepWay step(from, to);
    const double other = std::max(step.of_cut_edges(before), step.of_hits(from));
    of_others += other;
    way.in_step = std::max({way.in_step, farthest, other});
    before = std::move(after);
  }
  way.in_all = std::max(way.in_all, of_others);
  return way;
}

}  // namespace asos
