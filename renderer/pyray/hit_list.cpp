#include "renderer/pyray/hit_list.h"

#include "renderer/geometry/clip_segment.h"
#include "renderer/pyray/node_test.h"
#include "renderer/pyray/tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace asos {
namespace {

// Flattening of curves for boundaries that are resolved at any size: as for cells of this side.
constexpr double finest_curve = 1.0 / 4096.0;

// Segments are cut this far outside the root square, so that they are straight across its border.
constexpr double margin = 1.0 / 16.0;
// An edge smaller than this in the square may be a point in float32. It is kept, in any
// direction, so that no sample is taken there.
constexpr double point_size = 1e-6;

// Returns the part of an edge between homogeneous end points within the pyray, widened by the
// margin, as parameters along the edge in world space. There is no division, so edges behind the
// apex need no special case.
std::optional<EdgeRange> inside(const Frame& frame, glm::dvec3 h0, glm::dvec3 h1) {
  const double w0 = frame.parallel() ? 1.0 : h0.z;
  const double w1 = frame.parallel() ? 1.0 : h1.z;
  EdgeRange range;
  range.keep(h0.x + margin * w0, h1.x + margin * w1);
  range.keep(h0.y + margin * w0, h1.y + margin * w1);
  range.keep((1.0 + margin) * w0 - h0.x, (1.0 + margin) * w1 - h1.x);
  range.keep((1.0 + margin) * w0 - h0.y, (1.0 + margin) * w1 - h1.y);
  range.keep(h0.z, h1.z);
  if (!(range.t0 < range.t1)) return std::nullopt;
  return range;
}

// Returns whether both faces of an edge project to the same side of it, seen from the apex. This
// depends on the edge only, not on the winding of the faces. Zero (a face seen edge-on) counts as
// yes.
bool is_silhouette(const Frame& frame, glm::dvec3 a, glm::dvec3 b, glm::dvec3 left,
                   glm::dvec3 right) {
  const glm::dvec3 side =
      frame.parallel() ? glm::cross(b - a, frame.direction()) : glm::cross(a - frame.apex(), b - a);
  return glm::dot(side, left - a) * glm::dot(side, right - a) >= 0.0;
}

// Returns the first edge below an entry that is a node or a leaf.
std::uint32_t first_edge(const FeatureSet& features, const HitEntry& e) {
  if (e.type == HitEntry::Type::leaf) return e.ref;
  FeatureNode room;
  const FeatureNode* node = &features.node(e.ref, room);
  while (node->edge_count[0] == FeatureNode::inner) node = &features.node(node->child[0], room);
  return node->child[0];
}

// Returns whether a child's box lies outside of the bounds.
bool outside(const SearchBounds& bounds, const FeatureNode& node, unsigned child) {
  for (const HalfSpace& half : bounds.within) {
    double farthest = -half.offset;
    for (int k = 0; k < 3; ++k) {
      const float* side = half.normal[k] > 0.0 ? node.hi[k] : node.lo[k];
      farthest += half.normal[k] * static_cast<double>(side[child]);
    }
    if (farthest < 0.0) return true;
  }
  return false;
}

}  // namespace

void HitLists::reset(const FeatureSet& features, const Frame& frame, float finest_side,
                     const SearchBounds& bounds) {
  features_ = &features;
  bounds_ = bounds;
  frame_ = frame;
  test_frame_ = NodeTestFrame(frame);
  finest_side_ = finest_side;
  // The map from the world to the square is steepest along the shorter height of the base
  // parallelogram.
  const glm::dvec3 a = frame.base_u(), b = frame.base_v();
  const double area = glm::length(glm::cross(a, b));
  squares_a_unit_ = static_cast<float>(std::max(glm::length(a), glm::length(b)) / area);
  entries_.clear();
  segments_.clear();
  root_.clear();
  scene_entries_ = 0;
  if (features_->empty()) return;
  // Begin with the cut, or with the hierarchy's root.
  if (bounds_.cut) {
    for (const CutNode& part : *bounds_.cut) open_node(part.node, part.children);
  } else {
    HitEntry root;
    root.u0 = root.v0 = -std::numeric_limits<float>::infinity();
    root.u1 = root.v1 = root.nearness = std::numeric_limits<float>::infinity();
    entries_.push_back(root);
  }
  root_.resize(entries_.size());
  std::iota(root_.begin(), root_.end(), 0u);
  scene_entries_ = root_.size();
}

void HitLists::add_boundary(glm::vec2 p, glm::vec2 q) {
  constexpr float nearness = std::numeric_limits<float>::max();
  root_.push_back(static_cast<std::uint32_t>(entries_.size()));
  keep_segment({p.x, p.y, nearness, q.x, q.y, nearness, FeatureEdge::none});
}

void HitLists::refine(const Square& cell, const CellOccluder& hiding,
                      std::span<const std::uint32_t> parent, List& list, bool seen) {
  list.clear();
  in_view_ = {};
  stops_at_too_many_ = seen;
  for (const std::uint32_t i : parent) visit(i, cell, hiding, list);

  // Few entries are left: open nodes, since their contents decide.
  while (list.size() <= SearchTuning::few_entries && !exhausted()) {
    const auto node = std::find_if(list.begin(), list.end(), [&](std::uint32_t i) {
      return !entries_[i].is_segment() && !hidden(i, cell, hiding);
    });
    if (node == list.end()) return;
    const std::uint32_t i = *node;
    list.erase(node);
    open(i);
    const HitEntry opened = entries_[i];
    for (std::uint32_t c = 0; c < opened.child_count; ++c)
      visit(opened.first_child + c, cell, hiding, list);
    if (list.size() > SearchTuning::many_entries) return;
  }
}

void HitLists::visit(std::uint32_t i, const Square& cell, const CellOccluder& hiding, List& list) {
  const HitEntry e = entries_[i];
  if (!e.meets(cell)) return;
  if (e.is_segment() && clip(segments_[e.ref], cell).empty()) return;
  const bool is_hidden = hiding.hides(std::max(e.u0, cell.u), std::max(e.v0, cell.v),
                                      std::min(e.u1, cell.u + cell.side),
                                      std::min(e.v1, cell.v + cell.side), e.nearness);
  if (e.is_segment()) {
    in_view_.segments += !is_hidden;
    list.push_back(i);
    return;
  }
  const float size = e.extent();
  if (is_hidden || size <= 0.25f * cell.side || size <= finest_side_ || too_many_boundaries() ||
      exhausted()) {
    in_view_.nodes += !is_hidden;
    list.push_back(i);
    return;
  }
  open(i);
  const std::uint32_t first = entries_[i].first_child;
  const std::uint32_t count = entries_[i].child_count;
  for (std::uint32_t c = 0; c < count; ++c) visit(first + c, cell, hiding, list);
}

bool HitLists::resolve(std::uint32_t i, const Square& cell, float tolerance, std::size_t limit,
                       List& list) {
  if (!entries_[i].meets(cell)) return true;
  if (straight(entries_[i], tolerance) && replace_by_chord(i)) i = entries_[i].chord;
  if (entries_[i].is_segment()) {
    if (!clip(segments_[entries_[i].ref], cell).empty()) list.push_back(i);
    return list.size() <= limit;
  }
  if (exhausted() && !entries_[i].opened) return false;
  open(i);
  const std::uint32_t first = entries_[i].first_child;
  const std::uint32_t count = entries_[i].child_count;
  for (std::uint32_t c = 0; c < count; ++c)
    if (!resolve(first + c, cell, tolerance, limit, list)) return false;
  return true;
}

// Returns whether an entry is a chain that looks straight. Its deviation from the chord in the
// world is projected at the chain's nearest point.
bool HitLists::straight(const HitEntry& e, float tolerance) const {
  if (e.is_segment() || !e.is_chain()) return false;
  return e.extent() <= tolerance ||
         e.chain_deviation * (frame_.parallel() ? 1.0f : e.nearness) * squares_a_unit_ <= tolerance;
}

// Makes the segment between a chain's ends, once.
bool HitLists::replace_by_chord(std::uint32_t i) {
  if (entries_[i].chord != FeatureEdge::none) return true;
  if (bounds_.ignores(features_->edge(first_edge(*features_, entries_[i])).a)) return false;
  const auto chord = static_cast<std::uint32_t>(entries_.size());
  add_segment(first_edge(*features_, entries_[i]), features_->position(entries_[i].chain[0]),
              features_->position(entries_[i].chain[1]));
  if (entries_.size() == chord) return false;
  entries_[i].chord = chord;
  return true;
}

std::optional<FeatureKind> HitLists::kind(std::uint32_t i) const {
  if (segment(i).edge == FeatureEdge::none) return std::nullopt;
  const FeatureEdge edge = features_->edge(segment(i).edge);
  const bool may_be_silhouette =
      edge.folds && edge.right != FeatureEdge::none &&
      (edge.kind == FeatureKind::crease || edge.kind == FeatureKind::seam);
  if (!may_be_silhouette) return edge.kind;
  const bool silhouette =
      is_silhouette(frame_, features_->position(edge.a), features_->position(edge.b),
                    features_->position(edge.left), features_->position(edge.right));
  return silhouette ? FeatureKind::silhouette : edge.kind;
}

bool HitLists::hidden(std::uint32_t i, const Square& cell, const CellOccluder& hiding) const {
  const HitEntry& e = entries_[i];
  if (!e.is_segment()) {
    return hiding.hides(std::max(e.u0, cell.u), std::max(e.v0, cell.v),
                        std::min(e.u1, cell.u + cell.side), std::min(e.v1, cell.v + cell.side),
                        e.nearness);
  }
  const Segment& s = segments_[e.ref];
  const SegmentPart<float> c = clip(s, cell);
  for (const float t : {c.t0, c.t1}) {
    if (!hiding.hides(s.u0 + t * (s.u1 - s.u0), s.v0 + t * (s.v1 - s.v0),
                      s.nearness0 + t * (s.nearness1 - s.nearness0)))
      return false;
  }
  return true;
}

bool HitLists::too_many_boundaries() const {
  return stops_at_too_many_ && (in_view_.nodes >= SearchTuning::most_nodes_in_front ||
                                in_view_.segments >= SearchTuning::most_segments_in_front);
}

void HitLists::open(std::uint32_t i) {
  if (entries_[i].opened) return;
  const auto first = static_cast<std::uint32_t>(entries_.size());
  if (entries_[i].type == HitEntry::Type::node) {
    open_node(entries_[i].ref, ~0u);
  } else {
    open_leaf(i);
  }
  entries_[i].opened = true;
  entries_[i].first_child = first;
  entries_[i].child_count = static_cast<std::uint16_t>(entries_.size() - first);
}

void HitLists::open_node(std::uint32_t number, unsigned children) {
  FeatureNode room;
  NodeChains room_for_chains;
  const FeatureNode& node = features_->node(number, room);
  const NodeTestResult test = test_children(node, test_frame_);
  for (unsigned kept = test.kept & children; kept != 0; kept &= kept - 1) {
    const auto c = static_cast<unsigned>(__builtin_ctz(kept));
    if (outside(bounds_, node, c)) continue;
    HitEntry child;
    child.u0 = test.u0[c];
    child.v0 = test.v0[c];
    child.u1 = test.u1[c];
    child.v1 = test.v1[c];
    child.nearness = test.nearness[c];
    child.ref = node.child[c];
    child.edge_count = node.edge_count[c];
    if (node.chains != FeatureNode::no_chains) {
      const NodeChains& chains = features_->chains(node.chains, room_for_chains);
      child.chain[0] = chains.end[0][c];
      child.chain[1] = chains.end[1][c];
      child.chain_deviation = chains.deviation[c];
    }
    child.type =
        node.edge_count[c] == FeatureNode::inner ? HitEntry::Type::node : HitEntry::Type::leaf;
    entries_.push_back(child);
  }
}

void HitLists::open_leaf(std::uint32_t i) {
  const std::uint32_t first = entries_[i].ref;
  const std::uint32_t count = entries_[i].edge_count;
  for (std::uint32_t e = first; e < first + count; ++e) {
    const FeatureEdge edge = features_->edge(e);
    if (edge.is_curve()) {
      add_curve(e);
      continue;
    }
    if (bounds_.ignores(edge.a)) continue;
    const glm::dvec3 a = features_->position(edge.a);
    const glm::dvec3 b = features_->position(edge.b);
    if (edge.kind == FeatureKind::silhouette &&
        !is_silhouette(frame_, a, b, features_->position(edge.left),
                       features_->position(edge.right)))
      continue;
    add_segment(e, a, b);
  }
}

// Adds the parts of an analytic shape's curve within the pyray, in straight pieces.
void HitLists::add_curve(std::uint32_t edge) {
  const FeatureCurve& curve = features_->curves()[features_->edge(edge).curve()];
  const ShapeFace* face = curve.face == FeatureCurve::none ? nullptr : &features_->face(curve.face);
  const FaceOutline outline = face ? face_outline(*face, frame_) : FaceOutline{};
  const std::span<const double> angles(outline.angle, static_cast<std::size_t>(outline.line_count));
  if (curve.outline && !outline.has_arc) {
    const EllipseArc bottom = ring(*face, 0.0), top = ring(*face, 1.0);
    for (const double angle : angles) add_segment(edge, bottom.at(angle), top.at(angle));
    return;
  }
  // Rims have a joint where the lines of the outline end.
  const FlattenBounds bounds{margin, bounds_.within, bounds_.beyond_first};
  for (Segment s :
       flattener_.flatten(frame_, curve.outline ? outline.arc : curve.arc,
                          curve.outline ? std::span<const double>() : angles,
                          std::max(static_cast<double>(finest_side_), finest_curve), bounds)) {
    s.edge = edge;
    if (std::isfinite(s.u0 + s.v0 + s.u1 + s.v1)) keep_segment(s);
  }
}

// Adds the part of an edge within the pyray, if any.
void HitLists::add_segment(std::uint32_t edge, glm::dvec3 a, glm::dvec3 b) {
  // Clip the edge to the pyray and to the bounds.
  const glm::dvec3 h0 = frame_.homogeneous(a);
  const glm::dvec3 h1 = frame_.homogeneous(b);
  std::optional<EdgeRange> range = inside(frame_, h0, h1);
  if (!range) return;
  for (std::size_t k = 0; k < bounds_.within.size(); ++k) {
    const double ha = bounds_.within[k].height(a), hb = bounds_.within[k].height(b);
    const double beyond = k == 0 && std::max(ha, hb) > 0.0 ? bounds_.beyond_first : 0.0;
    range->keep(ha + beyond, hb + beyond);
  }
  if (!(range->t0 < range->t1)) return;
  // Project the part that is left.
  const FramePoint p0 = frame_.project(range->t0 > 0.0 ? h0 + range->t0 * (h1 - h0) : h0);
  const FramePoint p1 = frame_.project(range->t1 < 1.0 ? h0 + range->t1 * (h1 - h0) : h1);
  Segment s;
  s.u0 = static_cast<float>(p0.u), s.v0 = static_cast<float>(p0.v);
  s.u1 = static_cast<float>(p1.u), s.v1 = static_cast<float>(p1.v);
  s.nearness0 = static_cast<float>(p0.nearness), s.nearness1 = static_cast<float>(p1.nearness);
  s.edge = edge;
  // An edge seen end-on is a point and no boundary; one through the apex has no projection.
  if (!std::isfinite(s.u0 + s.v0 + s.u1 + s.v1)) return;
  const double length =
      glm::distance(a, b) * (frame_.parallel() ? 1.0 : std::max(p0.nearness, p1.nearness));
  if (s.u0 == s.u1 && s.v0 == s.v1 && !(length * static_cast<double>(squares_a_unit_) < point_size))
    return;
  keep_segment(s);
}

void HitLists::keep_segment(const Segment& s) {
  HitEntry entry;
  entry.type = HitEntry::Type::segment;
  entry.u0 = std::min(s.u0, s.u1), entry.u1 = std::max(s.u0, s.u1);
  entry.v0 = std::min(s.v0, s.v1), entry.v1 = std::max(s.v0, s.v1);
  entry.nearness = std::max(s.nearness0, s.nearness1);
  entry.ref = static_cast<std::uint32_t>(segments_.size());
  segments_.push_back(s);
  entries_.push_back(entry);
}

}  // namespace asos
