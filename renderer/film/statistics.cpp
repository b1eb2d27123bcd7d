#include "renderer/film/statistics.h"

#include <algorithm>
#include <cstddef>

namespace asos {

void RenderStatistics::count_shadow_ray(std::uint32_t light, std::uint64_t rays) {
  if (light >= lights.size()) lights.resize(light + std::size_t{1});
  lights[light].shadow_rays += rays;
  shadow_rays += rays;
}

void RenderStatistics::count_shadow_pyray(std::uint32_t light, std::uint64_t pyrays) {
  if (light >= lights.size()) lights.resize(light + std::size_t{1});
  lights[light].shadow_pyrays += pyrays;
  shadow_pyrays += pyrays;
}

RenderStatistics& RenderStatistics::operator+=(const RenderStatistics& other) {
  eye_rays += other.eye_rays;
  shadow_rays += other.shadow_rays;
  shadow_pyrays += other.shadow_pyrays;
  lights.resize(std::max(lights.size(), other.lights.size()));
  for (std::size_t i = 0; i < other.lights.size(); ++i) {
    lights[i].shadow_rays += other.lights[i].shadow_rays;
    lights[i].shadow_pyrays += other.lights[i].shadow_pyrays;
  }
  reflection_rays += other.reflection_rays;
  sky_rays += other.sky_rays;
  for (std::size_t i = 0; i < pyrays_by_level.size(); ++i) {
    pyrays_by_level[i] += other.pyrays_by_level[i];
  }
  split_pixels += other.split_pixels;
  missed_splits += other.missed_splits;
  uneven_pixels += other.uneven_pixels;
  saturated_pixels += other.saturated_pixels;
  unresolved_area += other.unresolved_area;
  rejected_samples += other.rejected_samples;
  cut_stacks += other.cut_stacks;
  for (std::size_t i = 0; i < samples_by_path.size(); ++i) {
    samples_by_path[i] += other.samples_by_path[i];
  }
  for (std::size_t i = 0; i < pixels_by_cause.size(); ++i) {
    pixels_by_cause[i] += other.pixels_by_cause[i];
  }
  return *this;
}

}  // namespace asos
