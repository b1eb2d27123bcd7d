#include "renderer/shading/gradient.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

/// Returns the mean of max(0, x) over x from `middle` - `half_range` to `middle` + `half_range`.
template <typename T>
T mean_above_0(T middle, T half_range) {
  if (std::abs(middle) >= half_range) return std::max(T(0), middle);
  return (middle + half_range) * (middle + half_range) / (T(4) * half_range);
}

/// Returns the mean over the same range of a ramp from 0 at -ramp to 1 at ramp.
template <typename T>
T mean_of_step(T middle, T half_range) {
  constexpr T ramp = static_cast<T>(Gradient::ramp);
  if (std::abs(middle) >= half_range + ramp) return middle > T(0) ? T(1) : T(0);
  // A narrow range would be lost in rounding.
  if (half_range < T(1e-3) * ramp) return std::clamp(T(0.5) + T(0.5) * middle / ramp, T(0), T(1));
  return (mean_above_0(middle + half_range, ramp) - mean_above_0(middle - half_range, ramp)) /
         (T(2) * half_range);
}

/// ln(1 + x) / x, within 1e-5.
float log_share(float x) {
  if (x < 0.02f) return 1.0f - x * (0.5f - x / 3.0f);
  return std::log(1.0f + x) / x;
}

/// Returns the arc cosine within 2e-8 (Abramowitz and Stegun 4.4.46), at a third of the cost.
double angle_of_cosine(double cosine) {
  const double x = std::abs(cosine);
  const double angle =
      std::sqrt(std::max(0.0, 1.0 - x)) *
      (1.5707963050 +
       x * (-0.2145988016 +
            x * (0.0889789874 +
                 x * (-0.0501743046 +
                      x * (0.0308918810 +
                           x * (-0.0170881256 + x * (0.0066700901 - x * 0.0012624911)))))));
  return cosine < 0.0 ? std::numbers::pi - angle : angle;
}

}  // namespace

DiskMoments DiskMoments::of(float width) {
  // For unit directions to the points of a disk of radius r, one unit ahead, the mean component
  // along the axis is 2 / (1 + sqrt(1 + r^2)). The mean of its square is ln(1 + r^2) / r^2.
  const float square = width * width * std::numbers::inv_pi_v<float>;
  return {2.0f / (1.0f + std::sqrt(1.0f + square)), log_share(square)};
}

Gradient::Gradient(const Colours& colours)
    : colours_(colours),
      below_(colours.below),
      up_(glm::dvec3(colours.zenith) - glm::dvec3(colours.above)),
      down_(glm::dvec3(colours.nadir) - glm::dvec3(colours.below)),
      step_(glm::dvec3(colours.above) - glm::dvec3(colours.below)),
      has_step_(colours.above != colours.below) {}

bool Gradient::constant() const {
  return !has_step_ && up_ == glm::dvec3(0.0) && down_ == glm::dvec3(0.0);
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
  // The rest of the unit vectors' squared length, 1 - squared, is split equally between the two
  // directions across. Single precision, since it is computed for every sample of a surface.
  const auto y = static_cast<float>(height);
  const auto [along, squared] = DiskMoments::of(static_cast<float>(width));
  const float variance =
      (squared - along * along) * y * y + 0.5f * (1.0f - squared) * (1.0f - y * y);
  const float middle = along * y, half_range = std::sqrt(3.0f * std::max(0.0f, variance));
  // The part above 0 minus the part below 0 is the whole value.
  const float up = mean_above_0(middle, half_range);
  glm::vec3 sum = colours_.below + up * (colours_.zenith - colours_.above) +
                  (up - middle) * (colours_.nadir - colours_.below);
  if (has_step_) sum += mean_of_step(middle, half_range) * (colours_.above - colours_.below);
  return sum;
}

glm::dvec3 Gradient::irradiance_over_pi(glm::dvec3 normal) const {
  // The integral over the sphere of the product of two clamped cosines with axes theta apart is 2/3
  // (sin(theta) + (pi - theta) cos(theta)) (the arc-cosine kernel of Cho and Saul 2009). The axis
  // of the lower half is pi - theta away. The visible fraction of directions above a height t is (1
  // + cos(theta)) / 2 - 2 sin(theta) t / pi - cos(theta) t^2 / 2 + ..., here averaged over the
  // ramp.
  const double y = normal.y;
  const double sine = std::sqrt(std::max(0.0, 1.0 - y * y));
  const double theta = angle_of_cosine(y);
  constexpr double scale = 2.0 / (3.0 * std::numbers::pi);
  constexpr double less = ramp * ramp / 3.0;
  return sum_of({scale * (sine + (std::numbers::pi - theta) * y), scale * (sine - theta * y),
                 0.5 + 0.5 * (1.0 - less) * y});
}

}  // namespace asos
