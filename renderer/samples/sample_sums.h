#pragma once

#include "renderer/prepared/view_context.h"
#include "renderer/samples/block_job.h"
#include "renderer/samples/bounced_light.h"
#include "renderer/samples/layer_probe.h"
#include "renderer/samples/sample_block.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/samples/sampled_reflections.h"
#include "renderer/samples/simd_samples.h"
#include "renderer/shading/shade.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// Traces and shades point samples in batches, with packets of rays, and adds them to their sums.
/// Samples that are not finite are counted and not added. The bits of a sum depend only on the
/// samples added before. With a moving picture each sample sees the scene at its own time.
class SampleSums {
 public:
  struct Sum {
    glm::dvec3 radiance{0.0};  ///< linear, sum over the samples
    std::uint32_t count = 0;

    [[nodiscard]] glm::dvec3 mean() const {
      return count > 0 ? radiance / static_cast<double>(count) : glm::dvec3(0.0);
    }
  };

  /// Samples the job's scene and view, at one moment or while the shutter is open. `job` and
  /// `places` have to outlive this.
  SampleSums(const BlockJob& job, PixelSampler& places);
  /// `scene`, `view` and `places` have to outlive this.
  SampleSums(const RenderScene& scene, const View& view, const RenderSettings& settings,
             PixelSampler& places);
  /// For any viewer of the scene; `viewer` has to outlive this.
  SampleSums(const RenderScene& scene, const ViewContext& viewer, const RenderSettings& settings,
             PixelSampler& places, SummedRadiance shows = SummedRadiance::all);
  SampleSums(const SampleSums&) = delete;
  SampleSums& operator=(const SampleSums&) = delete;
  ~SampleSums();

  /// Averages the colours of all later samples over squares that are this many times as wide as the
  /// samples' sides.
  void widen_colours(float times);

  /// See SampledLights.
  void subtract_open_sky() { lights_.subtract_open_sky(); }
  void restrict_to(std::span<const std::uint8_t> lights) { lights_.restrict_to(lights); }

  /// From now on samples are added to the sums of the layers that the settings ask for, too. The
  /// targets may change between samples. Both have to outlive the samples.
  void note_layers(const RenderSettings& settings, const LayerTargets& targets);

  /// Makes room for sums 0 to `count` - 1; new ones are empty. Sums beyond that are dropped, and
  /// none of their samples may be waiting for `trace`.
  void resize(std::size_t count);
  [[nodiscard]] std::size_t size() const { return radiance_.size(); }

  /// Adds a sample. Returns true if this filled a batch and traced it, which changes the current
  /// sample of the places.
  bool add(const PointSample& sample) {
    if (moving_) return add_moving(sample);
    // Copy member by member: a copy of the whole would stall on the narrower stores just before it.
    PointSample& place = samples_[used_];
    points_[used_].x = place.at.x = sample.at.x;
    points_[used_].y = place.at.y = sample.at.y;
    place.side = sample.side;
    place.x = sample.x;
    place.y = sample.y;
    place.index = sample.index;
    place.target = sample.target;
    if (++used_ < batch) return false;
    trace();
    return true;
  }
  /// Adds a sample whose ray was already cast, so that only its shading is left. Samples of both
  /// kinds must not wait together.
  bool add_hit(const PointSample& sample, const Ray& ray, const Hit& hit) {
    samples_[used_] = sample;
    rays_[used_] = ray;
    hits_[used_] = hit;
    hits_known_ = true;
    if (++used_ < batch) return false;
    trace();
    return true;
  }
  /// Traces the waiting samples. Sums are complete only after it.
  void trace();

  [[nodiscard]] Sum sum(std::size_t target) const { return {radiance_[target], count_[target]}; }
  /// Sets a sum to a known value, to continue from it.
  void continue_from(std::size_t target, const Sum& sum) {
    radiance_[target] = sum.radiance;
    count_[target] = sum.count;
  }
  /// Adds up `count` sums (an even number) from `first` on in pairs. The first half then has the
  /// results, and the rest is empty. None of their samples may be waiting for `trace`.
  void add_pairs(std::size_t first, std::size_t count);
  /// Returns the first hit of the ray of a sum's latest sample.
  [[nodiscard]] const Hit& hit(std::size_t target) const { return hit_[target]; }
  [[nodiscard]] RenderStatistics& statistics() { return statistics_; }

  /// Returns a block whose pixels are the means of the first sums, row by row, with all statistics.
  [[nodiscard]] BlockResult block(PixelRect rect) const;

 private:
  static constexpr std::size_t batch = 256;

  [[nodiscard]] ViewedRay seen_by(std::size_t i, float side) const {
    ViewedRay seen = viewer_.viewed(rays_[i], hits_[i], side);
    seen.colours = colours_;
    return seen;
  }
  /// Sums and counts of all moments together.
  struct Totals {
    std::vector<glm::dvec3> radiance;
    std::vector<std::uint32_t> count;
    std::vector<Hit> hit;
    RenderStatistics statistics;
  };
  struct EyeRays;
  struct ContinuedRays;
  /// The samples of each moment; their sums are those of the whole.
  struct Moving;

  SampleSums(const RenderScene& scene, const View& view, const RenderSettings& settings,
             PixelSampler& places, Totals* totals);
  bool add_moving(const PointSample& sample);
  void cast_rays();
  /// Computes the waiting samples' rays in a view.
  void aim(const View& view, std::span<Ray> rays);
  void cast_in_motion();
  void widen_footprints();
  void add_layers();
  [[nodiscard]] RadianceSums sums() { return {radiance_, light_ ? layers_ : nullptr}; }
  void count(std::size_t target) {
    ++count_[target];
    sums().count(target);
  }
  void shade_batch();
  template <typename Rays>
  void shade_waiting_points(const Rays& rays);
  template <typename Rays>
  [[nodiscard]] bool shade_points(const Rays& rays);
  template <typename Rays>
  void pass_surfaces(const Rays& rays, const ShadingPoints& points);
  void start_sample(const PointSample& sample) {
    places_->start_pixel(sample.x, sample.y);
    places_->start_sample(sample.index);
  }
  void shade_alone_instead();
  /// Returns whether only a part of the first surfaces' radiance is summed.
  [[nodiscard]] bool sums_part() const {
    return shows_ == SummedRadiance::direct || shows_ == SummedRadiance::lobes;
  }
  [[nodiscard]] bool shadows_sky() const { return viewer_.shader.settings().sky_shadows; }
  [[nodiscard]] bool shade(const PointSample& sample, glm::vec3 weight, const ViewedRay& seen,
                           SummedRadiance shows = SummedRadiance::all);
  void follow_reflections();
  void cast_continued(std::span<const ReflectedSample> samples);
  void shade_reflections(std::span<const ReflectedSample> samples);

  std::optional<Shader> own_shader_;
  ViewContext viewer_;
  const RenderScene* scene_;
  PixelSampler* places_;
  SampledLights lights_;
  SampledReflections reflections_;
  BouncedLight bounced_;
  SimdSamples simd_;
  Culling faces_;
  SummedRadiance shows_ = SummedRadiance::all;
  const LayerTargets* layers_ = nullptr;  // null: no layer of surfaces is asked for
  const RenderSettings* layer_settings_ = nullptr;
  std::optional<LayerProbe> probe_;  // made when first needed
  bool light_ = false;               // some of them are parts of the radiance
  float colours_ = 1.0f;
  Totals own_;
  std::vector<glm::dvec3>& radiance_;
  std::vector<std::uint32_t>& count_;
  std::vector<Hit>& hit_;
  RenderStatistics& statistics_;
  std::unique_ptr<Moving> moving_;  // null: one moment
  // For the samples of one moment among others. Null: their rays are cast at that moment.
  const MovingPicture* motion_ = nullptr;
  int moment_ = 0;
  std::array<float, batch> times_{};  // 0 to 1
  std::array<PointSample, batch> samples_{};
  std::array<glm::dvec2, batch> points_{};
  std::array<Ray, batch> rays_;
  std::array<Hit, batch> hits_;
  std::array<std::size_t, batch> alone_;  // indices of the samples that are shaded one by one
  std::size_t alone_count_ = 0;
  std::size_t used_ = 0;
  bool hits_known_ = false;  // whether the waiting samples have hits already
};

}  // namespace asos
