#pragma once

#include "renderer/film/statistics.h"
#include "renderer/shading/light_transport.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace asos {

/// While it lives, all shadow rays and pyrays that are counted are those of one light.
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

/// Passes lights on to another transport and tells what it cost by light, and whether the edge of a
/// hard shadow was met: whether a light without a size took more than one ray and was seen in part.
class CountedLights final : public LightTransport {
 public:
  explicit CountedLights(LightTransport& inner) : inner_(inner) {}

  void add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) override;

  /// Since `forget`.
  [[nodiscard]] bool met_shadow_edge() const { return met_shadow_edge_; }
  void forget() { met_shadow_edge_ = false; }

 private:
  LightTransport& inner_;
  bool met_shadow_edge_ = false;
};

}  // namespace asos
