#include "renderer/rays/coplanar.h"

#include "renderer/load_progress.h"
#include "renderer/rays/coplanar_pairs.h"
#include "renderer/world/surface_kind.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace asos::tracing {
namespace {

// Number of part pairs per part to compare, beyond which all parts count as neighbours.
constexpr std::size_t pairs_of_part = 1024;

/// The boxes of other parts that meet a part's box; `full`: there are more.
struct Neighbours {
  static constexpr std::size_t most = 16;
  std::vector<Box> boxes;
  std::vector<Box> placed;  ///< boxes of placed meshes, kept apart
  bool full = false;

  void add(const Box& box, bool is_placed) {
    if (is_placed) {
      // Further boxes are merged into the last one.
      if (placed.size() < most)
        placed.push_back(box);
      else
        placed.back().grow(box);
    }
    if (boxes.size() < most) {
      boxes.push_back(box);
    } else {
      full = true;
    }
  }
};

std::vector<Neighbours> neighbours_of(const World& world) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < world.solid_parts(); ++i) {
    const Box& box = world.parts[i].bounds;
    boxes.push_back(box.empty() ? box : enlarged(box, world.origin));
  }
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::erase_if(order, [&](std::uint32_t i) { return boxes[i].empty(); });
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return boxes[a].lo.x < boxes[b].lo.x; });
  std::vector<Neighbours> found(boxes.size());
  const auto placed = [&](std::uint32_t part) {
    return world.is_placed(world.parts[part].first_triangle);
  };
  std::size_t pairs = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    stop_point();
    const Box& own = boxes[order[k]];
    for (std::size_t m = k + 1; m < order.size() && boxes[order[m]].lo.x <= own.hi.x; ++m) {
      if (++pairs > pairs_of_part * order.size()) {
        Neighbours all;
        all.full = true;
        all.boxes.push_back(Box{});
        if (world.placements) all.placed.push_back(world.bounds);
        std::fill(found.begin(), found.end(), all);
        return found;
      }
      if (!meet(own, boxes[order[m]])) continue;
      found[order[k]].add(boxes[order[m]], placed(order[m]));
      found[order[m]].add(own, placed(order[k]));
    }
  }
  return found;
}

/// The triangles whose partners are not known.
class OpenTriangles {
 public:
  /// Opens all triangles of a world.
  explicit OpenTriangles(const World& world) : world_(world), all_(true), box_(world.bounds) {}
  /// Opens some parts, by part, and single triangles.
  OpenTriangles(const World& world, std::vector<std::uint8_t> parts,
                std::vector<std::uint32_t> single)
      : world_(world), parts_(std::move(parts)), single_(std::move(single)) {
    std::sort(single_.begin(), single_.end());
    for (std::size_t i = 0; i < world.solid_parts(); ++i) {
      const Part& part = world.parts[i];
      const bool own = part.triangle_count > 0 && !world.is_placed(part.first_triangle);
      if (parts_[i] && own && !part.bounds.empty()) box_.grow(enlarged(part.bounds, world.origin));
    }
    for (const std::uint32_t triangle : single_) box_.grow(boxed(world, triangle).box);
    for (const Part& part : world.parts)
      near_.push_back(!part.bounds.empty() && !box_.empty() &&
                      meet(enlarged(part.bounds, world.origin), box_));
  }

  [[nodiscard]] bool is_open(std::uint32_t triangle) const {
    return all_ || parts_[world_.triangle_part[triangle]] != 0 ||
           std::binary_search(single_.begin(), single_.end(), triangle);
  }
  /// Returns whether a triangle is open, or its part is near an open one.
  [[nodiscard]] bool concerns(std::uint32_t triangle) const {
    return all_ || near_[world_.triangle_part[triangle]] != 0;
  }
  /// Returns a box around the open triangles.
  [[nodiscard]] const Box& box() const { return box_; }

 private:
  const World& world_;
  bool all_ = false;
  std::vector<std::uint8_t> parts_, near_;  // by part
  std::vector<std::uint32_t> single_;       // ascending
  Box box_;
};

/// The marks of a world, for another world that has some of its parts.
class KnownMarks {
 public:
  KnownMarks(const World& world, const World& before) : world_(world), before_(before) {
    std::unordered_map<std::uint64_t, std::size_t> parts;
    for (std::size_t i = 0; i < world.parts.size(); ++i)
      if (world.parts[i].surfaces != 0) parts.emplace(world.parts[i].surfaces, i);
    part_now_.assign(before.parts.size(), none_);
    is_new_.assign(world.parts.size(), 1);
    for (std::size_t i = 0; i < before.parts.size(); ++i) {
      const auto now = parts.find(before.parts[i].surfaces);
      if (now == parts.end()) continue;
      part_now_[i] = now->second;
      is_new_[now->second] = 0;
    }
  }

  /// Adds the marks that still hold, and returns the triangles to search for.
  [[nodiscard]] OpenTriangles take(const Coplanar& known, Coplanar& found) {
    std::vector<std::uint32_t> single;
    for (const Partner& partner : known.partners) {
      const std::uint32_t triangle = now(partner.triangle), other = now(partner.other);
      if (triangle == Hit::none) continue;
      if (other == Hit::none) {
        single.push_back(triangle);
        continue;
      }
      found.by_triangle[triangle] = 1;
      found.partners.push_back({triangle, other});
    }
    return {world_, std::move(is_new_), std::move(single)};
  }

 private:
  static constexpr std::size_t none_ = ~std::size_t{0};

  /// Returns the present number of a triangle; Hit::none: it is gone.
  [[nodiscard]] std::uint32_t now(std::uint32_t triangle) const {
    const std::size_t before = before_.triangle_part[triangle];
    if (part_now_[before] == none_) return Hit::none;
    return triangle - before_.parts[before].first_triangle +
           world_.parts[part_now_[before]].first_triangle;
  }

  const World& world_;
  const World& before_;
  std::vector<std::size_t> part_now_;  // by part before
  std::vector<std::uint8_t> is_new_;   // by part
};

bool meets_any(const Box& box, const std::vector<Box>& others) {
  return std::any_of(others.begin(), others.end(), [&](const Box& b) { return meet(box, b); });
}

}  // namespace

Coplanar find_coplanar(const World& world, const World* known_world, const Coplanar* known) {
  const std::vector<Neighbours> neighbours = neighbours_of(world);
  const auto none = [](const Neighbours& n) { return n.boxes.empty(); };
  if (std::all_of(neighbours.begin(), neighbours.end(), none)) return {};
  Coplanar found;
  found.by_triangle.resize(world.triangles.own_size());
  const OpenTriangles open =
      known ? KnownMarks(world, *known_world).take(*known, found) : OpenTriangles(world);
  std::vector<BoxedTriangle> near;
  std::size_t most = 0;
  for (std::size_t i = 0; i < neighbours.size(); ++i)
    if (!none(neighbours[i])) most += world.parts[i].triangle_count;
  if (!known) near.reserve(std::min(most, found.by_triangle.size()));
  const std::size_t solid = found.by_triangle.size() - world.lines_and_points.triangle_count;
  constexpr std::uint32_t between_stops = 4096;
  for (std::uint32_t i = 0; i < solid; ++i) {
    if (i % between_stops == 0) stop_point();
    const Neighbours& around = neighbours[world.triangle_part[i]];
    if (none(around) || (around.placed.empty() && !open.concerns(i))) continue;
    if (normal_of(corners_of(world, i)) == glm::dvec3(0.0)) continue;
    BoxedTriangle triangle = boxed(world, i);
    triangle.open = open.is_open(i);
    if (meets_any(triangle.box, around.placed)) found.by_triangle[i] = 1;
    if (!triangle.open && !meet(triangle.box, open.box())) continue;
    if (around.full || meets_any(triangle.box, around.boxes)) near.push_back(triangle);
  }
  found.compared = mark_coplanar(world, std::move(near), found.by_triangle, found.partners);
  if (world.placements) {
    for (const Placement& place : world.placements->places)
      found.by_place.push_back(!neighbours[place.part].boxes.empty());
  }
  const auto set = [](std::uint8_t flag) { return flag != 0; };
  if (std::none_of(found.by_triangle.begin(), found.by_triangle.end(), set) &&
      std::none_of(found.by_place.begin(), found.by_place.end(), set))
    found.by_triangle.clear(), found.by_place.clear();
  return found;
}

float reach_of_hit(const World& world, const Ray& ray, const Hit& hit) {
  const Corners corners = corners_of(world, hit.triangle);
  const glm::dvec3 normal = normal_of(corners);
  const double length = glm::length(normal), speed = glm::length(glm::dvec3(ray.direction));
  const auto size = static_cast<double>(size_of(world, hit.triangle));
  const glm::dvec3 rounding = rounding_of(corners, corners, world.origin, size);
  // Limits the reach for planes seen edge-on to 64 times that from the front.
  constexpr double least_cosine = 1.0 / 64.0;
  const double across = std::abs(glm::dot(normal, glm::dvec3(ray.direction)));
  const double apart = length > 0.0 ? glm::dot(glm::abs(normal), rounding) / length : 0.0;
  const double cosine = length > 0.0 ? across / (length * speed) : 1.0;
  constexpr double ulps = 8.0 * std::numeric_limits<float>::epsilon();
  return static_cast<float>(2.0 * apart / (std::max(cosine, least_cosine) * speed) +
                            ulps * static_cast<double>(hit.t));
}

bool in_front(const World& world, const Hit& a, const Hit& b) {
  const auto opaque = [&](const Hit& hit) {
    return surface_kind(world.material_of(hit.triangle)) == SurfaceKind::opaque;
  };
  const bool first = opaque(a), second = opaque(b);
  if (first != second) return second;
  // Placed triangles come last, independent of their part's place in the file.
  const std::uint32_t p = world.triangle_part[a.triangle], q = world.triangle_part[b.triangle];
  return p != q ? p > q : a.triangle > b.triangle;
}

void collecting_filter(const RTCFilterFunctionNArguments* args) {
  const Context& context = *reinterpret_cast<const Context*>(args->context);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] != -1) continue;
    args->valid[i] = 0;
    Hit hit = context.geometries.hit(*args, i);
    hit.t = RTCRayN_tfar(args->ray, args->N, i) / context.scale;
    const glm::vec3 direction = context.geometries.direction(*args, i);
    if (hit.valid() && !(context.culls && context.sides.culled(hit, direction)))
      context.met->push_back(hit);
  }
}

}  // namespace asos::tracing
