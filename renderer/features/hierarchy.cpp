#include "renderer/features/hierarchy.h"

#include "renderer/features/binned_split.h"
#include "renderer/features/edge_chain.h"
#include "renderer/features/normal_cone.h"
#include "renderer/features/release.h"
#include "renderer/features/stoppable_loop.h"
#include "renderer/tasks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>

namespace asos {
namespace {

constexpr std::size_t leaf_size = 4;

// The nodes of a subtree, the root first, with the chains that these nodes index.
struct Subtree {
  std::vector<FeatureNode> nodes{1};
  std::vector<NodeChains> chains;
};

// The consecutive edges of a child, in the hierarchy's order.
struct Run {
  std::uint32_t first = 0;
  std::size_t count = 0;

  [[nodiscard]] bool is_leaf() const { return count <= leaf_size; }
};

class Builder {
 public:
  Builder(std::span<const glm::vec3> positions, std::vector<FeatureEdge>& edges,
          std::size_t fewest_in_parallel, const std::stop_token& stop)
      : positions_(positions),
        edges_(edges),
        order_(edges.size()),
        fewest_in_parallel_(fewest_in_parallel),
        stop_(stop) {}

  FeatureHierarchy build(std::span<const FeatureCurve> curves) {
    if (edges_.empty()) return {};
    std::vector<EdgeItem> items = all_items(curves);
    const auto middle = std::stable_partition(items.begin(), items.end(), [&](const EdgeItem& i) {
      return edges_[i.edge].kind != FeatureKind::silhouette;
    });
    const auto split = static_cast<std::size_t>(middle - items.begin());
    const EdgeItems all(items);
    std::vector<EdgeItems> roots;
    for (const EdgeItems part : {all.first(split), all.subspan(split)})
      if (!part.empty()) roots.push_back(part);
    Subtrees parts;
    // Build large hierarchies in parts, so that each part's boxes can be freed before the next
    // part.
    if (items.size() < in_turn * fewest_in_parallel_) {
      build_subtree(parts, std::move(roots), 0);
      release(items);
    } else {
      build_in_turn(parts, std::move(items), in_eight(std::move(roots)));
    }
    reorder();
    return joined(parts);
  }

 private:
  using Nodes = std::vector<FeatureNode>;
  /// A large subtree in parts. Node numbers continue from part to part, and chain numbers start
  /// anew. This avoids copies while the hierarchy grows.
  using Subtrees = std::vector<Subtree>;
  struct Summary {
    Box box;
    NormalCone cone;
    bool always = false;
    std::optional<EdgeChain> chain;
  };
  /// From this many times `fewest_in_parallel_` edges on (by default eight million), each part
  /// alone keeps all processors busy.
  static constexpr std::size_t in_turn = 4096;

  std::vector<EdgeItem> all_items(std::span<const FeatureCurve> curves) const {
    std::vector<EdgeItem> items(edges_.size());
    in_parallel(edges_.size(), stop_, [&](std::uint32_t i) {
      items[i].edge = i;
      if (edges_[i].is_curve()) {
        items[i].box = curves[edges_[i].curve()].box;
        return;
      }
      items[i].box.grow(positions_[edges_[i].a]);
      items[i].box.grow(positions_[edges_[i].b]);
    });
    return items;
  }

  // Builds the hierarchy of these parts one by one, and frees each part's items afterwards.
  void build_in_turn(Subtrees& out, std::vector<EdgeItem>&& all,
                     const std::vector<EdgeItems>& parts) {
    std::vector<std::vector<EdgeItem>> items;
    for (const EdgeItems part : parts) items.emplace_back(part.begin(), part.end());
    release(all);
    std::vector<Run> runs;
    std::vector<Summary> below;
    std::vector<Subtrees> built(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      runs.push_back({runs.empty() ? 0 : end_of(runs.back()), items[i].size()});
      below.push_back(build_part(built[i], items[i], runs.back().first));
      release(items[i]);
    }
    (void)assemble(out, runs, below, built);
  }

  static std::uint32_t end_of(const Run& run) {
    return run.first + static_cast<std::uint32_t>(run.count);
  }

  Summary build_part(Subtrees& out, EdgeItems items, std::uint32_t first) {
    if (items.size() > leaf_size) return build_subtree(out, {items}, first);
    return summarise(items, first);
  }

  // Builds the subtree of all parts' edges, with its own root. The parts are consecutive in memory
  // and start at place `first` in the order of edges.
  Summary build_subtree(Subtrees& out, std::vector<EdgeItems> parts, std::uint32_t first) {
    std::size_t count = 0;
    for (const EdgeItems part : parts) count += part.size();
    if (count < fewest_in_parallel_) return fill(out.emplace_back(), 0, std::move(parts), first);
    parts = in_eight(std::move(parts));
    const std::vector<Run> runs = runs_of(parts, first);
    std::vector<Summary> below(parts.size());
    std::vector<Subtrees> built(parts.size());
    in_tasks(parts.size(),
             [&](std::size_t i) { below[i] = build_part(built[i], parts[i], runs[i].first); });
    return assemble(out, runs, below, built);
  }

  static std::vector<Run> runs_of(const std::vector<EdgeItems>& parts, std::uint32_t first) {
    std::vector<Run> runs;
    for (const EdgeItems part : parts) {
      runs.push_back({first, part.size()});
      first = end_of(runs.back());
    }
    return runs;
  }

  // Inserts a root before the subtrees of its children.
  Summary assemble(Subtrees& out, std::span<const Run> runs, std::span<const Summary> below,
                   std::vector<Subtrees>& built) const {
    Subtree& root = out.emplace_back();
    root.nodes[0].child_count = static_cast<std::uint32_t>(runs.size());
    std::uint32_t next = 1;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (runs[i].is_leaf()) {
        set_leaf(root, 0, i, runs[i], below[i]);
      } else {
        set_child(root, 0, i, next, FeatureNode::inner, below[i]);
      }
      std::uint32_t nodes = 0;
      for (Subtree& part : built[i]) {
        for (FeatureNode& node : part.nodes) move_children(node, next);
        nodes += static_cast<std::uint32_t>(part.nodes.size());
      }
      next += nodes;
    }
    for (Subtrees& more : built) std::move(more.begin(), more.end(), std::back_inserter(out));
    return total_of(below);
  }

  static void move_children(FeatureNode& node, std::uint32_t by) {
    for (std::uint32_t c = 0; c < node.child_count; ++c)
      if (node.edge_count[c] == FeatureNode::inner) node.child[c] += by;
  }

  static FeatureHierarchy joined(Subtrees& parts) {
    FeatureHierarchy all;
    std::size_t nodes = 0, chains = 0;
    for (const Subtree& part : parts) nodes += part.nodes.size(), chains += part.chains.size();
    all.nodes.reserve(nodes);
    all.chains.reserve(chains);
    for (Subtree& part : parts) {
      for (FeatureNode& node : part.nodes)
        if (node.chains != FeatureNode::no_chains)
          node.chains += static_cast<std::uint32_t>(all.chains.size());
      all.nodes.insert(all.nodes.end(), part.nodes.begin(), part.nodes.end());
      all.chains.insert(all.chains.end(), part.chains.begin(), part.chains.end());
      part = Subtree{{}, {}};
    }
    all.chains = in_order_of_nodes(all);
    return all;
  }

  // In a subtree built by one thread, a node's chains come after those below it; elsewhere they
  // come before. This puts them in the order of nodes.
  static std::vector<NodeChains> in_order_of_nodes(FeatureHierarchy& all) {
    std::vector<NodeChains> ordered;
    ordered.reserve(all.chains.size());
    for (FeatureNode& node : all.nodes) {
      if (node.chains == FeatureNode::no_chains) continue;
      ordered.push_back(all.chains[node.chains]);
      node.chains = static_cast<std::uint32_t>(ordered.size() - 1);
    }
    return ordered;
  }

  // Splits the largest part again and again, into up to eight parts.
  std::vector<EdgeItems> in_eight(std::vector<EdgeItems> parts) const {
    check_stop(stop_);
    while (parts.size() < FeatureNode::width) {
      const auto largest = std::max_element(
          parts.begin(), parts.end(), [](EdgeItems x, EdgeItems y) { return x.size() < y.size(); });
      if (largest->size() <= leaf_size) break;
      const auto [left, right] = binned_split(*largest);
      *largest = left;
      parts.insert(largest + 1, right);
    }
    return parts;
  }

  // Fills node `index`. The nodes below it are appended, part by part.
  Summary fill(Subtree& tree, std::uint32_t index, std::vector<EdgeItems> parts,
               std::uint32_t first) {
    parts = in_eight(std::move(parts));
    const std::vector<Run> runs = runs_of(parts, first);
    tree.nodes[index].child_count = static_cast<std::uint32_t>(parts.size());
    std::vector<Summary> below;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (runs[i].is_leaf()) {
        below.push_back(summarise(parts[i], runs[i].first));
        set_leaf(tree, index, i, runs[i], below.back());
        continue;
      }
      const auto child = static_cast<std::uint32_t>(tree.nodes.size());
      tree.nodes.emplace_back();
      below.push_back(fill(tree, child, {parts[i]}, runs[i].first));
      set_child(tree, index, i, child, FeatureNode::inner, below.back());
    }
    return total_of(below);
  }

  [[nodiscard]] Summary total_of(std::span<const Summary> below) const {
    Summary total;
    std::array<std::optional<EdgeChain>, FeatureNode::width> chains;
    for (std::size_t i = 0; i < below.size(); ++i) {
      total.box.grow(below[i].box);
      total.cone = merge(total.cone, below[i].cone);
      total.always |= below[i].always;
      chains[i] = below[i].chain;
    }
    total.chain = join(positions_, std::span(chains).first(below.size()));
    return total;
  }

  static void set_leaf(Subtree& tree, std::uint32_t index, std::size_t i, const Run& run,
                       const Summary& summary) {
    set_child(tree, index, i, run.first, static_cast<std::uint8_t>(run.count), summary);
  }

  static void set_child(Subtree& tree, std::uint32_t index, std::size_t i, std::uint32_t child,
                        std::uint8_t edge_count, const Summary& below) {
    FeatureNode& node = tree.nodes[index];
    for (int k = 0; k < 3; ++k) {
      node.lo[k][i] = below.box.lo[k];
      node.hi[k][i] = below.box.hi[k];
      node.axis[k][i] = static_cast<float>(below.cone.axis[k]);
    }
    node.cone_sine[i] = static_cast<float>(below.cone.sine);
    node.cone_cosine[i] = static_cast<float>(below.cone.cosine);
    node.child[i] = child;
    node.edge_count[i] = edge_count;
    node.always[i] = below.always;
    if (!below.chain) return;
    if (node.chains == FeatureNode::no_chains) {
      node.chains = static_cast<std::uint32_t>(tree.chains.size());
      tree.chains.emplace_back();
    }
    NodeChains& chains = tree.chains[node.chains];
    chains.end[0][i] = below.chain->from;
    chains.end[1][i] = below.chain->to;
    chains.deviation[i] = below.chain->deviation;
  }

  // Summarizes a leaf, whose edges start at place `first` in the order.
  [[nodiscard]] Summary summarise(EdgeItems items, std::uint32_t first) {
    Summary s;
    std::array<std::optional<EdgeChain>, leaf_size> chains;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const EdgeItem& item = items[i];
      order_[first++] = item.edge;
      const FeatureEdge& edge = edges_[item.edge];
      if (edge.kind != FeatureKind::silhouette && !edge.is_curve())
        chains[i] = EdgeChain{edge.a, edge.b, 0.0f};
      s.box.grow(item.box);
      s.always |= edge.kind != FeatureKind::silhouette;
      s.cone = merge(s.cone, cone_of(edge));
    }
    s.chain = join(positions_, std::span(chains).first(items.size()));
    return s;
  }

  // Returns the cone of an edge's two normals, oriented by the direction in which each face runs
  // along the edge.
  [[nodiscard]] NormalCone cone_of(const FeatureEdge& edge) const {
    if (edge.right == FeatureEdge::none) return NormalCone::everything();
    const glm::dvec3 a(positions_[edge.a]);
    const glm::dvec3 along = glm::dvec3(positions_[edge.b]) - a;
    const glm::dvec3 l = glm::normalize(glm::cross(along, glm::dvec3(positions_[edge.left]) - a));
    const glm::dvec3 r = glm::normalize(glm::cross(glm::dvec3(positions_[edge.right]) - a, along));
    // Not merge(), which could flip one of the normals, as of another pair of faces.
    return asos::cone_of(l, r);
  }

  // Reorders in place, cycle by cycle. A copy of the edges would be the peak of memory during
  // loading.
  void reorder() {
    for (std::uint32_t start = 0; start < order_.size(); ++start) {
      if (order_[start] == start) continue;
      const FeatureEdge first = edges_[start];
      std::uint32_t to = start;
      for (std::uint32_t from = order_[to]; from != start; from = order_[to]) {
        edges_[to] = edges_[from];
        order_[to] = to;
        to = from;
      }
      edges_[to] = first;
      order_[to] = to;
    }
  }

  std::span<const glm::vec3> positions_;
  std::vector<FeatureEdge>& edges_;
  std::vector<std::uint32_t> order_;  // previous place of each edge, leaf by leaf
  std::size_t fewest_in_parallel_;
  std::stop_token stop_;
};

}  // namespace

FeatureHierarchy FeatureHierarchy::build(std::span<const glm::vec3> positions,
                                         std::vector<FeatureEdge>& edges,
                                         std::span<const FeatureCurve> curves,
                                         std::size_t fewest_in_parallel,
                                         const std::stop_token& stop) {
  return Builder(positions, edges, fewest_in_parallel, stop).build(curves);
}

}  // namespace asos
