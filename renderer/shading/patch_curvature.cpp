#include "renderer/shading/patch_curvature.h"

#include "renderer/shading/anisotropy.h"
#include "renderer/shading/patch_lobe.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {

PatchCurvature PatchCurvature::at(const World& world, const Hit& hit, const ViewedPoint& view,
                                  const ViewedMaterial& material, float negligible) {
  const glm::vec3 normal = view.point.shading_normal;
  PatchCurvature bend{normal_turn(world, hit, view.patch, normal)};
  if (!material.lobe.stretch.none())
    bend.stretch_turn = tangent_turn(world, hit, view.patch, normal);
  bend.rounded = world.is_face(hit.triangle);
  bend.negligible = negligible;
  return bend;
}

std::optional<PatchCurvature::Parts> PatchCurvature::parts_for(const NormalSpread& spread,
                                                               float shown) {
  if (glm::dot(spread.right, spread.right) + glm::dot(spread.down, spread.down) <=
      most_bent * shown * shown)
    return Parts{};
  const float widest = std::sqrt(0.5f * most_bent) * shown;
  const float right = std::ceil(glm::length(spread.right) / widest);
  const float down = std::ceil(glm::length(spread.down) / widest);
  if (!(std::max(right, down) <= static_cast<float>(most_parts))) return std::nullopt;
  return Parts{std::max(1, static_cast<int>(right)), std::max(1, static_cast<int>(down))};
}

PatchCurvature::CentreEstimate PatchCurvature::of_middle(const ViewedPoint& view, const Lobe& lobe,
                                                         const PreparedLight& light,
                                                         const Highlight& highlight) const {
  const bool distant = light.traits().infinite;
  const float distance =
      distant ? std::numeric_limits<float>::infinity()
              : static_cast<float>(glm::distance(light.position, glm::dvec3(view.point.position)));
  const NormalSpread spread = spread_about_half(
      turn, view.patch, {view.to_viewer, view.distance, highlight.direction, distance});
  const float spread2 = glm::dot(spread.right, spread.right) + glm::dot(spread.down, spread.down);
  const float alpha = lobe.alpha();
  const bool line = light.traits().line;
  const float shown = alpha + (line ? 0.0f : 0.5f * highlight.half_angle_tangent);
  // The horizon adds a kink if the highlight rises or sets within the patch.
  const float turn2 = glm::dot(turn.right, turn.right) + glm::dot(turn.down, turn.down);
  const float height = glm::dot(view.point.shading_normal, highlight.direction);
  const bool sets = height < std::sqrt(turn2);
  const glm::vec3 half = glm::normalize(highlight.direction + view.to_viewer);
  const float away = lobe.away_from_peak(view.point.shading_normal, half);
  const float nearest = std::max(0.0f, away - 0.5f * std::sqrt(spread2));
  // In a lobe's tails, the length scale is the distance from its peak.
  CentreEstimate of{1.0f, parts_for(spread, std::hypot(shown, nearest))};
  if (!of.parts || sets) return of;
  of.error = std::min(1.0f, spread2 / (6.0f * (alpha * alpha + nearest * nearest)));
  return of;
}

// A curved surface lies below its tangent plane by half of place * normal, so that the viewer's
// rays hit it farther away.
PatchCurvature::Step PatchCurvature::step(const ViewedPoint& view, float u, float v) const {
  const glm::vec3 right = view.patch.right, down = view.patch.down;
  Step step{u * right + v * down, u * turn.right + v * turn.down};
  if (!rounded) return step;
  const float below = 0.5f * glm::dot(step.place, step.normal);
  const glm::vec3 on = -(below / view.n_dot_v) * view.to_viewer;
  const float rr = glm::dot(right, right), rd = glm::dot(right, down), dd = glm::dot(down, down);
  const float determinant = rr * dd - rd * rd;
  if (!(determinant > 0.0f)) return step;
  const float along_right = glm::dot(on, right), along_down = glm::dot(on, down);
  const float more_u = (along_right * dd - along_down * rd) / determinant;
  const float more_v = (along_down * rr - along_right * rd) / determinant;
  step.place += on;
  step.normal += more_u * turn.right + more_v * turn.down;
  return step;
}

PatchCurvature::Point PatchCurvature::point(const ViewedPoint& view, const ViewedMaterial& material,
                                            glm::vec2 uv) const {
  const Step from_middle = step(view, uv.x, uv.y);
  Point point{view.point, view.to_viewer, material};
  SurfacePoint& surface = point.surface;
  surface.position += from_middle.place;
  surface.shading_normal = glm::normalize(surface.shading_normal + from_middle.normal);
  if (surface.smooth_normal != glm::vec3(0.0f))
    surface.smooth_normal = glm::normalize(surface.smooth_normal + from_middle.normal);
  // No spread remains, since the several points resolve the patch's turn.
  surface.spread.right = surface.spread.down = glm::vec3(0.0f);
  if (rounded) {
    surface.geometric_normal = surface.shading_normal;
    surface.forget_smooth_surface();
  }
  if (std::isfinite(view.distance))
    point.to_viewer = glm::normalize(view.to_viewer - from_middle.place / view.distance);
  if (!material.lobe.stretch.none()) {
    const float angle = glm::dot(uv, stretch_turn);
    glm::vec3& along = point.material.lobe.stretch.along;
    along = std::cos(angle) * along + std::sin(angle) * glm::cross(surface.shading_normal, along);
  }
  return point;
}

}  // namespace asos
