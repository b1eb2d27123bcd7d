#include "renderer/rays/coplanar.h"

#include "renderer/tasks.h"
#include "renderer/world/surface_kind.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace asos::tracing {
namespace {

// Distances below this fraction of the coordinates are rounding errors, as for intersection lines
// (intersections.cpp).
constexpr double rounding_share = 4e-7;

// Limits for one triangle: the number of triangles of its size or larger to compare, and of any
// size that it meets. Beyond them it counts as coplanar to some of them.
constexpr std::size_t most_compared = 1024;
constexpr std::size_t most_met = std::size_t{1} << 20;
// Number of part pairs per part to compare, beyond which all parts count as neighbours.
constexpr std::size_t pairs_of_part = 1024;

using Corners = std::array<glm::dvec3, 3>;

Corners corners_of(const World& world, std::uint32_t triangle) {
  const glm::uvec3 t = world.triangles[triangle];
  return {glm::dvec3(world.positions[t.x]), glm::dvec3(world.positions[t.y]),
          glm::dvec3(world.positions[t.z])};
}

glm::dvec3 normal_of(const Corners& t) {
  return glm::cross(t[1] - t[0], t[2] - t[0]);
}

/// Returns the largest side of a triangle's box.
float size_of(const World& world, std::uint32_t triangle) {
  const glm::uvec3 t = world.triangles[triangle];
  const glm::vec3 a = world.positions[t.x], b = world.positions[t.y], c = world.positions[t.z];
  const glm::vec3 d = glm::max(a, glm::max(b, c)) - glm::min(a, glm::min(b, c));
  return std::max({d.x, d.y, d.z});
}

/// Returns the largest rounding error of two triangles' corners, by axis.
glm::dvec3 rounding_of(const Corners& s, const Corners& t, glm::dvec3 origin, double size) {
  glm::dvec3 largest(0.0);
  for (std::size_t i = 0; i < 3; ++i)
    largest = glm::max(largest, glm::max(glm::abs(s[i]), glm::abs(t[i])));
  return rounding_share * (largest + glm::abs(origin) + size);
}

/// Returns whether two coplanar triangles, projected along an axis, overlap by more than `least`.
bool overlap(const Corners& s, const Corners& t, int axis, double least) {
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  const auto separates = [&](const Corners& of, const Corners& other) {
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 side = of[(i + 1) % 3] - of[i];
      const double length = std::hypot(side[x], side[y]);
      if (!(length > 0.0)) continue;
      const auto height = [&](const glm::dvec3& p) {
        const glm::dvec3 d = p - of[i];
        return (side[x] * d[y] - side[y] * d[x]) / length;
      };
      const double inner = height(of[(i + 2) % 3]) < 0.0 ? -1.0 : 1.0;
      double highest = -std::numeric_limits<double>::infinity();
      for (const glm::dvec3& p : other) highest = std::max(highest, inner * height(p));
      if (highest <= least) return true;
    }
    return false;
  };
  return !separates(s, t) && !separates(t, s);
}

/// Returns whether a triangle lies in the plane of one of its size or larger, and overlaps it.
bool coplanar(const Corners& small, const Corners& large, glm::dvec3 origin, double size) {
  const glm::dvec3 normal = normal_of(large);
  const glm::dvec3 axes = glm::abs(normal);
  const glm::dvec3 rounding = rounding_of(small, large, origin, size);
  const double nothing = glm::dot(axes, rounding);
  if (!(glm::dot(axes, axes) > 0.0) || normal_of(small) == glm::dvec3(0.0)) return false;
  for (const glm::dvec3& p : small)
    if (std::abs(glm::dot(normal, p - large[0])) > nothing) return false;
  const int axis = axes.x >= axes.y && axes.x >= axes.z ? 0 : axes.y >= axes.z ? 1 : 2;
  return overlap(small, large, axis, 2.0 * std::max({rounding.x, rounding.y, rounding.z}));
}

bool meet(const Box& a, const Box& b) {
  return glm::all(glm::lessThanEqual(a.lo, b.hi)) && glm::all(glm::lessThanEqual(b.lo, a.hi));
}

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
    Box box = world.parts[i].bounds;
    if (!box.empty()) {
      const glm::vec3 size = glm::max(glm::abs(box.lo), glm::abs(box.hi)) + (box.hi - box.lo);
      const glm::vec3 room = 2e-6f * (size + glm::vec3(glm::abs(world.origin)));
      box.lo -= room, box.hi += room;
    }
    boxes.push_back(box);
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

/// Compares triangles with those around them.
class CoplanarSearch {
 public:
  CoplanarSearch(const World& world, RTCScene scene, const Group* groups, float scale)
      : world_(world), scene_(scene), groups_(groups), scale_(scale) {}

  Coplanar run() {
    const std::vector<Neighbours> neighbours = neighbours_of(world_);
    const auto none = [](const Neighbours& n) { return n.boxes.empty(); };
    if (std::all_of(neighbours.begin(), neighbours.end(), none)) return {};
    const std::size_t own = world_.triangles.own().size();
    found_.assign(own, 0);
    constexpr std::size_t at_a_time = 256;
    sizes_.resize(own);
    in_task_ranges(own, at_a_time, [&](auto begin, auto end) {
      for (std::size_t i = begin; i < end; ++i)
        sizes_[i] = size_of(world_, static_cast<std::uint32_t>(i));
    });
    in_task_ranges(own - world_.lines_and_points.triangle_count, at_a_time,
                   [&](auto begin, auto end) {
                     for (std::size_t i = begin; i < end; ++i) {
                       const auto triangle = static_cast<std::uint32_t>(i);
                       const Neighbours& around = neighbours[world_.triangle_part[triangle]];
                       if (!around.placed.empty() && meets_any(triangle, around.placed))
                         mark(triangle);
                       else if (around.full || meets_any(triangle, around.boxes))
                         look(triangle);
                     }
                   });
    Coplanar all{std::move(found_), {}};
    if (world_.placements) {
      for (const Placement& place : world_.placements->places)
        all.by_place.push_back(!neighbours[place.part].boxes.empty());
    }
    const auto set = [](std::uint8_t flag) { return flag != 0; };
    if (std::none_of(all.by_triangle.begin(), all.by_triangle.end(), set) &&
        std::none_of(all.by_place.begin(), all.by_place.end(), set))
      return {};
    return all;
  }

 private:
  struct Query {
    CoplanarSearch* search;
    std::uint32_t triangle;
    std::uint32_t part;
    float size;
    Corners corners;
    std::size_t met = 0;
    std::size_t compared = 0;
  };

  [[nodiscard]] bool meets_any(std::uint32_t triangle, const std::vector<Box>& boxes) const {
    Box box;
    const glm::uvec3 t = world_.triangles[triangle];
    for (int k = 0; k < 3; ++k) box.grow(world_.positions[t[k]]);
    return std::any_of(boxes.begin(), boxes.end(),
                       [&](const Box& other) { return meet(box, other); });
  }

  // Compares a triangle with those around it that are of its size or larger. In a pair, the smaller
  // one finds the other.
  void look(std::uint32_t triangle) {
    Query query{this, triangle, world_.triangle_part[triangle], sizes_[triangle],
                corners_of(world_, triangle)};
    if (normal_of(query.corners) == glm::dvec3(0.0)) return;
    const glm::dvec3 middle = (query.corners[0] + query.corners[1] + query.corners[2]) / 3.0;
    double radius = 0.0;
    for (const glm::dvec3& p : query.corners) radius = std::max(radius, glm::distance(p, middle));
    const glm::dvec3 centre = middle * static_cast<double>(scale_);
    constexpr double room = 1.0 + 1e-5;
    RTCPointQuery around{};
    around.x = static_cast<float>(centre.x);
    around.y = static_cast<float>(centre.y);
    around.z = static_cast<float>(centre.z);
    around.radius = static_cast<float>(room * radius * static_cast<double>(scale_));
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    (void)rtcPointQuery(scene_, &around, &context, compare, &query);
  }

  static bool compare(RTCPointQueryFunctionArguments* args) {
    Query& query = *static_cast<Query*>(args->userPtr);
    CoplanarSearch& search = *query.search;
    const World& world = search.world_;
    const auto give_up = [&] {
      search.mark(query.triangle);
      args->query->radius = 0.0f;
      return true;
    };
    if (++query.met > most_met) return give_up();
    // Triangles near a placed mesh are marked without a search.
    if (args->context->instStackSize > 0) return false;
    const std::uint32_t other = search.groups_[args->geomID].triangle(args->primID);
    if (world.is_face(other) || world.triangle_part[other] == query.part ||
        other >= world.solid_triangles() || search.sizes_[other] < query.size)
      return false;
    if (++query.compared > most_compared) return give_up();
    if (coplanar(query.corners, corners_of(world, other), world.origin,
                 static_cast<double>(query.size))) {
      search.mark(query.triangle);
      search.mark(other);
    }
    return false;
  }

  void mark(std::uint32_t triangle) {
    std::atomic_ref<std::uint8_t>(found_[triangle]).store(1, std::memory_order_relaxed);
  }

  const World& world_;
  RTCScene scene_;
  const Group* groups_;
  float scale_;
  std::vector<std::uint8_t> found_;
  std::vector<float> sizes_;  // of the world's own triangles
};

}  // namespace

Coplanar find_coplanar(const World& world, RTCScene scene, const Group* groups, float scale) {
  return CoplanarSearch(world, scene, groups, scale).run();
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
    if (!(context.culls && context.sides->culled(hit, direction))) context.met->push_back(hit);
  }
}

}  // namespace asos::tracing
