#pragma once

#include "renderer/film/statistics.h"

#include <cstdint>

namespace asos {

/// While it lives, all shadow rays and pyrays count for one light.
class CountForLight {
 public:
  CountForLight(RenderStatistics& counts, std::uint32_t light);
  ~CountForLight();
  CountForLight(const CountForLight&) = delete;
  CountForLight& operator=(const CountForLight&) = delete;

  /// So far.
  [[nodiscard]] std::uint64_t rays() const { return counts_.shadow_rays - rays_before_; }

 private:
  RenderStatistics& counts_;
  std::uint32_t light_;
  std::uint64_t rays_before_;
  std::uint64_t pyrays_before_;
  LightStatistics light_before_;
};

}  // namespace asos
