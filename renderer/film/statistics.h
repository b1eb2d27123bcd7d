#pragma once

#include "renderer/film/split_cause.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// The work done to find out how much of one light is seen.
struct LightStatistics {
  std::uint64_t shadow_rays = 0;
  std::uint64_t shadow_pyrays = 0;  ///< that were subdivided

  bool operator==(const LightStatistics&) const = default;
};

/// Work done and what it met, summed over tiles. Integers and sums that do not depend on order but
/// for `unresolved_area`, which is summed in tile order by RenderSession.
struct RenderStatistics {
  std::uint64_t eye_rays = 0;
  std::uint64_t shadow_rays = 0;
  std::uint64_t shadow_pyrays = 0;  ///< that were subdivided
  std::uint64_t reflection_rays = 0;
  std::uint64_t sky_rays = 0;  ///< from surfaces, to find out whether they see it
  std::array<std::uint64_t, 9> pyrays_by_level{};  ///< cells examined, by level 0..8
  /// By Lighting::lights; lights beyond its end, which grows as needed, were asked for nothing.
  /// Adds up to `shadow_rays` and `shadow_pyrays`.
  std::vector<LightStatistics> lights;
  std::uint64_t split_pixels = 0;      ///< pixels whose value is the sum of several parts
  std::uint64_t missed_splits = 0;     ///< pixels split by the safety net only (design section 3)
  std::uint64_t uneven_pixels = 0;     ///< pixels of which parts were split for their shading alone
  std::uint64_t saturated_pixels = 0;  ///< pixels sampled at the finest level at once (section 5)
  double unresolved_area = 0.0;        ///< in pixels: area of the leaves that stayed marginal
  std::uint64_t rejected_samples = 0;  ///< samples that were not finite, dropped
  std::uint64_t cut_stacks = 0;        ///< rays through so many surfaces that the rest was dropped

  /// ASOS: pixels by their cause; those with none are not counted.
  std::array<std::uint64_t, split_cause_count> pixels_by_cause{};

  /// Rays of all kinds.
  [[nodiscard]] std::uint64_t rays() const {
    return eye_rays + shadow_rays + reflection_rays + sky_rays;
  }
  /// Counts shadow rays to a light, here and with that light.
  void count_shadow_ray(std::uint32_t light, std::uint64_t rays = 1);
  /// The same for pyrays that were subdivided; their rays are counted separately.
  void count_shadow_pyray(std::uint32_t light, std::uint64_t pyrays = 1);
  /// The statistics of one light, all zero where it was asked for nothing.
  [[nodiscard]] LightStatistics of_light(std::size_t light) const {
    return light < lights.size() ? lights[light] : LightStatistics{};
  }

  RenderStatistics& operator+=(const RenderStatistics& other);
};

}  // namespace asos
