#include "renderer/rays/coplanar_pairs.h"

#include "renderer/load_progress.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace asos::tracing {
namespace {

// Distances below this fraction of the coordinates are rounding errors, as for intersection lines
// (intersections.cpp).
constexpr double rounding_share = 4e-7;

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
bool lies_in(const Corners& small, const Corners& large, glm::dvec3 origin, double size) {
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

/// Returns an upper bound on the distance, by axis, of a triangle from the place where it overlaps
/// a coplanar one. The bounds of both triangles are added.
double room_of(const Box& box, glm::dvec3 origin) {
  const glm::dvec3 lo(box.lo), hi(box.hi), size = hi - lo;
  const glm::dvec3 most =
      glm::max(glm::abs(lo), glm::abs(hi)) + glm::abs(origin) + std::max({size.x, size.y, size.z});
  constexpr double rounding_of_boxes = 1.01;
  return rounding_of_boxes * rounding_share * (most.x + most.y + most.z);
}

glm::vec3 as_floats(glm::dvec3 p) {
  constexpr double most = std::numeric_limits<float>::max();
  return glm::vec3(glm::clamp(p, -most, most));
}

Box box_of(const World& world, std::uint32_t triangle) {
  Box box;
  const glm::uvec3 t = world.triangles[triangle];
  for (int k = 0; k < 3; ++k) box.grow(world.positions[t[k]]);
  return box;
}

/// A triangle with the directions in which it may be apart from a box: its normal and the normals
/// of its edges in its plane.
class Query {
 public:
  Query(const World& world, const BoxedTriangle& item) : item_(item) {
    const Corners corners = corners_of(world, item.triangle);
    const double room = room_of(box_of(world, item.triangle), world.origin);
    const glm::dvec3 normal = normal_of(corners);
    axes_[0].direction = normal;
    for (std::size_t i = 0; i < 3; ++i)
      axes_[i + 1].direction = glm::cross(normal, corners[(i + 1) % 3] - corners[i]);
    for (Axis& axis : axes_) {
      const double more = room * glm::dot(glm::abs(axis.direction), glm::dvec3(1.0));
      for (const glm::dvec3& p : corners) {
        const double at = glm::dot(axis.direction, p);
        axis.lo = std::min(axis.lo, at - more);
        axis.hi = std::max(axis.hi, at + more);
      }
    }
  }

  [[nodiscard]] const BoxedTriangle& item() const { return item_; }
  [[nodiscard]] bool meets(const Box& box) const {
    if (!meet(item_.box, box)) return false;
    const glm::dvec3 lo(box.lo), hi(box.hi);
    const glm::dvec3 middle = 0.5 * (lo + hi), half = 0.5 * (hi - lo);
    return std::none_of(axes_.begin(), axes_.end(), [&](const Axis& axis) {
      const double at = glm::dot(axis.direction, middle);
      const double reach = glm::dot(glm::abs(axis.direction), half);
      return at + reach < axis.lo || at - reach > axis.hi;
    });
  }

 private:
  struct Axis {
    glm::dvec3 direction{0.0};
    double lo = std::numeric_limits<double>::infinity();
    double hi = -std::numeric_limits<double>::infinity();
  };
  BoxedTriangle item_;
  std::array<Axis, 4> axes_;
};

/// The hierarchy, and its traversal against itself.
class PairSearch {
 public:
  PairSearch(const World& world, std::vector<BoxedTriangle> triangles,
             std::vector<std::uint8_t>& marks, std::vector<Partner>& partners)
      : world_(world), marks_(marks), partners_(partners), items_(std::move(triangles)) {
    const glm::dvec3 origin = glm::abs(world.origin);
    least_ = static_cast<float>(2.0 * rounding_share * std::max({origin.x, origin.y, origin.z}));
  }

  std::size_t run() {
    if (items_.empty()) return 0;
    nodes_.push_back(node_of(0, static_cast<std::uint32_t>(items_.size())));
    compare_within(0);
    return compared_;
  }

 private:
  static constexpr std::uint32_t leaf_size = 4;
  static constexpr std::uint32_t none = ~0u;

  struct Node {
    Box box;
    float diameter = 0.0f;    // the largest of its triangles
    std::uint32_t first = 0;  // item
    std::uint32_t count = 0;
    std::uint32_t child = none;  // the first of two; none: not split
    std::uint32_t part = none;   // none: several
    bool marked = false;         // all its triangles are
    bool open = false;           // some of its triangles are

    [[nodiscard]] bool is_leaf() const { return count <= leaf_size; }
    [[nodiscard]] float size() const {
      const glm::vec3 d = 0.5f * box.hi - 0.5f * box.lo;
      return std::max({d.x, d.y, d.z});
    }
  };

  [[nodiscard]] std::span<BoxedTriangle> items_of(const Node& node) {
    return std::span(items_).subspan(node.first, node.count);
  }

  [[nodiscard]] Node node_of(std::uint32_t first, std::uint32_t count) {
    Node node;
    node.first = first, node.count = count;
    node.part = items_[first].part;
    for (const BoxedTriangle& item : items_of(node)) {
      node.box.grow(item.box);
      node.diameter = std::max(node.diameter, item.diameter);
      if (item.part != node.part) node.part = none;
      node.open = node.open || item.open;
    }
    return node;
  }

  /// Splits a node at the middle of its boxes' centres, or by count if that leaves one side almost
  /// empty.
  void split(std::uint32_t index) {
    if (nodes_[index].child != none) return;
    stop_point();
    const Node node = nodes_[index];
    const std::span<BoxedTriangle> items = items_of(node);
    const auto centre = [](const BoxedTriangle& item) {
      return 0.5f * item.box.lo + 0.5f * item.box.hi;
    };
    Box centres;
    for (const BoxedTriangle& item : items) centres.grow(centre(item));
    const glm::vec3 size = 0.5f * centres.hi - 0.5f * centres.lo;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const float middle = 0.5f * centres.lo[axis] + 0.5f * centres.hi[axis];
    const auto end = std::partition(items.begin(), items.end(), [&](const BoxedTriangle& item) {
      return centre(item)[axis] < middle;
    });
    auto first = static_cast<std::uint32_t>(end - items.begin());
    constexpr std::uint32_t uneven = 8;
    if (std::min(first, node.count - first) < 1 + node.count / uneven) {
      first = node.count / 2;
      std::nth_element(items.begin(), items.begin() + first, items.end(),
                       [&](const BoxedTriangle& a, const BoxedTriangle& b) {
                         return centre(a)[axis] < centre(b)[axis];
                       });
    }
    nodes_[index].child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(node_of(node.first, first));
    nodes_.push_back(node_of(node.first + first, node.count - first));
  }

  /// Returns false for triangles, or nodes, that are not open, apart, or too small to overlap by
  /// more than the rounding errors. Far from the origin, these may be larger than most triangles.
  template <typename One, typename Other>
  [[nodiscard]] bool may_overlap(const One& one, const Other& other) const {
    return (one.open || other.open) && meet(one.box, other.box) &&
           one.diameter + other.diameter > least_;
  }

  void compare_within(std::uint32_t index) {
    if (nodes_[index].part != none || !nodes_[index].open) return;
    if (nodes_[index].is_leaf()) {
      const std::span<BoxedTriangle> items = items_of(nodes_[index]);
      for (std::size_t i = 0; i < items.size(); ++i)
        for (std::size_t k = i + 1; k < items.size(); ++k) compare(items[i], items[k]);
    } else {
      split(index);
      const std::uint32_t child = nodes_[index].child;
      compare_within(child);
      compare_within(child + 1);
      compare_nodes(child, child + 1);
    }
    note_marks(index);
  }

  void compare_nodes(std::uint32_t a, std::uint32_t b) {
    const Node &one = nodes_[a], &other = nodes_[b];
    if ((one.part == other.part && one.part != none) || (one.marked && other.marked) ||
        !may_overlap(one, other))
      return;
    if (one.is_leaf() && other.is_leaf()) {
      for (const BoxedTriangle& s : items_of(one))
        for (const BoxedTriangle& t : items_of(other)) compare(s, t);
      note_marks(a), note_marks(b);
    } else if (one.is_leaf() || other.is_leaf()) {
      const auto [leaf, large] = one.is_leaf() ? std::pair(a, b) : std::pair(b, a);
      for (const BoxedTriangle& item : items_of(nodes_[leaf]))
        compare_below(Query(world_, item), large);
      note_marks(leaf);
    } else {
      const auto [large, small] = one.size() >= other.size() ? std::pair(a, b) : std::pair(b, a);
      split(large);
      compare_nodes(nodes_[large].child, small);
      compare_nodes(nodes_[large].child + 1, small);
      note_marks(large);
    }
  }

  void compare_below(const Query& query, std::uint32_t index) {
    const Node& node = nodes_[index];
    const BoxedTriangle& item = query.item();
    if (node.part == item.part || (node.marked && marks_[item.triangle]) ||
        !may_overlap(item, node) || !query.meets(node.box))
      return;
    if (node.is_leaf()) {
      for (const BoxedTriangle& other : items_of(node)) compare(item, other);
    } else {
      split(index);
      compare_below(query, nodes_[index].child);
      compare_below(query, nodes_[index].child + 1);
    }
    note_marks(index);
  }

  void compare(const BoxedTriangle& s, const BoxedTriangle& t) {
    if (s.part == t.part || (marks_[s.triangle] && marks_[t.triangle]) || !may_overlap(s, t))
      return;
    ++compared_;
    if (!coplanar(world_, s.triangle, t.triangle)) return;
    mark(s.triangle, t.triangle);
    mark(t.triangle, s.triangle);
  }

  void mark(std::uint32_t triangle, std::uint32_t other) {
    if (marks_[triangle]) return;
    marks_[triangle] = 1;
    partners_.push_back({triangle, other});
  }

  void note_marks(std::uint32_t index) {
    Node& node = nodes_[index];
    if (node.marked) return;
    if (node.is_leaf()) {
      const std::span<BoxedTriangle> items = items_of(node);
      node.marked = std::all_of(items.begin(), items.end(), [&](const BoxedTriangle& item) {
        return marks_[item.triangle] != 0;
      });
    } else {
      node.marked =
          node.child != none && nodes_[node.child].marked && nodes_[node.child + 1].marked;
    }
  }

  const World& world_;
  std::vector<std::uint8_t>& marks_;
  std::vector<Partner>& partners_;
  float least_ = 0.0f;  // a lower bound on the overlap of coplanar triangles
  std::vector<BoxedTriangle> items_;
  std::vector<Node> nodes_;
  std::size_t compared_ = 0;
};

}  // namespace

Corners corners_of(const World& world, std::uint32_t triangle) {
  const glm::uvec3 t = world.triangles[triangle];
  return {glm::dvec3(world.positions[t.x]), glm::dvec3(world.positions[t.y]),
          glm::dvec3(world.positions[t.z])};
}

glm::dvec3 normal_of(const Corners& t) {
  return glm::cross(t[1] - t[0], t[2] - t[0]);
}

float size_of(const World& world, std::uint32_t triangle) {
  const glm::uvec3 t = world.triangles[triangle];
  const glm::vec3 a = world.positions[t.x], b = world.positions[t.y], c = world.positions[t.z];
  const glm::vec3 d = glm::max(a, glm::max(b, c)) - glm::min(a, glm::min(b, c));
  return std::max({d.x, d.y, d.z});
}

glm::dvec3 rounding_of(const Corners& s, const Corners& t, glm::dvec3 origin, double size) {
  glm::dvec3 largest(0.0);
  for (std::size_t i = 0; i < 3; ++i)
    largest = glm::max(largest, glm::max(glm::abs(s[i]), glm::abs(t[i])));
  return rounding_share * (largest + glm::abs(origin) + size);
}

bool coplanar(const World& world, std::uint32_t s, std::uint32_t t) {
  const Corners a = corners_of(world, s), b = corners_of(world, t);
  const float of_s = size_of(world, s), of_t = size_of(world, t);
  return (of_s <= of_t && lies_in(a, b, world.origin, static_cast<double>(of_s))) ||
         (of_t <= of_s && lies_in(b, a, world.origin, static_cast<double>(of_t)));
}

BoxedTriangle boxed(const World& world, std::uint32_t triangle) {
  constexpr float rounding = 1.001f;
  const Box box = box_of(world, triangle);
  return {enlarged(box, world.origin), rounding * glm::distance(box.lo, box.hi), triangle,
          world.triangle_part[triangle]};
}

Box enlarged(const Box& box, glm::dvec3 origin) {
  const double room = room_of(box, origin);
  return {as_floats(glm::dvec3(box.lo) - room), as_floats(glm::dvec3(box.hi) + room)};
}

std::size_t mark_coplanar(const World& world, std::vector<BoxedTriangle> triangles,
                          std::vector<std::uint8_t>& marks, std::vector<Partner>& partners) {
  return PairSearch(world, std::move(triangles), marks, partners).run();
}

}  // namespace asos::tracing
