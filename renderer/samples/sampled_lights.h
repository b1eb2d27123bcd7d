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

/// The weight of a sample in one of the sums that its method keeps.
struct SampleShare {
  std::size_t target = 0;  ///< index of the sum
  glm::vec3 weight{1.0f};
};

/// How sampling methods find what reaches a point of a light: a shadow ray to one point of it a
/// sample. The rays are gathered and go in packets, so that what they carry is added later.
class SampledLights {
 public:
  /// Both have to outlive this.
  SampledLights(const RayScene& rays, const LightPlaces& places) : rays_(&rays), places_(&places) {}

  /// The shadow ray of a sample of that share, which the places are at.
  void add(const Illumination& lit, const SampleShare& share, RenderStatistics& counts);

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

  const RayScene* rays_;
  const LightPlaces* places_;
  std::vector<Pending> pending_;
  std::vector<Ray> batch_;
  std::vector<float> shares_;
};

/// The lights of one sample, whose reflections are not followed. Made for each sample.
class SampleLights final : public LightTransport {
 public:
  SampleLights(SampledLights& lights, const SampleShare& share) : lights_(lights), share_(share) {}

  void add(const Illumination& lit, glm::vec3& /*radiance*/, RenderStatistics& counts) override {
    lights_.add(lit, share_, counts);
  }

 private:
  SampledLights& lights_;
  SampleShare share_;
};

}  // namespace asos
