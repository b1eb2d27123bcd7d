#pragma once

#include "renderer/film/sample_path.h"
#include "renderer/film/split_cause.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// The work to find the visible part of one light.
struct LightStatistics {
  std::uint64_t shadow_rays = 0;
  std::uint64_t shadow_pyrays = 0;  ///< that were subdivided

  bool operator==(const LightStatistics&) const = default;
};

/// The work and events of a rendering, summed over tiles. All sums are independent of the order,
/// except for `unresolved_area`, which RenderSession sums in tile order.
struct RenderStatistics {
  std::uint64_t eye_rays = 0;
  std::uint64_t shadow_rays = 0;
  std::uint64_t shadow_pyrays = 0;  ///< that were subdivided
  std::uint64_t reflection_rays = 0;
  std::uint64_t sky_rays = 0;                      ///< from surfaces, for the visibility of the sky
  std::array<std::uint64_t, 9> pyrays_by_level{};  ///< cells examined, by level 0..8
  /// Indexed like Lighting::lights; grows as needed, and lights beyond its end have no counts. Adds
  /// up to `shadow_rays` and `shadow_pyrays`.
  std::vector<LightStatistics> lights;
  std::uint64_t split_pixels = 0;   ///< pixels whose value is the sum of several parts
  std::uint64_t missed_splits = 0;  ///< pixels split by the safety net only (design section 3)
  /// Pixels with parts that were split for their shading alone.
  std::uint64_t uneven_pixels = 0;
  /// Pixels sampled at the finest level without subdivision (section 5).
  std::uint64_t saturated_pixels = 0;
  double unresolved_area = 0.0;        ///< in pixels: area of the leaves that stayed marginal
  std::uint64_t rejected_samples = 0;  ///< samples that were not finite, dropped
  std::uint64_t cut_stacks = 0;        ///< rays that stopped at the limit of surfaces per ray

  /// Number of rays of samples, from the eye or continued, by the way in which their ends were
  /// shaded.
  std::array<std::uint64_t, sample_path_count> samples_by_path{};

  /// ASOS: number of pixels by cause, without unsplit pixels.
  std::array<std::uint64_t, split_cause_count> pixels_by_cause{};

  /// Returns the number of rays of all kinds.
  [[nodiscard]] std::uint64_t rays() const {
    return eye_rays + shadow_rays + reflection_rays + sky_rays;
  }
  void count_sample(SamplePath path, std::uint64_t rays = 1) {
    samples_by_path[static_cast<std::size_t>(path)] += rays;
  }
  /// Counts shadow rays to a light, in the total and for that light.
  void count_shadow_ray(std::uint32_t light, std::uint64_t rays = 1);
  /// Counts subdivided pyrays to a light in the same way. Their rays are counted separately.
  void count_shadow_pyray(std::uint32_t light, std::uint64_t pyrays = 1);
  /// Returns the statistics of one light; all zero if there are none.
  [[nodiscard]] LightStatistics of_light(std::size_t light) const {
    return light < lights.size() ? lights[light] : LightStatistics{};
  }

  RenderStatistics& operator+=(const RenderStatistics& other);
};

}  // namespace asos
