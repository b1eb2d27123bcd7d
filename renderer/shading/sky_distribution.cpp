#include "renderer/shading/sky_distribution.h"

#include "renderer/shading/sky_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

// Smallest weight of a texel, relative to the mean, since the interpolation with its neighbours may
// make a black texel brighter.
constexpr double least_share = 0.01;

double brightness(glm::vec3 radiance) {
  return static_cast<double>(std::max({radiance.x, radiance.y, radiance.z}));
}

// Returns the brightness of a texel after interpolation with its neighbours: the mean of the
// centres of its four quarters.
double brightness_in(const SkyRows& rows, std::size_t row, std::size_t column,
                     std::size_t columns) {
  double sum = 0.0;
  for (const double down : {0.25, 0.75}) {
    for (const double right : {0.25, 0.75}) {
      const double u = (static_cast<double>(column) + right) / static_cast<double>(columns);
      const double v = (static_cast<double>(row) + down) / static_cast<double>(rows.rows());
      sum += brightness(rows.at(u, v));
    }
  }
  return 0.25 * sum;
}

}  // namespace

SkyDistribution::SkyDistribution(const SkyRows& rows) {
  const auto count = static_cast<std::size_t>(rows.rows());
  start_.assign(rows.start.begin(), rows.start.end());
  std::vector<double> bright;
  double power = 0.0;
  for (std::size_t r = 0; r < count; ++r) {
    const double height =
        std::cos(std::numbers::pi * static_cast<double>(r) / static_cast<double>(count)) -
        std::cos(std::numbers::pi * static_cast<double>(r + 1) / static_cast<double>(count));
    const std::size_t columns = start_[r + 1] - start_[r];
    solid_angle_.push_back(2.0 * std::numbers::pi * height / static_cast<double>(columns));
    for (std::size_t i = 0; i < columns; ++i) {
      bright.push_back(brightness_in(rows, r, i, columns));
      power += solid_angle_[r] * bright.back();
    }
  }
  const double least = power > 0.0 ? least_share * power / (4.0 * std::numbers::pi) : 1.0;
  double sum = 0.0;
  for (std::size_t r = 0; r < count; ++r)
    for (std::size_t i = start_[r]; i < start_[r + 1]; ++i)
      cumulative_.push_back(sum += solid_angle_[r] * (bright[i] + least));
  for (double& share : cumulative_) share /= sum;
  cumulative_.back() = 1.0;
}

double SkyDistribution::density_of(std::size_t texel, std::size_t row) const {
  const double before = texel > 0 ? cumulative_[texel - 1] : 0.0;
  return (cumulative_[texel] - before) / solid_angle_[row];
}

SkyDirection SkyDistribution::at(glm::dvec2 place) const {
  const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, place.x);
  const auto texel = static_cast<std::size_t>(found - cumulative_.begin());
  const auto row = static_cast<std::size_t>(
                       std::upper_bound(start_.begin(), start_.end() - 1, texel) - start_.begin()) -
                   1;
  const double before = texel > 0 ? cumulative_[texel - 1] : 0.0;
  const double share = cumulative_[texel] - before;
  const double along = share > 0.0 ? std::clamp((place.x - before) / share, 0.0, 1.0) : 0.5;
  // Distribute evenly over the solid angle: evenly in azimuth and in height.
  const auto rows = static_cast<double>(solid_angle_.size());
  const double top = std::cos(std::numbers::pi * static_cast<double>(row) / rows);
  const double bottom = std::cos(std::numbers::pi * static_cast<double>(row + 1) / rows);
  const double y = glm::mix(top, bottom, place.y);
  const double columns = static_cast<double>(start_[row + 1] - start_[row]);
  const double turns = (static_cast<double>(texel - start_[row]) + along) / columns;
  const double angle = 2.0 * std::numbers::pi * (turns - 0.5);
  const double across = std::sqrt(std::max(0.0, 1.0 - y * y));
  return {{across * std::sin(angle), y, -across * std::cos(angle)}, density_of(texel, row)};
}

double SkyDistribution::density(glm::dvec3 direction) const {
  const SkyPlace place = sky_place(direction);
  const std::size_t count = solid_angle_.size();
  const auto row = std::min(
      static_cast<std::size_t>(std::max(0.0, place.v) * static_cast<double>(count)), count - 1);
  const std::size_t columns = start_[row + 1] - start_[row];
  const double turns = place.u - std::floor(place.u);
  const auto column =
      std::min(static_cast<std::size_t>(turns * static_cast<double>(columns)), columns - 1);
  return density_of(start_[row] + column, row);
}

}  // namespace asos
