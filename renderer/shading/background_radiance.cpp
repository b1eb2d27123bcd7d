#include "renderer/shading/background_radiance.h"

#include "renderer/shading/sky.h"

#include <algorithm>

namespace asos {
namespace {

/// Width of the square of directions over which an environment is blurred, one unit ahead: some 50
/// degrees.
constexpr float blurred_width = 0.95f;

}  // namespace

BackgroundRadiance::BackgroundRadiance(const Background& chosen, const View& view)
    : chosen_(chosen) {
  if (chosen.kind == BackgroundKind::colours && chosen.top != chosen.bottom)
    picture_ = view.frame(0.0, 0.0, view.width(), view.height());
  if (chosen.kind == BackgroundKind::blurred) {
    const PixelSpacing spacing = PixelSpacing::of(view);
    right_ = blurred_width * glm::normalize(spacing.right);
    down_ = blurred_width * glm::normalize(spacing.down);
  }
}

glm::vec3 BackgroundRadiance::radiance(const Sky* sky, const Ray& ray, const PixelSpacing* spacing,
                                       float side) const {
  switch (chosen_.kind) {
    case BackgroundKind::transparent:
      return glm::vec3(0.0f);
    case BackgroundKind::colours: {
      if (!picture_) return chosen_.top;
      const glm::dvec3 on_ray = glm::dvec3(ray.origin) + glm::dvec3(ray.direction);
      const glm::dvec3 at = picture_->homogeneous(on_ray);
      const double down = std::clamp(picture_->parallel() ? at.y : at.y / at.z, 0.0, 1.0);
      return glm::mix(chosen_.top, chosen_.bottom, static_cast<float>(down));
    }
    case BackgroundKind::blurred:
      if (sky) return sky->radiance(ray.direction, right_, down_);
      break;
    case BackgroundKind::environment:
      break;
  }
  return background(sky, ray.direction, spacing, side);
}

std::optional<glm::vec3> BackgroundRadiance::everywhere(const Sky* sky) const {
  const bool one_colour = chosen_.kind == BackgroundKind::colours && !picture_;
  const bool one_sky = chosen_.kind != BackgroundKind::colours && (!sky || sky->constant());
  if (chosen_.kind != BackgroundKind::transparent && !one_colour && !one_sky) return std::nullopt;
  return radiance(sky, Ray{}, nullptr, 0.0f);
}

}  // namespace asos
