#pragma once

#include "renderer/rays/ray_scene.h"
#include "renderer/shading/light_transport.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// Where on a light each sample of a pixel looks.
class LightPlaces {
 public:
  virtual ~LightPlaces() = default;
  /// In the unit square, of the sample that is under way.
  [[nodiscard]] virtual glm::dvec2 on_light(std::uint32_t light) const = 0;
  /// Where in a blurred reflection's square it looks at the given bounce, from 0: independent of
  /// where it looks on lights.
  [[nodiscard]] virtual glm::dvec2 in_lobe(int bounce) const {
    return on_light(0x4000u + static_cast<std::uint32_t>(bounce));
  }
};

/// How sampling methods find what reaches a point of a light: a shadow ray to one point of it a
/// sample. The rays are gathered and go in packets, so that what they carry is added later.
class SampledLights final : public LightTransport {
 public:
  SampledLights(const RayScene& rays, const LightPlaces& places) : rays_(rays), places_(places) {}

  /// To which of the sums the light of the coming points belongs, and for how much it counts.
  void set_target(std::size_t sum, glm::vec3 weight = glm::vec3(1.0f)) {
    target_ = sum;
    weight_ = weight;
  }

  void add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) override;

  /// How many rays wait; `forget_since` drops those from the given number on.
  [[nodiscard]] std::size_t waiting() const { return pending_.size(); }
  void forget_since(std::size_t count) { pending_.resize(count); }

  /// Traces what waits and adds what arrives.
  void trace(std::vector<glm::dvec3>& sums);

 private:
  struct Pending {
    Ray ray;
    glm::vec3 carried{0.0f};
    std::size_t target = 0;
    std::int32_t ignored_part = -1;
  };

  const RayScene& rays_;
  const LightPlaces& places_;
  std::size_t target_ = 0;
  glm::vec3 weight_{1.0f};
  std::vector<Pending> pending_;
  std::vector<Ray> batch_;
  std::vector<float> shares_;
};

}  // namespace asos
