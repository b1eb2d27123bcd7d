#pragma once

#include "renderer/kernels/light_kernel.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/samples/light_picks.h"
#include "renderer/samples/light_places.h"
#include "renderer/samples/recycled.h"
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

/// The weight of a sample in one of the sums that its method keeps.
struct SampleShare {
  std::size_t target = 0;  ///< index of the sum
  glm::vec3 weight{1.0f};
};

/// A ray that looks for the sky, or for what lies in its way.
struct SkyRay {
  Ray ray;
  glm::vec3 weight{1.0f};  ///< of the radiance along it in that of its sample
  SampleIndex sample;
  std::size_t target = 0;  ///< index of the sample's sum
};

/// How sampling methods find what reaches a point of a light: a shadow ray to one point of it a
/// sample, or to some of them where there are many (LightPicks); and on glossy surfaces one along
/// the lobe where that meets a light, each of the two with its share of the highlight. Points are
/// gathered, and shaded light by light in batches; rays go in packets.
class SampledLights {
 public:
  /// Both have to outlive this.
  SampledLights(const RayScene& rays, LightPlaces& places) : rays_(&rays), places_(&places) {}

  /// Of all lights, these alone are gathered: one a light, 0 for those that are not; and where they
  /// are many, a point sends so many rays on the average. Called before the first point is.
  void restrict_to(std::span<const std::uint8_t> lights, float rays_a_point) {
    allowed_ = lights;
    rays_a_point_ = rays_a_point;
  }

  /// Points and the samples whose lights they gather.
  struct Gathered {
    LitBatch points;
    std::array<SampleIndex, LitBatch::size> samples;
    std::array<std::size_t, LitBatch::size> targets;
    LightPlaceBatch::Fractions picks;  ///< each one's pick_place, where lights are picked
  };
  /// What there is to know of the lights, the same for all points of a picture: known already once
  /// a point was gathered.
  void prepare(std::span<const PreparedLight> lights, bool shadows);
  /// Room for the first points of all, to be written as arrays; no point waits. They wait from
  /// `gathered` on.
  [[nodiscard]] Gathered& first_points();
  void gathered(std::size_t points);
  /// Whether there are so many lights that points send rays to some of them only.
  [[nodiscard]] bool picks_lights() const { return lights_with_rays_ > LightPicks::few_lights; }
  /// The number by which the sample under way picks its lights, of 2^32.
  [[nodiscard]] std::uint32_t pick_place() const;

  /// Whether `gather` takes all of these lights.
  [[nodiscard]] static bool takes_all(std::span<const PreparedLight> lights, bool shadows);
  /// The lights of a point, for a sample of that share: all that cast shadows where there are any,
  /// and of the others those with a size.
  TakenLights gather(const LitPoint& point, const SampleIndex& sample, const SampleShare& share);
  /// One light, by a shadow ray of a sample of that share, which the places are at.
  void add(const Illumination& lit, const SampleShare& share, RenderStatistics& counts);

  /// The sky, by a ray of a sample of that share in one direction (sample_sky), that of the sample
  /// under way in this lobe: what lies there hides it.
  void add_sky(const SkyLitPoint& point, const SampleShare& share, RenderStatistics& counts,
               int lobe = lobe_of_sky);
  /// The same ray, but it waits for who looks what lies there.
  void add_sky_ray(const SkyLitPoint& point, const SampleIndex& sample, const SampleShare& share,
                   RenderStatistics& counts);
  [[nodiscard]] std::vector<SkyRay> take_sky_rays() { return std::exchange(sky_rays_, {}); }

  /// How much waits; `forget_since` drops what has come since.
  struct Waiting {
    std::size_t points = 0;
    std::size_t rays = 0;
    std::size_t sky_rays = 0;
  };
  [[nodiscard]] Waiting waiting() const { return {points_, pending_.size(), sky_rays_.size()}; }
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

  void trace(const Gathered& batch, std::vector<glm::dvec3>& sums, RenderStatistics& counts);
  void trace_each(const Gathered& batch, std::vector<glm::dvec3>& sums, RenderStatistics& counts);
  void trace_picked(const Gathered& batch, std::vector<glm::dvec3>& sums, RenderStatistics& counts);
  [[nodiscard]] bool sends_rays(std::uint32_t light) const {
    return shadows_ && lights_[light].light->casts_shadows;
  }
  void shade(const Gathered& batch, std::uint32_t light, ShadowRayBatch& rays);
  void trace_lobes(const Gathered& batch, std::vector<glm::dvec3>& sums, RenderStatistics& counts);
  void trace(const Gathered& batch, std::uint32_t light, const ShadowRayBatch& rays,
             std::vector<glm::dvec3>& sums, RenderStatistics& counts);
  void trace_shadows(const ShadowRayBatch& rays, std::int32_t own_part);
  void trace_pending(std::vector<glm::dvec3>& sums);

  const RayScene* rays_;
  LightPlaces* places_;
  std::span<const std::uint8_t> allowed_;  // empty: all
  std::vector<LightConstants> lights_;     // of all points gathered
  float rays_a_point_ = LightPicks::rays_a_point;
  std::vector<std::uint8_t> taken_;
  std::vector<std::uint8_t> shadowed_;  // of these, those that rays are sent to
  bool all_taken_ = true;
  bool shadows_ = true;  // the same of all points
  std::size_t lights_with_rays_ = 0;
  std::size_t points_ = 0;
  std::vector<Recycled<Gathered>> batches_;  // all full but the last of `points_`
  LightPlaceBatch on_light_;
  LobeBatch lobe_;
  WideLights wide_;
  LightTable many_;  // those that rays are sent to, if they are picked
  /// What only tracing needs.
  struct Work {
    ShadowRayBatch rays;
    LightPicks picks;
    LitBatch picked;
    LightPlaceBatch places;
  };
  Recycled<Work> work_;  // while rays are traced
  std::vector<Pending> pending_;
  std::vector<SkyRay> sky_rays_;
  std::vector<Ray> batch_;
  std::vector<glm::vec3> shares_;
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
