#include "renderer/shadows/patch_points.h"

#include "renderer/shading/reflected_light.h"
#include "renderer/shadows/shadow_context.h"

#include <algorithm>

namespace asos {
namespace {

// Returns whether the surface is the plane of the point's triangle within a leaf.
bool flat(const ShadowContext& block, const SurfacePoint& point) {
  return block.scene->features.deviation(point.triangle) <= 0.0f;
}

}  // namespace

void PatchPoints::start(const ShadowContext& block, const ShadowQuery& query) {
  const std::uint64_t seed = query.leaf.seed;
  sobol_.emplace(static_cast<int>(seed >> 32), static_cast<int>(seed), query.lit.index);
  on_pixel_.forget();
  const bool by_lobe = block.rules.error_budget.refines() &&
                       query.lit.light.rule == LightRule::physical && is_broad(query.lit);
  by_ = by_lobe ? RayWeighting::radiance : RayWeighting::irradiance;
}

const ShadingPoints& PatchPoints::look(const ShadowContext& block, const ShadowQuery& query,
                                       std::uint32_t first, std::uint32_t end,
                                       RenderStatistics& counts) {
  const SurfacePoint& point = query.lit.point;
  points_.count = 0;
  numbers_.clear();
  if (!has_patch(block, query.lit)) {
    for (std::uint32_t i = first; i < end; ++i) add_number(i);
    add(query, point);
    points_.repeat_first(end - first, by_ == RayWeighting::radiance);
    return points_;
  }
  place(query.leaf.region, first, end);
  if (!flat(block, point)) {
    // A curved surface deviates from its plane within the patch.
    const std::uint32_t smooth_surface = block.scene->features.smooth_surface(point.triangle);
    block.view->look(places_, seen_, counts);
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const SurfacePoint& seen = seen_[k];
      if (seen.triangle == Hit::none ||
          block.scene->features.smooth_surface(seen.triangle) != smooth_surface)
        continue;
      add_number(number_of_[k]);
      add(query, seen);
    }
    return points_;
  }
  // Place the points on the patch that the viewer sees.
  const glm::dvec3 middle(point.lit_position());
  const PlaneCrossings plane(*block.frame,
                             HalfSpace::through(middle, glm::dvec3(point.geometric_normal)));
  std::size_t found = 0;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const auto on_plane = plane.at(glm::dvec2(places_[k]));
    if (!on_plane) continue;
    if (found == 0) {
      add(query, point);
      points_.repeat_first(places_.size(), by_ == RayWeighting::radiance);
    }
    add_number(number_of_[k]);
    points_.position.set(found, glm::vec3(*on_plane));
    const auto from_middle = static_cast<float>(glm::distance(*on_plane, middle));
    points_.to_edge[found] = std::max(0.0f, point.to_edge - from_middle);
    ++found;
  }
  points_.count = found;
  return points_;
}

const LightPointBatch& PatchPoints::on_light(std::uint32_t light) {
  numbers_.on_light(light, on_light_);
  return on_light_;
}

// Computes the points' places in the leaf.
void PatchPoints::place(const LeafRegion& region, std::uint32_t first, std::uint32_t end) {
  const Bounds2 box = bounds_of(region);
  places_.clear();
  number_of_.clear();
  for (std::uint32_t i = first; i < end; ++i) {
    const glm::vec2 at = glm::mix(box.lo, box.hi, glm::vec2(on_pixel_.at(*sobol_, i)));
    if (!region.holds(at)) continue;
    places_.push_back(at);
    number_of_.push_back(i);
  }
}

void PatchPoints::add(const ShadowQuery& query, const SurfacePoint& at) {
  if (by_ == RayWeighting::radiance) {
    const LightingQuery& lit = *query.lit.lit;
    // The points are distributed over the patch; none of them represents it.
    const ViewedPoint view = viewed_point(at, lit.view.to_viewer);
    points_.add({lit.lights, view, lit.material, lit.mirrored, lit.share, lit.shadows},
                glm::vec3(1.0f));
  } else {
    points_.add(at);
  }
}

void PatchPoints::add_number(std::uint32_t number) {
  if (numbers_.empty()) {
    numbers_.add(*sobol_, number);
  } else {
    numbers_.add(number);
  }
}

}  // namespace asos
