#include "renderer/features/hierarchy.h"

#include "renderer/features/stoppable_loop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numbers>
#include <optional>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace asos {
namespace {

constexpr std::size_t leaf_size = 4;
constexpr int bin_count = 16;

// Four at a time, in the vectors that GCC and Clang offer and all processors have; the fourth is
// not used.
using Floats = float __attribute__((vector_size(4 * sizeof(float))));

struct FastBox {
  Floats lo = Floats{} + std::numeric_limits<float>::infinity();
  Floats hi = Floats{} - std::numeric_limits<float>::infinity();

  void grow(const FastBox& b) {
    lo = b.lo < lo ? b.lo : lo;
    hi = b.hi > hi ? b.hi : hi;
  }
  void grow(Floats p) { grow(FastBox{p, p}); }
};

struct Item {
  Box box;
  std::uint32_t edge = 0;

  [[nodiscard]] FastBox fast_box() const {
    static_assert(offsetof(Box, hi) == 3 * sizeof(float));
    // The three before the edge's number and, from one place earlier on, the three after `lo`.
    using Places = std::int32_t __attribute__((vector_size(4 * sizeof(std::int32_t))));
    FastBox fast;
    std::memcpy(&fast.lo, &box.lo.x, sizeof fast.lo);
    std::memcpy(&fast.hi, &box.lo.z, sizeof fast.hi);
    fast.hi = __builtin_shuffle(fast.hi, Places{1, 2, 3, 0});
    return fast;
  }
  [[nodiscard]] Floats centre() const {  // doubled
    const FastBox fast = fast_box();
    return fast.lo + fast.hi;
  }
};

using Items = std::span<Item>;

float extent_sum(const FastBox& box) {
  const Floats d = box.hi - box.lo;
  return d[0] + d[1] + d[2];
}

// The normals' double cone of a subtree.
struct Cone {
  glm::dvec3 axis{0.0};
  double angle = -1.0;  // radians; negative: of nothing; pi/2 or more: holds every direction

  static Cone everything() { return {{0, 0, 1}, std::numbers::pi}; }
};

double angle_between(glm::dvec3 x, glm::dvec3 y) {
  return std::atan2(glm::length(glm::cross(x, y)), glm::dot(x, y));
}

// The smallest cone that holds both, the second one turned over where that is narrower.
Cone merge(const Cone& x, Cone y) {
  if (x.angle < 0.0) return y;
  if (y.angle < 0.0) return x;
  if (glm::dot(x.axis, y.axis) < 0.0) y.axis = -y.axis;
  const double between = angle_between(x.axis, y.axis);
  if (between + y.angle <= x.angle) return x;
  if (between + x.angle <= y.angle) return y;
  const double angle = 0.5 * (x.angle + y.angle + between);
  if (angle >= 0.5 * std::numbers::pi) return Cone::everything();
  // Turn x's axis towards y's by what the new cone leaves.
  const glm::dvec3 side = glm::normalize(y.axis - x.axis * glm::dot(x.axis, y.axis));
  const double turn = angle - x.angle;
  return {std::cos(turn) * x.axis + std::sin(turn) * side, angle};
}

// Edges joined end to end, by the vertices where they begin and end.
struct Chain {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  float deviation = 0.0f;  // the farthest that they stray from the line between
};

float distance_to_line(glm::vec3 p, glm::vec3 a, glm::vec3 b) {
  const glm::vec3 d = b - a;
  const float length2 = glm::dot(d, d);
  const float t = length2 > 0.0f ? std::clamp(glm::dot(p - a, d) / length2, 0.0f, 1.0f) : 0.0f;
  return glm::distance(p, a + t * d);
}

// The one open chain that the parts form, if each is a chain and they form just one.
std::optional<Chain> join(std::span<const glm::vec3> positions,
                          std::span<const std::optional<Chain>> parts) {
  std::vector<Chain> all;
  for (const auto& part : parts) {
    if (!part) return std::nullopt;
    all.push_back(*part);
  }
  std::vector<Chain> left(all.begin() + 1, all.end());
  Chain whole = all.front();
  while (!left.empty()) {
    const auto next = std::find_if(left.begin(), left.end(), [&](const Chain& c) {
      return c.from == whole.to || c.to == whole.to || c.from == whole.from || c.to == whole.from;
    });
    if (next == left.end()) return std::nullopt;
    Chain c = *next;
    if (c.to == whole.to || c.to == whole.from) std::swap(c.from, c.to);
    (c.from == whole.to ? whole.to : whole.from) = c.to;
    left.erase(next);
  }
  if (whole.from == whole.to) return std::nullopt;
  // A chain between two joints is no farther from the line than the joints are, plus its own
  // deviation.
  const glm::vec3 a = positions[whole.from], b = positions[whole.to];
  whole.deviation = 0.0f;
  for (const Chain& c : all) {
    const float joints = std::max(distance_to_line(positions[c.from], a, b),
                                  distance_to_line(positions[c.to], a, b));
    whole.deviation = std::max(whole.deviation, joints + c.deviation);
  }
  return whole;
}

class Builder {
  using Nodes = std::vector<FeatureNode>;

 public:
  Builder(std::span<const glm::vec3> positions, std::vector<FeatureEdge>& edges,
          std::span<const FeatureCurve> curves, std::size_t fewest_in_parallel,
          const std::stop_token& stop)
      : positions_(positions),
        edges_(edges),
        items_(edges.size()),
        fewest_in_parallel_(fewest_in_parallel),
        stop_(stop) {
    in_parallel(edges.size(), stop, [&](std::uint32_t i) {
      items_[i].edge = i;
      if (edges[i].curve != FeatureEdge::none) {
        items_[i].box = curves[edges[i].curve].box;
        return;
      }
      items_[i].box.grow(positions[edges[i].a]);
      items_[i].box.grow(positions[edges[i].b]);
    });
  }

  FeatureHierarchy build() {
    if (edges_.empty()) return {};
    const auto middle = std::stable_partition(items_.begin(), items_.end(), [&](const Item& i) {
      return edges_[i.edge].kind != FeatureKind::silhouette;
    });
    const auto split = static_cast<std::size_t>(middle - items_.begin());
    const Items all(items_);
    std::vector<Items> roots;
    for (const Items part : {all.first(split), all.subspan(split)})
      if (!part.empty()) roots.push_back(part);
    Nodes nodes(1);
    fill(nodes, 0, std::move(roots));
    reorder();
    return {std::move(nodes)};
  }

 private:
  struct Summary {
    Box box;
    Cone cone;
    bool always = false;
    std::optional<Chain> chain;
  };

  // Fills node `index` with up to eight parts, made by splitting the largest again and again. The
  // nodes below it follow at the end, a part's after those of the part before.
  Summary fill(Nodes& nodes, std::uint32_t index, std::vector<Items> parts) const {
    check_stop(stop_);
    std::size_t count = 0;
    for (const Items part : parts) count += part.size();
    while (parts.size() < FeatureNode::width) {
      const auto largest = std::max_element(parts.begin(), parts.end(),
                                            [](Items x, Items y) { return x.size() < y.size(); });
      if (largest->size() <= leaf_size) break;
      const auto [left, right] = split(*largest);
      *largest = left;
      parts.insert(largest + 1, right);
    }
    nodes[index].child_count = static_cast<std::uint32_t>(parts.size());
    const std::vector<Summary> below = count < fewest_in_parallel_
                                           ? fill_children(nodes, index, parts)
                                           : fill_children_in_parallel(nodes, index, parts);
    Summary total;
    std::vector<std::optional<Chain>> chains_of_parts;
    for (const Summary& part : below) {
      total.box.grow(part.box);
      total.cone = merge(total.cone, part.cone);
      total.always |= part.always;
      chains_of_parts.push_back(part.chain);
    }
    total.chain = join(positions_, chains_of_parts);
    return total;
  }

  static bool is_leaf(Items part) { return part.size() <= leaf_size; }

  std::vector<Summary> fill_children(Nodes& nodes, std::uint32_t index,
                                     std::span<const Items> parts) const {
    std::vector<Summary> below;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (is_leaf(parts[i])) {
        below.push_back(summarise(parts[i]));
        set_leaf(nodes[index], i, parts[i], below.back());
        continue;
      }
      const auto child = static_cast<std::uint32_t>(nodes.size());
      nodes.emplace_back();
      below.push_back(fill(nodes, child, {parts[i]}));
      set_child(nodes[index], i, child, FeatureNode::inner, below.back());
    }
    return below;
  }

  // Each part's nodes by themselves, which are then put where they would have come one by one.
  std::vector<Summary> fill_children_in_parallel(Nodes& nodes, std::uint32_t index,
                                                 std::span<const Items> parts) const {
    std::vector<Summary> below(parts.size());
    std::vector<Nodes> nodes_of(parts.size());
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, parts.size(), 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) {
            if (is_leaf(parts[i])) {
              below[i] = summarise(parts[i]);
            } else {
              nodes_of[i].emplace_back();
              below[i] = fill(nodes_of[i], 0, {parts[i]});
            }
          }
        },
        tbb::simple_partitioner());
    std::size_t more = 0;
    for (const Nodes& part : nodes_of) more += part.size();
    nodes.reserve(nodes.size() + more);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (is_leaf(parts[i])) {
        set_leaf(nodes[index], i, parts[i], below[i]);
        continue;
      }
      const auto child = static_cast<std::uint32_t>(nodes.size());
      for (FeatureNode& node : nodes_of[i]) {
        for (std::uint32_t c = 0; c < node.child_count; ++c)
          if (node.edge_count[c] == FeatureNode::inner) node.child[c] += child;
      }
      nodes.insert(nodes.end(), nodes_of[i].begin(), nodes_of[i].end());
      Nodes().swap(nodes_of[i]);
      set_child(nodes[index], i, child, FeatureNode::inner, below[i]);
    }
    return below;
  }

  void set_leaf(FeatureNode& node, std::size_t i, Items part, const Summary& summary) const {
    set_child(node, i, static_cast<std::uint32_t>(part.data() - items_.data()),
              static_cast<std::uint8_t>(part.size()), summary);
  }

  static void set_child(FeatureNode& node, std::size_t i, std::uint32_t child,
                        std::uint8_t edge_count, const Summary& below) {
    for (int k = 0; k < 3; ++k) {
      node.lo[k][i] = below.box.lo[k];
      node.hi[k][i] = below.box.hi[k];
      node.axis[k][i] = static_cast<float>(below.cone.axis[k]);
    }
    const bool bounded = below.cone.angle < 0.5 * std::numbers::pi;
    node.cone_sine[i] = bounded ? static_cast<float>(std::sin(below.cone.angle)) : 1.0f;
    node.cone_cosine[i] = bounded ? static_cast<float>(std::cos(below.cone.angle)) : 0.0f;
    node.child[i] = child;
    node.edge_count[i] = edge_count;
    node.always[i] = below.always;
    node.chain[0][i] = below.chain ? below.chain->from : FeatureEdge::none;
    node.chain[1][i] = below.chain ? below.chain->to : FeatureEdge::none;
    node.chain_deviation[i] = below.chain ? below.chain->deviation : 0.0f;
  }

  [[nodiscard]] Summary summarise(Items items) const {
    Summary s;
    std::vector<std::optional<Chain>> chains;
    for (const Item& item : items) {
      const FeatureEdge& edge = edges_[item.edge];
      if (edge.kind == FeatureKind::silhouette || edge.curve != FeatureEdge::none) {
        chains.emplace_back();
      } else {
        chains.push_back(Chain{edge.a, edge.b, 0.0f});
      }
      s.box.grow(item.box);
      s.always |= edge.kind != FeatureKind::silhouette;
      s.cone = merge(s.cone, cone_of(edge));
    }
    s.chain = join(positions_, chains);
    return s;
  }

  // The normals of an edge's two faces, oriented by how each face runs along the edge.
  [[nodiscard]] Cone cone_of(const FeatureEdge& edge) const {
    if (edge.right == FeatureEdge::none) return Cone::everything();
    const glm::dvec3 a(positions_[edge.a]);
    const glm::dvec3 along = glm::dvec3(positions_[edge.b]) - a;
    const glm::dvec3 l = glm::normalize(glm::cross(along, glm::dvec3(positions_[edge.left]) - a));
    const glm::dvec3 r = glm::normalize(glm::cross(glm::dvec3(positions_[edge.right]) - a, along));
    const double between = angle_between(l, r);
    // merge() would turn one of the two over, which is another pair of faces.
    if (between > 0.5 * std::numbers::pi) return Cone::everything();
    return {glm::normalize(l + r), 0.5 * between};
  }

  // Two halves by the cheapest of the planes between bins, or by count where all centres agree.
  static std::pair<Items, Items> split(Items items) {
    FastBox centres;
    for (const Item& i : items) centres.grow(i.centre());
    const Floats size = centres.hi - centres.lo;
    const int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
    const float scale = static_cast<float>(bin_count) / size[axis];
    const auto bin_of = [&](const Item& i) {
      const float b = (i.centre()[axis] - centres.lo[axis]) * scale;
      return std::clamp(static_cast<int>(b), 0, bin_count - 1);
    };
    if (!(size[axis] > 0.0f) || !std::isfinite(scale)) return halves(items);

    struct Bin {
      FastBox box;
      std::size_t count = 0;
    };
    std::array<Bin, bin_count> bins;
    for (const Item& i : items) {
      Bin& bin = bins[static_cast<std::size_t>(bin_of(i))];
      bin.box.grow(i.fast_box());
      ++bin.count;
    }
    std::array<float, bin_count> cost_right{};
    Bin swept;
    for (int b = bin_count - 1; b > 0; --b) {
      const auto at = static_cast<std::size_t>(b);
      swept.box.grow(bins[at].box);
      swept.count += bins[at].count;
      cost_right[at] = swept.count ? extent_sum(swept.box) * static_cast<float>(swept.count) : 0;
    }
    swept = {};
    int best = -1;
    float best_cost = std::numeric_limits<float>::infinity();
    for (int b = 0; b + 1 < bin_count; ++b) {
      const auto at = static_cast<std::size_t>(b);
      swept.box.grow(bins[at].box);
      swept.count += bins[at].count;
      if (swept.count == 0 || swept.count == items.size()) continue;
      const float cost =
          extent_sum(swept.box) * static_cast<float>(swept.count) + cost_right[at + 1];
      if (cost < best_cost) best_cost = cost, best = b;
    }
    if (best < 0) return halves(items);
    const auto middle = std::partition(items.begin(), items.end(),
                                       [&](const Item& i) { return bin_of(i) <= best; });
    const auto count = static_cast<std::size_t>(middle - items.begin());
    return {items.first(count), items.subspan(count)};
  }

  static std::pair<Items, Items> halves(Items items) {
    return {items.first(items.size() / 2), items.subspan(items.size() / 2)};
  }

  // In place, cycle by cycle: a copy of the edges would be the most memory that all of loading
  // takes.
  void reorder() {
    for (std::uint32_t start = 0; start < items_.size(); ++start) {
      if (items_[start].edge == start) continue;
      const FeatureEdge first = edges_[start];
      std::uint32_t to = start;
      for (std::uint32_t from = items_[to].edge; from != start; from = items_[to].edge) {
        edges_[to] = edges_[from];
        items_[to].edge = to;
        to = from;
      }
      edges_[to] = first;
      items_[to].edge = to;
    }
  }

  std::span<const glm::vec3> positions_;
  std::vector<FeatureEdge>& edges_;
  std::vector<Item> items_;
  std::size_t fewest_in_parallel_;
  std::stop_token stop_;
};

}  // namespace

FeatureHierarchy FeatureHierarchy::build(std::span<const glm::vec3> positions,
                                         std::vector<FeatureEdge>& edges,
                                         std::span<const FeatureCurve> curves,
                                         std::size_t fewest_in_parallel,
                                         const std::stop_token& stop) {
  return Builder(positions, edges, curves, fewest_in_parallel, stop).build();
}

}  // namespace asos
