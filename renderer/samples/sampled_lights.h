#pragma once

#include "renderer/kernels/light_kernel.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/samples/recycled.h"
#include "renderer/shading/light_transport.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace asos {

/// A sample by its place in a picture's sequence.
struct SampleIndex {
  int x = 0;  ///< of its pixel
  int y = 0;
  int index = 0;

  [[nodiscard]] bool same_pixel(const SampleIndex& other) const {
    return x == other.x && y == other.y;
  }
};

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

  /// Goes to a batch of samples, at most LitBatch::size of them, which have to outlive what is
  /// asked about them. The sample under way is another one then.
  virtual void start_batch(std::span<const SampleIndex> samples) = 0;
  /// Of each sample of the batch: `on_light` as 32-bit fractions.
  virtual void on_light(std::uint32_t light, LightPlaceBatch& places) = 0;
};

/// The weight of a sample in one of the sums that its method keeps.
struct SampleShare {
  std::size_t target = 0;  ///< index of the sum
  glm::vec3 weight{1.0f};
};

/// How sampling methods find what reaches a point of a light: a shadow ray to one point of it a
/// sample. Points are gathered, and shaded light by light in batches; rays go in packets.
class SampledLights {
 public:
  /// Both have to outlive this.
  SampledLights(const RayScene& rays, LightPlaces& places) : rays_(&rays), places_(&places) {}

  /// Points and the samples whose lights they gather.
  struct Gathered {
    LitBatch points;
    std::array<SampleIndex, LitBatch::size> samples;
    std::array<std::size_t, LitBatch::size> targets;
  };
  /// Room for the first points of all, to be written as arrays; no point waits. They wait from
  /// `gathered` on, with the lights of the picture.
  [[nodiscard]] Gathered& first_points();
  void gathered(std::size_t points, std::span<const PreparedLight> lights, bool shadows);

  /// All lights of a point, for a sample of that share.
  void gather(const LitPoint& point, const SampleIndex& sample, const SampleShare& share);
  /// One light, by a shadow ray of a sample of that share, which the places are at.
  void add(const Illumination& lit, const SampleShare& share, RenderStatistics& counts);

  /// How much waits; `forget_since` drops what has come since.
  struct Waiting {
    std::size_t points = 0;
    std::size_t rays = 0;
  };
  [[nodiscard]] Waiting waiting() const { return {points_, pending_.size()}; }
  void forget_since(const Waiting& then);

  /// Shades and traces what waits and adds what arrives. The places are at other samples then.
  void trace(std::vector<glm::dvec3>& sums, RenderStatistics& counts);
  /// The same where all that waits came by `add`, which has counted it.
  void trace(std::vector<glm::dvec3>& sums);

 private:
  struct Pending {
    Ray ray;
    glm::vec3 carried{0.0f};
    std::size_t target = 0;
    std::int32_t ignored_part = -1;
  };

  void prepare(std::span<const PreparedLight> lights, bool shadows);
  void trace(const Gathered& batch, std::vector<glm::dvec3>& sums, RenderStatistics& counts);
  void trace_shadows(std::int32_t own_part);
  void trace_pending(std::vector<glm::dvec3>& sums);

  const RayScene* rays_;
  LightPlaces* places_;
  std::vector<LightConstants> lights_;  // of all points gathered
  bool shadows_ = true;                 // the same of all points
  std::size_t points_ = 0;
  std::vector<Recycled<Gathered>> batches_;  // all full but the last of `points_`
  LightPlaceBatch on_light_;
  ShadowRayBatch shadow_rays_;
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
