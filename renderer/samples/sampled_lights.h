#pragma once

#include "renderer/kernels/light_kernel.h"
#include "renderer/kernels/light_selection.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/samples/light_sample_points.h"
#include "renderer/samples/radiance_sums.h"
#include "renderer/samples/thread_local_cache.h"
#include "renderer/samples/wide_lights.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shading/sky_light.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace asos {

/// The sum to which a sample is added, and the sample's weight in it.
struct SampleWeight {
  SumTarget target;
  glm::vec3 weight{1.0f};
};

/// A ray to the sky or to its occluder.
struct SkyRay {
  Ray ray;
  glm::vec3 weight{1.0f};  ///< weight of the ray's radiance in its sample
  SampleIndex sample;
  SumTarget target;  ///< the sample's
};

/// Visibility of lights for sampling methods. Each sample sends a shadow ray to one point of each
/// light, or of some of many lights (LightSelection). On glossy surfaces a second ray follows the
/// lobe if it hits a light; both share the highlight by multiple importance sampling. Points are
/// collected and shaded light by light in batches; rays are traced in packets.
class SampledLights {
 public:
  /// Both arguments have to outlive this.
  SampledLights(const RayScene& rays, LightSamplePoints& places) : rays_(&rays), places_(&places) {}

  /// Restricts the lights to those with a non-zero entry; others are ignored. Must be called before
  /// the first point is added.
  void restrict_to(std::span<const std::uint8_t> lights) { allowed_ = lights; }

  /// Points, with the samples to which they belong.
  struct Gathered {
    ShadingPoints points;
    std::array<SampleIndex, ShadingPoints::size> samples;
    std::array<SumTarget, ShadingPoints::size> targets;
    LightPointBatch::Fractions picks;  ///< pick_place of each point, if lights are selected
  };
  /// Prepares the lights' data, which is the same for all points of a picture. Has no effect after
  /// the first point.
  void prepare(std::span<const PreparedLight> lights, bool shadows);
  /// Returns room for the first points, to be filled as arrays; none may be waiting. `gathered`
  /// makes them wait.
  [[nodiscard]] Gathered& first_points();
  void gathered(std::size_t points);
  /// Returns whether there are so many lights that points select some of them.
  [[nodiscard]] bool picks_lights() const { return lights_with_rays_ > LightSelection::few_lights; }
  /// Returns the current sample's random number for selecting lights, a 32-bit fraction.
  [[nodiscard]] std::uint32_t pick_place() const;

  /// Returns whether `gather` handles all of these lights.
  [[nodiscard]] static bool takes_all(std::span<const PreparedLight> lights, bool shadows);
  /// Defers the lights of a point for a sample with this share: all but those without shadows whose
  /// extent has a closed form by the published rule.
  HandledLights gather(const LightingQuery& point, const SampleIndex& sample,
                       const SampleWeight& share);
  /// Adds one light by a shadow ray, for a sample with this share; the places must be at that
  /// sample.
  void add(const Illumination& lit, const SampleWeight& share, RenderStatistics& counts);

  /// From now on the noise of an open sky is subtracted (open_sky_less). Single samples may then be
  /// negative.
  void subtract_open_sky() { subtracts_open_sky_ = true; }
  /// Adds the sky by one ray (sample_sky), for a sample with this share. The direction is the
  /// current sample's in this stream. An occluder blocks the sky, or, for a sample `continued`, is
  /// evaluated by the caller (take_sky_rays). Returns what to add to the point's radiance, without
  /// the sample's weight.
  glm::vec3 add_sky(const SkyQuery& point, const SampleWeight& share, RenderStatistics& counts,
                    SampleStream stream = SampleStream::sky,
                    const SampleIndex* continued = nullptr);
  [[nodiscard]] std::vector<SkyRay> take_sky_rays() { return std::exchange(sky_rays_, {}); }

  /// The number of waiting items; `forget_since` drops all later ones.
  struct Waiting {
    std::size_t points = 0;
    std::size_t rays = 0;
    std::size_t sky_rays = 0;
  };
  [[nodiscard]] Waiting waiting() const { return {points_, pending_.size(), sky_rays_.size()}; }
  void forget_since(const Waiting& then);

  /// Shades and traces all waiting items and adds the results. Changes the current sample of the
  /// places.
  void trace(RadianceSums sums, RenderStatistics& counts);
  /// As above, if all waiting items came by `add`, which has counted them.
  void trace(RadianceSums sums);

 private:
  struct Pending {
    Ray ray;
    glm::vec3 carried{0.0f};
    SumTarget target;
    std::int32_t ignored_part = -1;
  };

  void trace(const Gathered& batch, RadianceSums sums, RenderStatistics& counts);
  void trace_each(const Gathered& batch, RadianceSums sums, RenderStatistics& counts);
  void trace_picked(const Gathered& batch, RadianceSums sums, RenderStatistics& counts);
  [[nodiscard]] bool sends_rays(std::uint32_t light) const {
    return shadows_ && lights_[light].light->casts_shadows;
  }
  void shade(const Gathered& batch, std::uint32_t light, ShadowRayBatch& rays);
  void trace_lobes(const Gathered& batch, RadianceSums sums, RenderStatistics& counts);
  void trace(const Gathered& batch, std::uint32_t light, const ShadowRayBatch& rays,
             RadianceSums sums, RenderStatistics& counts);
  void trace_shadows(const ShadowRayBatch& rays, std::int32_t own_part);
  void trace_pending(RadianceSums sums);

  const RayScene* rays_;
  LightSamplePoints* places_;
  std::span<const std::uint8_t> allowed_;  // empty: all
  std::vector<LightConstants> lights_;     // for all points
  std::vector<std::uint8_t> taken_;
  std::vector<std::uint8_t> shadowed_;  // which of them send shadow rays
  bool all_taken_ = true;
  bool shadows_ = true;  // the same for all points
  bool subtracts_open_sky_ = false;
  std::size_t lights_with_rays_ = 0;
  std::size_t points_ = 0;
  std::vector<CachedPtr<Gathered>> batches_;  // all full, except the one with the last point
  LightPointBatch on_light_;
  LobeBatch lobe_;
  WideLights wide_;
  // Lights with shadow rays and their numbers, if they are selected.
  std::vector<LightBounds> many_;
  std::vector<std::uint32_t> many_numbers_;
  /// Scratch memory for tracing.
  struct Work {
    ShadowRayBatch rays;
    LightSelection picks;
    ShadingPoints picked;
    LightPointBatch places;
    std::vector<LightArcs> arcs;  // of each light at the batch's points; one for many lights
  };
  [[nodiscard]] LightArcs& arcs(std::uint32_t light);
  CachedPtr<Work> work_;  // while rays are traced
  std::vector<Pending> pending_;
  std::vector<SkyRay> sky_rays_;
  std::vector<Ray> batch_;
  std::vector<glm::vec3> shares_;
};

/// Collects the lights of one sample without following reflections. One object per sample.
class SampleLights final : public LightTransport {
 public:
  SampleLights(SampledLights& lights, const SampleWeight& share) : lights_(lights), share_(share) {}

  void add(const Illumination& lit, glm::vec3& /*radiance*/, RenderStatistics& counts) override {
    lights_.add(lit, share_, counts);
  }

 private:
  SampledLights& lights_;
  SampleWeight share_;
};

}  // namespace asos
