#include "renderer/film/statistics.h"

#include <cstddef>

namespace asos {

RenderStatistics& RenderStatistics::operator+=(const RenderStatistics& other) {
  eye_rays += other.eye_rays;
  shadow_rays += other.shadow_rays;
  reflection_rays += other.reflection_rays;
  for (std::size_t i = 0; i < pyrays_by_level.size(); ++i) {
    pyrays_by_level[i] += other.pyrays_by_level[i];
  }
  split_pixels += other.split_pixels;
  missed_splits += other.missed_splits;
  uneven_pixels += other.uneven_pixels;
  saturated_pixels += other.saturated_pixels;
  unresolved_area += other.unresolved_area;
  rejected_samples += other.rejected_samples;
  return *this;
}

}  // namespace asos
