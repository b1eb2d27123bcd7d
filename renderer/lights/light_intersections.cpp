#include "renderer/lights/light_intersections.h"

#include "renderer/geometry/clip_segment.h"
#include "renderer/geometry/cross.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace asos {
namespace {

// Neighbouring triangles of a mesh are near each other in space, so one box test replaces a test of
// each.
constexpr std::size_t run_length = 64;
// Pieces are kept up to this far outside the light's bounding rectangle, in half edges, so that
// they are straight across its border.
constexpr double margin = 1.0 / 16.0;
// A point within this distance of the light's plane, in sizes of the light, or of its outline, in
// half edges, lies on it. Rays end closer to the light.
constexpr double touching = 1e-6;
// Largest error of a vertex' position by roundings of float32.
constexpr double place_error = 2.4e-7;

struct Piece {
  glm::dvec2 p, q;  // in half edges from the light's centre

  [[nodiscard]] glm::dvec2 at(double t) const { return p + t * (q - p); }
};

/// Returns the part of a piece within `reach` half edges of the centre.
std::optional<Piece> clipped(const Piece& piece, double reach) {
  const SegmentPart<double> part =
      clip_segment<double>(piece.p, piece.q - piece.p, glm::dvec2(-reach), glm::dvec2(reach));
  if (part.empty()) return std::nullopt;
  return Piece{piece.at(part.t0), piece.at(part.t1)};
}

class CutLight {
 public:
  explicit CutLight(const PreparedLight& light) : light_(light) {
    flat_ = light_.traits().flat && light_.casts_shadows;
    if (!flat_) return;
    const glm::dvec3 reach = glm::abs(light_.half_u) + glm::abs(light_.half_v);
    const glm::dvec3 farthest = glm::abs(light_.position) + reach;
    tolerance_ = touching * std::max(glm::length(light_.half_u), glm::length(light_.half_v)) +
                 place_error * std::max({farthest.x, farthest.y, farthest.z});
    // Twice, since the box is rounded to float32 as well.
    const glm::dvec3 around = reach + 2.0 * tolerance_;
    box_.grow(glm::vec3(light_.position - around));
    box_.grow(glm::vec3(light_.position + around));
    for (const auto& outline : light_.outlines) {
      for (std::size_t i = 0; i < outline.size(); ++i)
        sides_.push_back({placed(outline[i]), placed(outline[(i + 1) % outline.size()])});
    }
  }

  [[nodiscard]] bool meets(const Box& box) const {
    return flat_ && glm::all(glm::lessThanEqual(box.lo, box_.hi)) &&
           glm::all(glm::lessThanEqual(box_.lo, box.hi));
  }
  [[nodiscard]] bool owns(std::uint32_t part) const {
    return light_.own_part == static_cast<std::int32_t>(part);
  }

  [[nodiscard]] std::optional<LightIntersection> cut_by(
      const std::array<glm::vec3, 3>& corners) const {
    const auto crossing = crossing_of(corners);
    if (!crossing) return std::nullopt;
    const auto piece = clipped(*crossing, 1.0 + margin);
    if (!piece || !counts(*piece)) return std::nullopt;
    return LightIntersection{in_world(piece->p), in_world(piece->q)};
  }

  /// Returns whether any of the light intersections passes through the light itself.
  [[nodiscard]] bool cut_by_any(const std::vector<LightIntersection>& cuts) const {
    if (light_.shape != LightShape::disk) return !cuts.empty();
    return std::any_of(cuts.begin(), cuts.end(), [&](const LightIntersection& cut) {
      const Piece piece{placed(cut.from), placed(cut.to)};
      const glm::dvec2 d = piece.q - piece.p;
      const double t = std::clamp(-glm::dot(piece.p, d) / glm::dot(d, d), 0.0, 1.0);
      return glm::length(piece.at(t)) < 1.0 - touching;
    });
  }

 private:
  [[nodiscard]] glm::dvec2 placed(glm::dvec3 p) const {
    const glm::dvec3 d = p - light_.position;
    return {glm::dot(d, light_.half_u) / glm::dot(light_.half_u, light_.half_u),
            glm::dot(d, light_.half_v) / glm::dot(light_.half_v, light_.half_v)};
  }
  [[nodiscard]] glm::dvec3 in_world(glm::dvec2 p) const {
    return light_.position + p.x * light_.half_u + p.y * light_.half_v;
  }

  // Returns the line where a triangle meets the light's plane, if there is one on the emitting
  // side.
  [[nodiscard]] std::optional<Piece> crossing_of(const std::array<glm::vec3, 3>& corners) const {
    std::array<double, 3> height;
    int above = 0, below = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      height[i] = glm::dot(light_.towards, glm::dvec3(corners[i]) - light_.position);
      if (std::abs(height[i]) <= tolerance_) height[i] = 0.0;
      above += height[i] > 0.0;
      below += height[i] < 0.0;
    }
    if (above == 3 || below == 3 || (above == 0 && (below == 0 || !light_.two_sided)))
      return std::nullopt;
    std::array<glm::dvec2, 3> met;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (i + 1) % 3;
      const glm::dvec3 p(corners[i]), q(corners[k]);
      if (height[i] == 0.0) met[count++] = placed(p);
      if (height[i] * height[k] < 0.0)
        met[count++] = placed(p + height[i] / (height[i] - height[k]) * (q - p));
    }
    if (count != 2) return std::nullopt;
    return Piece{met[0], met[1]};
  }

  // Returns whether a piece bounds the visible part of the light, and does not only run along the
  // outline.
  [[nodiscard]] bool counts(const Piece& piece) const {
    const auto inner = clipped(piece, 1.0 - touching);
    if (!inner) return false;
    // A disk's rim does not bound its visible part, so a piece that ends there would have a loose
    // end.
    if (light_.shape != LightShape::polygon) return true;
    bool crosses = false, inside = false;
    const glm::dvec2 middle = inner->at(0.5);
    for (const Piece& side : sides_) {
      if (along(side, *inner)) return false;
      const auto left_of = [](const Piece& line, glm::dvec2 p) {
        return cross(line.q - line.p, p - line.p) > 0.0;
      };
      crosses |= left_of(side, inner->p) != left_of(side, inner->q) &&
                 left_of(*inner, side.p) != left_of(*inner, side.q);
      const glm::dvec2 a = side.p, b = side.q;
      inside ^= (a.y > middle.y) != (b.y > middle.y) &&
                middle.x < a.x + (b.x - a.x) * (middle.y - a.y) / (b.y - a.y);
    }
    return crosses || inside;
  }

  [[nodiscard]] static bool along(const Piece& side, const Piece& piece) {
    const glm::dvec2 d = side.q - side.p;
    const double length = glm::length(d);
    for (const glm::dvec2 p : {piece.p, piece.q}) {
      const double t = glm::dot(p - side.p, d) / (length * length);
      if (!(std::abs(cross(d, p - side.p)) <= 8.0 * touching * length) ||
          std::abs(t - 0.5) > 0.5 + 8.0 * touching / length)
        return false;
    }
    return true;
  }

  const PreparedLight& light_;
  bool flat_ = false;
  double tolerance_ = 0.0;
  Box box_;
  std::vector<Piece> sides_;
};

double distance_to_segment(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b) {
  const glm::dvec3 d = b - a;
  const double length2 = glm::dot(d, d);
  const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, d) / length2, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + t * d);
}

double distance_to_triangle(glm::dvec3 p, const std::array<glm::vec3, 3>& corners) {
  const glm::dvec3 a(corners[0]), b(corners[1]), c(corners[2]);
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const auto inside_of = [&](glm::dvec3 from, glm::dvec3 to) {
    return glm::dot(glm::cross(to - from, p - from), normal) >= 0.0;
  };
  const double size = glm::length(normal);
  if (size > 0.0 && inside_of(a, b) && inside_of(b, c) && inside_of(c, a))
    return std::abs(glm::dot(p - a, normal)) / size;
  return std::min(
      {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

std::array<glm::vec3, 3> corners_of(const World& world, std::size_t triangle) {
  const glm::uvec3 t = world.triangles[triangle];
  return {world.positions[t.x], world.positions[t.y], world.positions[t.z]};
}

Box box_of(const World& world, std::size_t triangle) {
  Box box;
  for (const glm::vec3& corner : corners_of(world, triangle)) box.grow(corner);
  return box;
}

/// Calls visit(first, end) with runs of all triangles. For placed meshes, includes only parts whose
/// boxes are nearby.
template <typename Near, typename Visit>
void visit_runs(const World& world, const Near& is_near, const Visit& visit) {
  const auto in_runs = [&](std::size_t first, std::size_t end) {
    for (; first < end; first += run_length) visit(first, std::min(end, first + run_length));
  };
  in_runs(0, world.triangles.own().size());
  if (!world.placements) return;
  for (const Placement& place : world.placements->places) {
    const Part& part = world.parts[place.part];
    if (is_near(part.bounds))
      in_runs(part.first_triangle, part.first_triangle + part.triangle_count);
  }
}

}  // namespace

LightIntersections find_light_intersections(const World& world,
                                            std::span<const PreparedLight> prepared) {
  LightIntersections cuts(prepared.size());
  const std::vector<CutLight> lights(prepared.begin(), prepared.end());
  const auto near_any = [&](const Box& box) {
    return std::any_of(lights.begin(), lights.end(),
                       [&](const CutLight& light) { return light.meets(box); });
  };
  if (!lights.empty())
    visit_runs(world, near_any, [&](std::size_t first, std::size_t end) {
      std::array<Box, run_length> boxes;
      Box run;
      for (std::size_t i = first; i < end; ++i) run.grow(boxes[i - first] = box_of(world, i));
      for (std::size_t k = 0; k < lights.size(); ++k) {
        if (!lights[k].meets(run)) continue;
        for (std::size_t i = first; i < end && cuts[k].size() < most_light_intersections; ++i) {
          if (lights[k].owns(world.triangle_part[i]) || !lights[k].meets(boxes[i - first]))
            continue;
          if (const auto cut = lights[k].cut_by(corners_of(world, i))) cuts[k].push_back(*cut);
        }
      }
    });
  for (std::size_t k = 0; k < lights.size(); ++k) {
    if (cuts[k].size() < most_light_intersections && !lights[k].cut_by_any(cuts[k]))
      cuts[k].clear();
  }
  return cuts;
}

namespace {

/// Returns the smallest value of a convex function on the axis of a ball or capsule.
template <typename F>
double least_on_axis(const PreparedLight& light, F&& value) {
  if (light.half_u == glm::dvec3(0.0)) return value(light.position);
  const auto at = [&](double t) { return value(light.position + t * light.half_u); };
  double low = -1.0, high = 1.0;
  for (int i = 0; i < 40; ++i) {  // each third of the interval that cannot hold the minimum goes
    const double a = (2.0 * low + high) / 3.0, b = (low + 2.0 * high) / 3.0;
    (at(a) < at(b) ? high : low) = at(a) < at(b) ? b : a;
  }
  return at(0.5 * (low + high));
}

}  // namespace

std::vector<bool> find_entered_balls(const World& world, std::span<const PreparedLight> lights) {
  std::vector<bool> entered(lights.size(), false);
  std::vector<std::size_t> balls;
  for (std::size_t k = 0; k < lights.size(); ++k)
    if (lights[k].traits().has_surface() && !lights[k].traits().flat && lights[k].casts_shadows)
      balls.push_back(k);
  const auto reaches = [&](std::size_t k, const Box& box) {
    const PreparedLight& light = lights[k];
    const double nearest = least_on_axis(light, [&](glm::dvec3 p) {
      return glm::distance(p, glm::clamp(p, glm::dvec3(box.lo), glm::dvec3(box.hi)));
    });
    return nearest < (1.0 - touching) * light.radius;
  };
  const auto near_any = [&](const Box& box) {
    return std::any_of(balls.begin(), balls.end(), [&](std::size_t k) { return reaches(k, box); });
  };
  const auto look_at = [&](std::size_t i) {
    const Box box = box_of(world, i);
    for (const std::size_t k : balls) {
      const PreparedLight& light = lights[k];
      if (entered[k] || light.own_part == static_cast<std::int32_t>(world.triangle_part[i]))
        continue;
      if (!reaches(k, box)) continue;
      const auto corners = corners_of(world, i);
      const double nearest =
          least_on_axis(light, [&](glm::dvec3 p) { return distance_to_triangle(p, corners); });
      entered[k] = nearest < (1.0 - touching) * light.radius;
    }
  };
  if (!balls.empty())
    visit_runs(world, near_any, [&](std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i) look_at(i);
    });
  return entered;
}

}  // namespace asos
