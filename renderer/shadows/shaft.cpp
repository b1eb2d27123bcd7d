#include "renderer/shadows/shaft.h"

#include "renderer/geometry/clip_segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {
namespace {

// Error of single precision in the tests below: a few units of the largest coordinate.
constexpr float relative_error = 16.0f * std::numeric_limits<float>::epsilon();

}  // namespace

Shaft::Shaft(const Box& from, const Box& to) {
  bounds_ = from;
  bounds_.grow(to);
  const glm::vec3 error = relative_error * glm::max(glm::abs(bounds_.lo), glm::abs(bounds_.hi));
  bounds_.lo -= error;
  bounds_.hi += error;
  add_bevels(from, to, 0, 1);
  add_bevels(from, to, 0, 2);
  add_bevels(from, to, 1, 2);
}

// In the plane of axes i and j, the hull of two rectangles has their own sides, and those lines
// between corresponding corners that have everything on one side.
void Shaft::add_bevels(const Box& from, const Box& to, int i, int j) {
  const auto corner = [&](const Box& box, int c) {
    return glm::dvec2((c & 1) ? box.hi[i] : box.lo[i], (c & 2) ? box.hi[j] : box.lo[j]);
  };
  for (int c = 0; c < 4; ++c) {
    // Take the line between two corresponding corners.
    const glm::dvec2 start = corner(from, c);
    const glm::dvec2 along = corner(to, c) - start;
    const double length = glm::length(along);
    if (!(length > 0.0) || along.x == 0.0 || along.y == 0.0) continue;
    glm::dvec2 normal = glm::dvec2(-along.y, along.x) / length;
    // Keep it if all corners lie on one side of it, with a normal to that side.
    double lowest = 0.0, highest = 0.0;
    for (int k = 0; k < 4; ++k) {
      for (const Box* box : {&from, &to}) {
        const double height = glm::dot(normal, corner(*box, k) - start);
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
      }
    }
    const double slack = 1e-9 * (highest - lowest);
    if (lowest < -slack && highest > slack) continue;
    if (lowest < -slack) normal = -normal;
    const double size = glm::length(glm::max(glm::abs(start), glm::abs(start + along)));
    const double offset = glm::dot(normal, start) - relative_error * size;
    if (count_ < bevels_.size())
      bevels_[count_++] = {i, j, static_cast<float>(normal.x), static_cast<float>(normal.y),
                           static_cast<float>(offset)};
  }
}

unsigned Shaft::met_children(const FeatureNode& node) const {
  constexpr int width = FeatureNode::width;
  // Test the boxes against the bounds and the bevels.
  bool met[width];
  for (int c = 0; c < width; ++c) {
    met[c] = node.lo[0][c] <= bounds_.hi[0] && node.hi[0][c] >= bounds_.lo[0] &&
             node.lo[1][c] <= bounds_.hi[1] && node.hi[1][c] >= bounds_.lo[1] &&
             node.lo[2][c] <= bounds_.hi[2] && node.hi[2][c] >= bounds_.lo[2];
  }
  for (std::size_t b = 0; b < count_; ++b) {
    const Bevel& bevel = bevels_[b];
    const float* first = bevel.first > 0.0f ? node.hi[bevel.i] : node.lo[bevel.i];
    const float* second = bevel.second > 0.0f ? node.hi[bevel.j] : node.lo[bevel.j];
    for (int c = 0; c < width; ++c)
      met[c] = met[c] & (bevel.first * first[c] + bevel.second * second[c] >= bevel.offset);
  }
  // Keep those that also reach into the half-space.
  unsigned kept = 0;
  for (unsigned c = 0; c < node.child_count; ++c) {
    if (!met[c]) continue;
    if (half_) {
      double farthest = -half_->offset;
      for (int k = 0; k < 3; ++k)
        farthest += half_->normal[k] *
                    static_cast<double>((half_->normal[k] > 0.0 ? node.hi : node.lo)[k][c]);
      if (farthest < 0.0) continue;
    }
    kept |= 1u << c;
  }
  return kept;
}

bool Shaft::meets(const Box& box) const {
  FeatureNode node{};
  node.child_count = 1;
  for (int k = 0; k < 3; ++k) {
    node.lo[k][0] = box.lo[k];
    node.hi[k][0] = box.hi[k];
  }
  return met_children(node) != 0;
}

bool Shaft::meets(glm::vec3 a, glm::vec3 b) const {
  EdgeRange range;
  for (int k = 0; k < 3; ++k) {
    range.keep(static_cast<double>(a[k]) - bounds_.lo[k],
               static_cast<double>(b[k]) - bounds_.lo[k]);
    range.keep(static_cast<double>(bounds_.hi[k]) - a[k],
               static_cast<double>(bounds_.hi[k]) - b[k]);
  }
  for (std::size_t i = 0; i < count_; ++i) {
    const Bevel& bevel = bevels_[i];
    const auto height = [&](glm::vec3 p) {
      return static_cast<double>(bevel.first) * p[bevel.i] +
             static_cast<double>(bevel.second) * p[bevel.j] - bevel.offset;
    };
    range.keep(height(a), height(b));
  }
  if (half_) range.keep(half_->height(glm::dvec3(a)), half_->height(glm::dvec3(b)));
  return range.t0 <= range.t1;
}

namespace {

bool meets_edge(const FeatureSet& features, const Shaft& shaft, const FeatureEdge& e) {
  if (e.is_curve()) return shaft.meets(features.curves()[e.curve()].box);
  return shaft.meets(glm::vec3(features.position(e.a)), glm::vec3(features.position(e.b)));
}

}  // namespace

void search_shaft(const FeatureSet& features, const Shaft& shaft, const SearchBounds& ignored,
                  std::size_t most, ShaftSearch& found) {
  found.cut.clear();
  found.complete = true;
  if (features.empty()) return;
  FeatureNode room;
  const auto leaf_meets = [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      const FeatureEdge e = features.edge(i);
      if (!e.is_curve() && ignored.ignores(e.a)) continue;
      if (meets_edge(features, shaft, e)) return true;
    }
    return false;
  };
  // Breadth first, so that unopened nodes are as small as possible. `next` is the node to open;
  // opened nodes keep only the runs of edges that they contain.
  FeatureCut& cut = found.cut;
  const auto meet = [&](std::uint32_t node) {
    const unsigned children = shaft.met_children(features.node(node, room));
    if (children) cut.push_back({node, children});
  };
  meet(0);
  for (std::size_t next = 0; next < cut.size(); ++next) {
    if (cut.size() > most) {
      found.complete = false;
      break;
    }
    // `meet` overwrites `room`, so this needs its own.
    FeatureNode own_room;
    const FeatureNode& node = features.node(cut[next].node, own_room);
    unsigned leaves = 0;
    for (unsigned left = cut[next].children; left != 0; left &= left - 1) {
      const auto c = static_cast<unsigned>(__builtin_ctz(left));
      if (node.edge_count[c] == FeatureNode::inner) {
        meet(node.child[c]);
      } else if (leaf_meets(node.child[c], node.edge_count[c])) {
        leaves |= 1u << c;
      }
    }
    cut[next].children = leaves;
  }
  std::erase_if(cut, [](const CutNode& part) { return part.children == 0; });
}

bool any_edge(const FeatureSet& features, const Shaft& shaft,
              const std::function<bool(const FeatureEdge&)>& asked_for) {
  if (features.empty()) return false;
  FeatureNode room;
  std::vector<std::uint32_t> left{0};
  while (!left.empty()) {
    const FeatureNode& node = features.node(left.back(), room);
    left.pop_back();
    for (unsigned met_ones = shaft.met_children(node); met_ones != 0; met_ones &= met_ones - 1) {
      const auto c = static_cast<unsigned>(__builtin_ctz(met_ones));
      if (node.edge_count[c] == FeatureNode::inner) {
        left.push_back(node.child[c]);
        continue;
      }
      for (std::uint32_t i = node.child[c]; i < node.child[c] + node.edge_count[c]; ++i) {
        const FeatureEdge e = features.edge(i);
        if (asked_for(e) && meets_edge(features, shaft, e)) return true;
      }
    }
  }
  return false;
}

}  // namespace asos
