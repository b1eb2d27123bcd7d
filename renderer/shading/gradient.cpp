#include "renderer/shading/gradient.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

/// The mean of max(0, x) over x from `middle` - `half_range` to `middle` + `half_range`.
double mean_above_0(double middle, double half_range) {
  if (std::abs(middle) >= half_range) return std::max(0.0, middle);
  return (middle + half_range) * (middle + half_range) / (4.0 * half_range);
}

/// The mean over the same range of what goes from 0 at -ramp to 1 at ramp.
double mean_of_step(double middle, double half_range) {
  constexpr double ramp = Gradient::ramp;
  if (std::abs(middle) >= half_range + ramp) return middle > 0.0 ? 1.0 : 0.0;
  // A range this narrow would be lost in rounding.
  if (half_range < 1e-7 * ramp) return std::clamp(0.5 + 0.5 * middle / ramp, 0.0, 1.0);
  return (mean_above_0(middle + half_range, ramp) - mean_above_0(middle - half_range, ramp)) /
         (2.0 * half_range);
}

/// ln(1 + x) / x, within 1e-5.
double log_share(double x) {
  if (x < 0.02) return 1.0 - x * (0.5 - x / 3.0);
  return static_cast<double>(std::log(static_cast<float>(1.0 + x))) / x;
}

}  // namespace

Gradient::Gradient(const Colours& colours)
    : colours_(colours),
      below_(colours.below),
      up_(glm::dvec3(colours.zenith) - glm::dvec3(colours.above)),
      down_(glm::dvec3(colours.nadir) - glm::dvec3(colours.below)),
      step_(glm::dvec3(colours.above) - glm::dvec3(colours.below)),
      has_step_(colours.above != colours.below) {}

bool Gradient::constant() const {
  return colours_ == Colours{colours_.zenith, colours_.zenith, colours_.zenith, colours_.zenith};
}

bool Gradient::linear_near(double height, double reach) const {
  return std::abs(height) >= reach + (has_step_ ? ramp : 0.0);
}

Gradient::Parts Gradient::parts_at(double height, double half_range) const {
  return {mean_above_0(height, half_range), mean_above_0(-height, half_range),
          has_step_ ? mean_of_step(height, half_range) : 0.0};
}

glm::dvec3 Gradient::sum_of(const Parts& parts) const {
  return below_ + parts.up * up_ + parts.down * down_ + parts.over * step_;
}

glm::dvec3 Gradient::mean(double height, double half_range) const {
  return sum_of(parts_at(height, half_range));
}

glm::dvec3 Gradient::around(double height, double width) const {
  // Points of a disk of radius r, one unit ahead, are on average 2 / (1 + sqrt(1 + r^2)) along the
  // direction once they are unit directions, and their squares ln(1 + r^2) / r^2 of it, the rest of
  // which is shared by the two directions across.
  const double square = width * width / std::numbers::pi;
  const double along = 2.0 / (1.0 + std::sqrt(1.0 + square));
  const double squared = log_share(square);
  const double up = height * height;
  const double variance = (squared - along * along) * up + 0.5 * (1.0 - squared) * (1.0 - up);
  return mean(along * height, std::sqrt(3.0 * std::max(0.0, variance)));
}

glm::dvec3 Gradient::irradiance_over_pi(glm::dvec3 normal) const {
  // The integral over the sphere of the product of two clamped cosines whose axes are theta apart
  // is 2/3 (sin(theta) + (pi - theta) cos(theta)) (the arc-cosine kernel of Cho and Saul 2009). The
  // axis of the lower half is pi - theta away. Of what lies above a height t a surface sees the
  // share (1 + cos(theta)) / 2 - 2 sin(theta) t / pi - cos(theta) t^2 / 2 + ..., here its mean over
  // the ramp.
  const double sine = std::sqrt(normal.x * normal.x + normal.z * normal.z);
  const double theta = std::atan2(sine, normal.y);
  constexpr double scale = 2.0 / (3.0 * std::numbers::pi);
  constexpr double less = ramp * ramp / 3.0;
  return sum_of({scale * (sine + (std::numbers::pi - theta) * normal.y),
                 scale * (sine - theta * normal.y), 0.5 + 0.5 * (1.0 - less) * normal.y});
}

}  // namespace asos
