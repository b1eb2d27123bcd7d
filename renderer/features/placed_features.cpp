#include "renderer/features/placed_features.h"

#include "renderer/features/hierarchy.h"
#include "renderer/geometry/box.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace asos {
namespace {

// The nodes above the hierarchies of a world's own boundaries and of its placed meshes.

/// The hierarchy of one place of a mesh, by its box.
struct UpperItem {
  static constexpr std::uint32_t own = 0xffffffffu;

  Box box;
  std::uint32_t place = own;  ///< `own`: the world's own boundaries
};

/// Edge count of such children until they are numbered.
constexpr std::uint8_t root_below = 255;

/// Numbers the roots below upper nodes; the own hierarchy's root is `own_root`.
template <typename RootOf>
void finish_upper_nodes(std::vector<FeatureNode>& nodes, std::uint32_t own_root,
                        RootOf root_of_place) {
  for (FeatureNode& node : nodes) {
    for (std::uint32_t c = 0; c < node.child_count; ++c) {
      if (node.edge_count[c] != root_below) continue;
      node.edge_count[c] = FeatureNode::inner;
      node.child[c] = node.child[c] == UpperItem::own ? own_root : root_of_place(node.child[c]);
    }
  }
}

using Items = std::span<UpperItem>;

glm::vec3 centre_of(const UpperItem& item) {
  return 0.5f * item.box.lo + 0.5f * item.box.hi;
}

/// Splits items into two halves along the longest side of the box of all centres.
std::pair<Items, Items> halves_of(Items items) {
  Box centres;
  for (const UpperItem& item : items) centres.grow(centre_of(item));
  const glm::vec3 size = centres.hi - centres.lo;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t half = items.size() / 2;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                   [axis](const UpperItem& a, const UpperItem& b) {
                     const float x = centre_of(a)[axis], y = centre_of(b)[axis];
                     return x != y ? x < y : a.place < b.place;
                   });
  return {items.first(half), items.subspan(half)};
}

std::vector<Items> in_eight_parts(Items items) {
  std::vector<Items> parts{items};
  while (parts.size() < FeatureNode::width) {
    const auto largest = std::max_element(parts.begin(), parts.end(),
                                          [](Items x, Items y) { return x.size() < y.size(); });
    if (largest->size() < 2) break;
    const auto [left, right] = halves_of(*largest);
    *largest = left;
    parts.insert(largest + 1, right);
  }
  return parts;
}

void fill_upper(std::vector<FeatureNode>& nodes, std::uint32_t index, Items items) {
  const std::vector<Items> parts = in_eight_parts(items);
  nodes[index].child_count = static_cast<std::uint32_t>(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Box box;
    for (const UpperItem& item : parts[i]) box.grow(item.box);
    const bool root = parts[i].size() == 1;
    const auto child = root ? parts[i].front().place : static_cast<std::uint32_t>(nodes.size());
    FeatureNode& node = nodes[index];
    for (int k = 0; k < 3; ++k) {
      node.lo[k][i] = box.lo[k];
      node.hi[k][i] = box.hi[k];
      node.axis[k][i] = k == 2 ? 1.0f : 0.0f;
    }
    node.cone_sine[i] = 1.0f;
    node.cone_cosine[i] = 0.0f;
    node.child[i] = child;
    node.edge_count[i] = root ? root_below : FeatureNode::inner;
    node.always[i] = 1;
    if (root) continue;
    nodes.emplace_back();
    fill_upper(nodes, child, parts[i]);
  }
}

// Returns the box of everything below a node.
Box box_below(const FeatureNode& node) {
  Box box;
  for (std::uint32_t c = 0; c < node.child_count; ++c) {
    box.grow(glm::vec3(node.lo[0][c], node.lo[1][c], node.lo[2][c]));
    box.grow(glm::vec3(node.hi[0][c], node.hi[1][c], node.hi[2][c]));
  }
  return box;
}

// Returns the nodes above the places' hierarchies and above `own`, unless that is empty; the first
// is the root. finish_upper_nodes numbers the children that are roots of hierarchies.
std::vector<FeatureNode> upper_nodes(std::vector<UpperItem> items,
                                     const std::vector<FeatureNode>& own) {
  if (!own.empty()) items.push_back({box_below(own[0]), UpperItem::own});
  std::vector<FeatureNode> nodes;
  if (items.empty()) return nodes;
  nodes.emplace_back();
  fill_upper(nodes, 0, items);
  return nodes;
}

/// The ranges of numbers of all places. `count` returns the size of a mesh's range.
template <typename Count>
RangeIndex ranges_of(const Placements& all, Count count) {
  std::vector<std::uint32_t> first;
  std::uint32_t end = 0;
  for (const Placement& place : all.places) {
    first.push_back(end);
    end += static_cast<std::uint32_t>(std::max<std::size_t>(1, count(place.mesh)));
  }
  return {std::move(first), end};
}

float rounded_down(double x) {
  const auto near = static_cast<float>(x);
  return static_cast<double>(near) <= x
             ? near
             : std::nextafter(near, -std::numeric_limits<float>::infinity());
}

float rounded_up(double x) {
  return -rounded_down(-x);
}

/// Widens a cone so that it contains the images of its directions under a matrix. Lengths across
/// the axis grow by at most `anisotropy` times more than lengths along it. Shear reduces the length
/// along the axis by as much.
void widen(float& sine, float& cosine, double anisotropy) {
  if (anisotropy <= 1.0 || !(cosine > 0.0f)) return;
  const double tangent = anisotropy * static_cast<double>(sine) / static_cast<double>(cosine);
  constexpr double most = 0.9;
  if (!(tangent < most)) {
    sine = 1.0f, cosine = 0.0f;
    return;
  }
  const double wider = tangent / (1.0 - tangent), length = std::sqrt(1.0 + wider * wider);
  sine = static_cast<float>(wider / length);
  cosine = static_cast<float>(1.0 / length);
}

/// Returns a mesh with positions rounded to the precision of its size. Rounding may have separated
/// vertices around the mesh's origin, such as those along the seam of a ball. These become equal,
/// as they do when a place is added to them.
World snapped(const World& mesh) {
  World rounded = mesh;
  const glm::vec3 size = mesh.bounds.hi - mesh.bounds.lo;
  const float unit = std::exp2(std::floor(std::log2(std::max({size.x, size.y, size.z}))));
  for (glm::vec3& p : rounded.positions) p = (p + unit) - unit;
  return rounded;
}

/// Returns the boundaries of a mesh. Worlds that exist at the same time and show the same mesh,
/// such as the moments of an exposure, get the same.
std::shared_ptr<const FeatureSet> features_of_mesh(const std::shared_ptr<const World>& mesh,
                                                   TextureAt texture_at,
                                                   const std::stop_token& stop) {
  struct Known {
    std::weak_ptr<const World> mesh;
    TextureAt texture_at;
    std::weak_ptr<const FeatureSet> features;
  };
  static std::mutex mutex;
  static std::vector<Known> all;
  const auto find = [&]() -> std::shared_ptr<const FeatureSet> {
    const std::lock_guard lock(mutex);
    std::erase_if(all, [](const Known& known) { return known.features.expired(); });
    for (const Known& known : all)
      if (known.texture_at == texture_at && known.mesh.lock() == mesh) return known.features.lock();
    return nullptr;
  };
  if (auto features = find()) return features;
  auto features = std::make_shared<const FeatureSet>(snapped(*mesh), texture_at, stop);
  const std::lock_guard lock(mutex);
  all.push_back({mesh, texture_at, features});
  return features;
}

void move(std::uint32_t& number, std::uint32_t by) {
  if (number != FeatureEdge::none) number += by;
}

}  // namespace

PlacedFeatures::PlacedFeatures(const World& world, TextureAt texture_at,
                               const std::stop_token& stop)
    : places(world.placements) {
  for (const auto& mesh : places->meshes)
    meshes.push_back(features_of_mesh(mesh, texture_at, stop));
  const auto ranges = [&](auto count) {
    return ranges_of(*places, [&](std::uint32_t mesh) { return count(*meshes[mesh]); });
  };
  by_node_ = ranges([](const FeatureSet& f) { return f.nodes().size(); });
  by_chains_ = ranges([](const FeatureSet& f) { return f.chains().size(); });
  by_edge_ = ranges([](const FeatureSet& f) { return f.edges().size(); });
  by_position_ = ranges([](const FeatureSet& f) { return f.positions().size(); });
}

FeatureHierarchy PlacedFeatures::behind(FeatureHierarchy own, std::size_t edges,
                                        std::size_t positions) {
  std::vector<UpperItem> items;
  for (std::size_t i = 0; i < places->places.size(); ++i) {
    if (!meshes[places->places[i].mesh]->empty())
      items.push_back({box_of(i), static_cast<std::uint32_t>(i)});
  }
  FeatureHierarchy all;
  all.nodes = upper_nodes(std::move(items), own.nodes);
  const auto upper = static_cast<std::uint32_t>(all.nodes.size());
  first_node_ = upper + static_cast<std::uint32_t>(own.nodes.size());
  first_chains_ = static_cast<std::uint32_t>(own.chains.size());
  first_edge_ = static_cast<std::uint32_t>(edges);
  first_position_ = static_cast<std::uint32_t>(positions);
  finish_upper_nodes(all.nodes, upper,
                     [&](std::uint32_t i) { return first_node_ + by_node_.first(i); });
  for (FeatureNode& node : own.nodes) {
    for (std::uint32_t c = 0; c < node.child_count; ++c)
      if (node.edge_count[c] == FeatureNode::inner) node.child[c] += upper;
  }
  all.nodes.insert(all.nodes.end(), own.nodes.begin(), own.nodes.end());
  all.chains = std::move(own.chains);
  return all;
}

Box PlacedFeatures::box_of(std::size_t place) const {
  const FeatureNode root = placed(meshes[places->places[place].mesh]->nodes()[0], place);
  return box_below(root);
}

FeatureNode PlacedFeatures::node(std::uint32_t number) const {
  const std::size_t place = by_node_.find(number - first_node_);
  const std::uint32_t local = number - first_node_ - by_node_.first(place);
  return placed(meshes[places->places[place].mesh]->nodes()[local], place);
}

FeatureNode PlacedFeatures::placed(const FeatureNode& node, std::size_t at) const {
  const Placement& place = places->places[at];
  const glm::dmat4 matrix = places->world_from_mesh(place);
  const glm::dmat3 linear(matrix);
  const glm::dmat3 reach(glm::abs(linear[0]), glm::abs(linear[1]), glm::abs(linear[2]));
  FeatureNode out = node;
  for (std::uint32_t c = 0; c < node.child_count; ++c) {
    const glm::dvec3 lo(node.lo[0][c], node.lo[1][c], node.lo[2][c]);
    const glm::dvec3 hi(node.hi[0][c], node.hi[1][c], node.hi[2][c]);
    const glm::dvec3 centre(matrix * glm::dvec4(0.5 * (lo + hi), 1.0));
    constexpr double rounding = 1e-14;
    const glm::dvec3 half = reach * (0.5 * (hi - lo) + rounding * (glm::abs(lo) + glm::abs(hi))) +
                            rounding * glm::abs(centre);
    const glm::dvec3 axis =
        place.cofactors * glm::dvec3(node.axis[0][c], node.axis[1][c], node.axis[2][c]);
    const double length = glm::length(axis);
    for (int k = 0; k < 3; ++k) {
      out.lo[k][c] = rounded_down(centre[k] - half[k]);
      out.hi[k][c] = rounded_up(centre[k] + half[k]);
      out.axis[k][c] = length > 0.0 ? static_cast<float>(axis[k] / length) : 0.0f;
    }
    if (!(length > 0.0)) out.cone_sine[c] = 1.0f, out.cone_cosine[c] = 0.0f;
    widen(out.cone_sine[c], out.cone_cosine[c], place.anisotropy);
    out.child[c] += node.edge_count[c] == FeatureNode::inner ? first_node_ + by_node_.first(at)
                                                             : first_edge_ + by_edge_.first(at);
  }
  if (out.chains != FeatureNode::no_chains) out.chains += first_chains_ + by_chains_.first(at);
  return out;
}

NodeChains PlacedFeatures::chains(std::uint32_t number) const {
  const std::size_t at = by_chains_.find(number - first_chains_);
  const Placement& place = places->places[at];
  NodeChains out = meshes[place.mesh]->chains()[number - first_chains_ - by_chains_.first(at)];
  for (int c = 0; c < FeatureNode::width; ++c) {
    for (auto& ends : out.end) move(ends[c], first_position_ + by_position_.first(at));
    out.deviation[c] *= static_cast<float>(place.most_growth);
  }
  return out;
}

FeatureEdge PlacedFeatures::edge(std::uint32_t number) const {
  const std::size_t at = by_edge_.find(number - first_edge_);
  const Placement& place = places->places[at];
  FeatureEdge edge = meshes[place.mesh]->edges()[number - first_edge_ - by_edge_.first(at)];
  for (std::uint32_t* vertex : {&edge.a, &edge.b, &edge.left, &edge.right})
    move(*vertex, first_position_ + by_position_.first(at));
  for (std::uint32_t* smooth_surface : {&edge.left_surface, &edge.right_surface})
    move(*smooth_surface, places->own_triangles + place.first_triangle);
  return edge;
}

glm::dvec3 PlacedFeatures::position(std::uint32_t number) const {
  const std::size_t at = by_position_.find(number - first_position_);
  const Placement& place = places->places[at];
  const glm::dvec3 local(
      meshes[place.mesh]->positions()[number - first_position_ - by_position_.first(at)]);
  return glm::dvec3(place.world_from_mesh * glm::dvec4(local, 1.0)) - places->origin;
}

std::uint32_t PlacedFeatures::smooth_surface(std::uint32_t triangle) const {
  const Placement& place = places->of_triangle(triangle);
  const std::uint32_t first = places->own_triangles + place.first_triangle;
  return first + meshes[place.mesh]->smooth_surface(triangle - first);
}

float PlacedFeatures::deviation(std::uint32_t triangle) const {
  const Placement& place = places->of_triangle(triangle);
  const std::uint32_t local = triangle - places->own_triangles - place.first_triangle;
  return static_cast<float>(place.most_growth) * meshes[place.mesh]->deviation(local);
}

std::size_t PlacedFeatures::memory_bytes() const {
  std::size_t bytes = by_node_.memory_bytes() + by_chains_.memory_bytes() +
                      by_edge_.memory_bytes() + by_position_.memory_bytes();
  for (const auto& mesh : meshes) bytes += sizeof *mesh + mesh->memory_bytes();
  return bytes;
}

}  // namespace asos
