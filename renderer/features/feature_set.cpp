#include "renderer/features/feature_set.h"

#include "renderer/features/placed_features.h"
#include "renderer/features/placed_intersections.h"
#include "renderer/features/release.h"
#include "renderer/features/shape_intersections.h"
#include "renderer/features/welded_vertices.h"
#include "renderer/world/render_features.h"
#include "renderer/world/surface_kind.h"

#include <algorithm>
#include <utility>

namespace asos {

// The stages run one after the other. Each keeps all processors busy, and its memory is free for
// the next one.
FeatureSet::FeatureSet(const World& world, TextureAt texture_at, const std::stop_token& stop) {
  if (world.placements) {
    find_placed(world, texture_at, stop);
    return;
  }
  find(world, texture_at, stop);
  hierarchy_ =
      FeatureHierarchy::build(positions_, edges_, curves_, FeatureHierarchy::few_edges, stop);
}

// Finds all boundaries of a world without placed meshes, but not their hierarchy.
void FeatureSet::find(const World& world, TextureAt texture_at, const std::stop_token& stop) {
  positions_ = world.positions.own();
  CutOuts cut_outs = find_cut_outs(world, {}, stop);
  std::vector<std::uint32_t> welded = welded_vertices(positions_, stop);
  ExtractedFeatures extracted =
      extract_features(world, welded, texture_at, stop, cut_outs.hidden_sides);
  counts_ = extracted.counts;
  edges_ = std::move(extracted.edges);
  surface_of_triangle_ = std::move(extracted.surface_of_triangle);
  deviation_of_triangle_ = std::move(extracted.deviation_of_triangle);
  add_shapes(world);
  add(find_intersections(world, welded, IntersectionBudget::of(world), stop));
  release(welded);
  add_shape_intersections(world);
  add(world, std::move(cut_outs));
}

void FeatureSet::find_placed(const World& world, TextureAt texture_at,
                             const std::stop_token& stop) {
  auto placed = std::make_shared<PlacedFeatures>(world, texture_at, stop);
  if (!world.triangles.own().empty()) find(without_placements(world), texture_at, stop);
  for (const Placement& place : world.placements->places)
    counts_ += placed->meshes[place.mesh]->counts();
  for (const auto& mesh : placed->meshes)
    intersections_complete_ = intersections_complete_ && mesh->intersections_complete();
  placed_ = placed;
  add(find_placed_intersections(world, IntersectionBudget::of(world), stop));
  FeatureHierarchy own =
      FeatureHierarchy::build(positions_, edges_, curves_, FeatureHierarchy::few_edges, stop);
  hierarchy_ = placed->behind(std::move(own), edges_.size(), positions_.size());
}

const FeatureNode& FeatureSet::placed_node(std::uint32_t number, FeatureNode& room) const {
  return room = placed_->node(number);
}

const NodeChains& FeatureSet::placed_chains(std::uint32_t number, NodeChains& room) const {
  return room = placed_->chains(number);
}

FeatureEdge FeatureSet::placed_edge(std::uint32_t number) const {
  return placed_->edge(number);
}

glm::dvec3 FeatureSet::placed_position(std::uint32_t number) const {
  return placed_->position(number);
}

std::uint32_t FeatureSet::placed_smooth_surface(std::uint32_t triangle) const {
  return placed_->smooth_surface(triangle);
}

float FeatureSet::placed_deviation(std::uint32_t triangle) const {
  return placed_->deviation(triangle);
}

// Each face is a smooth surface of its own.
void FeatureSet::add_shapes(const World& world) {
  faces_ = world.faces;
  for (const ShapeFace& face : faces_) {
    surface_of_triangle_.push_back(static_cast<std::uint32_t>(surface_of_triangle_.size()));
    deviation_of_triangle_.push_back(
        face.kind == ShapeFace::Kind::disk ? 0.0f : static_cast<float>(face.size));
  }
  ShapeFeatures shapes = shape_features(world);
  curves_ = std::move(shapes.curves);
  edges_.insert(edges_.end(), shapes.edges.begin(), shapes.edges.end());
  for (const FeatureEdge& edge : shapes.edges) {
    counts_.open += edge.kind == FeatureKind::open;
    counts_.crease += edge.kind == FeatureKind::crease;
    counts_.silhouette_candidates += edge.kind == FeatureKind::silhouette;
  }
}

void FeatureSet::add(const Intersections& found) {
  intersections_complete_ = intersections_complete_ && found.complete;
  counts_.intersection += found.lines.size();
  for (const IntersectionLine& line : found.lines) {
    FeatureEdge edge;
    edge.a = static_cast<std::uint32_t>(positions_.size());
    edge.b = edge.a + 1;
    edge.left_surface = smooth_surface(line.first_triangle);
    edge.right_surface = smooth_surface(line.second_triangle);
    edge.kind = FeatureKind::intersection;
    edges_.push_back(edge);
    positions_.push_back(line.a);
    positions_.push_back(line.b);
  }
}

void FeatureSet::add_shape_intersections(const World& world) {
  if (world.faces.empty()) return;
  const ShapeIntersections found = find_shape_intersections(world);
  add(Intersections{found.lines, found.complete});
  for (const IntersectionArc& crossing : found.arcs) {
    FeatureEdge edge;
    edge.left_surface = smooth_surface(crossing.triangle);
    edge.right_surface = smooth_surface(crossing.face);
    edge.kind = FeatureKind::intersection;
    edge.set_curve(static_cast<std::uint32_t>(curves_.size()));
    curves_.push_back(FeatureCurve::of(crossing.arc));
    edges_.push_back(edge);
    ++counts_.intersection;
  }
}

void FeatureSet::add(const World& world, CutOuts found) {
  const auto first = static_cast<std::uint32_t>(positions_.size());
  for (const CutOutLine& line : found.lines) {
    FeatureEdge edge;
    edge.a = first + line.a;
    edge.b = first + line.b;
    edge.left_surface = smooth_surface(line.triangle);
    edge.kind = FeatureKind::cut_out;
    edges_.push_back(edge);
  }
  positions_.insert(positions_.end(), found.positions.begin(), found.positions.end());
  counts_.cut_out += found.lines.size();
  outlined_ = std::move(found.outlined);
  // Record the features that are left to samples.
  const auto kind_of = [&](const Part& part) {
    return surface_kind(world.materials[part.material]);
  };
  for (std::uint32_t s = 0; s < outlined_.size() && !cut_outs_unbounded_; ++s) {
    const Part& part = world.parts[world.triangle_part[s]];
    cut_outs_unbounded_ = outlined_[s] == 0 && kind_of(part) == SurfaceKind::masked;
  }
  opacity_unbounded_ =
      cut_outs_unbounded_ ||
      std::any_of(world.parts.begin(), world.parts.end(), [&](const Part& part) {
        return kind_of(part) == SurfaceKind::blended && opacity_varies(world, part);
      });
}

std::size_t FeatureSet::memory_bytes() const {
  return hierarchy_.nodes.size() * sizeof(FeatureNode) +
         hierarchy_.chains.size() * sizeof(NodeChains) + edges_.size() * sizeof(FeatureEdge) +
         surface_of_triangle_.size() * sizeof(std::uint32_t) +
         deviation_of_triangle_.size() * sizeof(float) + curves_.size() * sizeof(FeatureCurve) +
         faces_.size() * sizeof(ShapeFace) + outlined_.size() +
         positions_.size() * sizeof(glm::vec3) + (placed_ ? placed_->memory_bytes() : 0);
}

}  // namespace asos
