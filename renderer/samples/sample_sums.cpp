#include "renderer/samples/sample_sums.h"

#include "renderer/samples/one_sample.h"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace asos {

/// The samples whose eye rays wait.
struct SampleSums::EyeRays {
  static constexpr bool first = true;
  const SampleSums& of;

  [[nodiscard]] const PointSample& sample(std::size_t i) const { return of.samples_[i]; }
  [[nodiscard]] glm::vec3 weight(std::size_t /*i*/) const { return glm::vec3(1.0f); }
  [[nodiscard]] ViewedRay seen(std::size_t i) const { return of.seen_by(i, of.samples_[i].side); }
};

/// Samples whose rays were continued.
struct SampleSums::ContinuedRays {
  static constexpr bool first = false;
  const SampleSums& of;
  std::span<const ReflectedSample> samples;

  [[nodiscard]] const PointSample& sample(std::size_t i) const { return samples[i].sample; }
  [[nodiscard]] glm::vec3 weight(std::size_t i) const { return samples[i].weight; }
  [[nodiscard]] ViewedRay seen(std::size_t i) const { return samples[i].viewed(of.hits_[i]); }
};

/// One SampleSums per moment, made for the first sample at that moment.
struct SampleSums::Moving {
  const MovingPicture* picture;
  const RenderSettings* settings;
  std::vector<std::unique_ptr<SampleSums>> at;
};

SampleSums::~SampleSums() = default;

SampleSums::SampleSums(const BlockJob& job, PixelSampler& places)
    : SampleSums(job.scene, job.view, job.settings, places) {
  if (!job.motion) return;
  const auto moments = static_cast<std::size_t>(job.motion->steps()) + 1;
  moving_ = std::make_unique<Moving>();
  moving_->picture = job.motion;
  moving_->settings = &job.settings;
  moving_->at.resize(moments);
  places.use_time();
}

SampleSums::SampleSums(const RenderScene& scene, const View& view, const RenderSettings& settings,
                       PixelSampler& places)
    : SampleSums(scene, view, settings, places, nullptr) {}

SampleSums::SampleSums(const RenderScene& scene, const View& view, const RenderSettings& settings,
                       PixelSampler& places, Totals* totals)
    : own_shader_(shader_of(scene, settings, view)),
      viewer_(ViewContext::camera(view, *own_shader_)),
      scene_(&scene),
      places_(&places),
      lights_(scene.rays(), places),
      reflections_(scene.world(), places),
      bounced_(scene, viewer_.shader, places),
      simd_(scene, viewer_),
      faces_(culling_of(settings)),
      radiance_(totals ? totals->radiance : own_.radiance),
      count_(totals ? totals->count : own_.count),
      hit_(totals ? totals->hit : own_.hit),
      statistics_(totals ? totals->statistics : own_.statistics) {
  if (view.has_lens()) places.use_lens();
}

SampleSums::SampleSums(const RenderScene& scene, const ViewContext& viewer,
                       const RenderSettings& settings, PixelSampler& places, SummedRadiance shows)
    : viewer_(viewer),
      scene_(&scene),
      places_(&places),
      lights_(scene.rays(), places),
      reflections_(scene.world(), places),
      bounced_(scene, viewer_.shader, places),
      simd_(scene, viewer_),
      faces_(culling_of(settings)),
      shows_(shows),
      radiance_(own_.radiance),
      count_(own_.count),
      hit_(own_.hit),
      statistics_(own_.statistics) {
  if (sums_part()) simd_.leave_blended();
  if (viewer.view.has_lens()) places.use_lens();
}

void SampleSums::widen_colours(float times) {
  colours_ = times;
  simd_.widen_colours(times);
}

void SampleSums::note_layers(const RenderSettings& settings, const LayerTargets& targets) {
  if (!settings.layers.of_surfaces()) return;
  layers_ = &targets;
  layer_settings_ = &settings;
  light_ = settings.layers.of_light();
}

bool SampleSums::add_moving(const PointSample& sample) {
  places_->start_pixel(sample.x, sample.y);
  places_->start_sample(sample.index);
  const double time = places_->in_time();
  const int moment = moving_->picture->moment_at(time);
  std::unique_ptr<SampleSums>& at = moving_->at[static_cast<std::size_t>(moment)];
  if (!at) {
    at.reset(new SampleSums(moving_->picture->scene(moment), moving_->picture->view(moment),
                            *moving_->settings, *places_, &own_));
    at->widen_colours(colours_);
    if (layers_) at->note_layers(*layer_settings_, *layers_);
    at->moment_ = moment;
    if (moving_->picture->rays()) at->motion_ = moving_->picture;
  }
  at->times_[at->used_] = static_cast<float>(time);
  return at->add(sample);
}

void SampleSums::resize(std::size_t count) {
  radiance_.resize(count, glm::dvec3(0.0));
  count_.resize(count, 0);
  hit_.resize(count);
}

void SampleSums::add_pairs(std::size_t first, std::size_t count) {
  for (std::size_t i = 0; i < count / 2; ++i) {
    const std::size_t pair = first + 2 * i;
    radiance_[first + i] = radiance_[pair] + radiance_[pair + 1];
    count_[first + i] = count_[pair] + count_[pair + 1];
  }
  for (std::size_t i = first + count / 2; i < first + count; ++i) {
    radiance_[i] = glm::dvec3(0.0);
    count_[i] = 0;
  }
}

void SampleSums::trace() {
  if (moving_) {
    for (const std::unique_ptr<SampleSums>& moment : moving_->at)
      if (moment && moment->used_ > 0) moment->trace();
    return;
  }
  if (!std::exchange(hits_known_, false)) cast_rays();
  if (layers_ && !layers_->surfaces.empty()) add_layers();
  if (shows_ == SummedRadiance::layers) {
    used_ = 0;
    return;
  }
  shade_batch();
  follow_reflections();
  bounced_.follow(lights_.take_sky_rays(), lights_, sums(), statistics_);
  lights_.trace(sums(), statistics_);
  used_ = 0;
}

// Adds the layers of the waiting samples.
void SampleSums::add_layers() {
  if (!probe_) probe_.emplace(*scene_, viewer_, *layer_settings_);
  for (std::size_t i = 0; i < used_; ++i) {
    LayerSum* sum = layers_->surfaces[samples_[i].target / layers_->targets_each];
    if (sum) sum->add(probe_->at(seen_by(i, samples_[i].side), statistics_), 1.0);
  }
}

// Shades the samples of the SIMD path one by one after all, because a value is not finite.
void SampleSums::shade_alone_instead() {
  for (std::size_t i = 0; i < simd_.count(); ++i) {
    if (!simd_.is_top(i)) continue;
    alone_[alone_count_++] = simd_.index(i);
    --statistics_.samples_by_path[static_cast<std::size_t>(SamplePath::lanes)];
    statistics_.count_sample(SamplePath::not_finite);
  }
  simd_.clear();
}

// Shades the hits of the waiting samples.
void SampleSums::shade_batch() {
  const EyeRays waiting{*this};
  simd_.clear();
  alone_count_ = 0;
  for (std::size_t i = 0; i < used_; ++i) {
    hit_[samples_[i].target] = hits_[i];
    if (simd_.full_for(hits_[i])) shade_waiting_points(waiting);
    const SamplePath path = simd_.add(i, rays_[i], hits_[i], samples_[i].side);
    statistics_.count_sample(path);
    if (path == SamplePath::lanes) continue;
    if (!hits_[i].valid() && sums_part()) {
      count(samples_[i].target);
    } else if (!hits_[i].valid() && simd_.background()) {
      const glm::dvec3 background(*simd_.background());
      sums().add({samples_[i].target}, background, glm::dvec3(0.0), background);
      count(samples_[i].target);
    } else {
      alone_[alone_count_++] = i;
    }
  }
  shade_waiting_points(waiting);
  for (std::size_t k = 0; k < alone_count_; ++k) {
    const PointSample& sample = samples_[alone_[k]];
    const ViewedRay seen = seen_by(alone_[k], sample.side);
    if (add_background(viewer_.shader, sample, glm::vec3(1.0f), seen, sums())) {
      count(sample.target);
      continue;
    }
    places_->start_pixel(sample.x, sample.y);
    if (shade(sample, glm::vec3(1.0f), seen, shows_)) count(sample.target);
  }
}

// Shades the points of the SIMD path and empties it; sample(i) is that of ray i.
template <typename Rays>
void SampleSums::shade_waiting_points(const Rays& rays) {
  if (simd_.count() == 0) return;
  lights_.trace(sums(), statistics_);  // makes room for the first points
  if (!shade_points(rays)) return shade_alone_instead();
  for (std::size_t i = 0; Rays::first && i < simd_.count(); ++i)
    if (simd_.is_top(i)) count(rays.sample(simd_.index(i)).target);
  simd_.clear();
}

// Adds the points of the SIMD path. Returns false, without adding anything, if any value is not
// finite.
template <typename Rays>
bool SampleSums::shade_points(const Rays& rays) {
  SampledLights::Gathered& gathered = lights_.first_points();
  ShadingPoints& points = gathered.points;
  if (!simd_.shade(points)) return false;
  const Shader& shader = viewer_.shader;
  lights_.prepare(shader.lights(), shader.settings().shadows);
  const SummedRadiance shows = Rays::first ? shows_ : SummedRadiance::all;
  if (shows != SummedRadiance::lobes) lights_.gathered(simd_.count());
  const bool sky_rays = shadows_sky() && shows != SummedRadiance::direct;
  for (std::size_t i = 0; i < simd_.count(); ++i) {
    const std::size_t ray = simd_.index(i);
    const PointSample& place = rays.sample(ray);
    gathered.samples[i] = {place.x, place.y, place.index};
    gathered.targets[i] = {place.target, place.part};
    bool mirrors = false;
    if (sky_rays || lights_.picks_lights() || simd_.may_mirror(i)) start_sample(place);
    if (lights_.picks_lights()) gathered.picks[i] = lights_.pick_place();
    OneSample transport(lights_, reflections_, shader, place, rays.weight(ray), *places_, shows);
    if (simd_.may_mirror(i))
      mirrors = simd_.reflect(i, rays.seen(ray), points, transport, statistics_);
    simd_.set_mirrors(i, mirrors);
    if (sky_rays) {
      const glm::vec3 sky = rays.weight(ray) * simd_.add_sky(i, points, transport, statistics_);
      sums().add(gathered.targets[i], glm::dvec3(sky + transport.sky()));
    }
  }
  const bool whole = shows == SummedRadiance::all;
  if (whole && !sky_rays) simd_.reflect_skies(points);
  for (std::size_t i = 0; i < simd_.count(); ++i) {
    const glm::vec3 weight = simd_.share(i) * rays.weight(simd_.index(i));
    if (whole) {
      const glm::dvec3 emission(weight * simd_.emission(i));
      const glm::dvec3 radiance =
          sky_rays ? emission : glm::dvec3(weight * simd_.unlit_radiance(i, points));
      sums().add(gathered.targets[i], radiance, emission, glm::dvec3(0.0));
    }
    if (weight != glm::vec3(1.0f)) points.weigh(i, weight);
  }
  pass_surfaces(rays, points);
  return true;
}

// Continues the rays behind the blended surfaces of the SIMD path.
template <typename Rays>
void SampleSums::pass_surfaces(const Rays& rays, const ShadingPoints& points) {
  const Shader& shader = viewer_.shader;
  for (const SimdSamples::Passage& passage : simd_.passages()) {
    const std::size_t ray = simd_.index(passage.point);
    const PointSample& sample = rays.sample(ray);
    const ViewedRay seen = rays.seen(ray);
    const SurfacePoint point = simd_.point(passage.point, points);
    const VolumeBoundary* boundary = passage.boundary ? &*passage.boundary : nullptr;
    glm::vec3 through = passage.through;
    if (passage.bends) {
      start_sample(sample);
      OneSample transport(lights_, reflections_, shader, sample, rays.weight(ray), *places_);
      const Shader::Layer layer{through, seen.passed.count.layers(), seen.hit,
                                boundary ? passage.before : seen.passage, boundary};
      glm::vec3 later(0.0f);
      through = shader.add_refracted(seen, point, passage.roughness, layer, through, transport,
                                     later, statistics_);
    }
    const SampledReflections::Rest rest{passage.beside + through, passage.clear,
                                        boundary ? passage.behind : seen.passage};
    reflections_.pass(seen, point, rest, sample, rays.weight(ray), shader, statistics_);
  }
}

// Adds the radiance along a ray of the sample; `places_` must be at its pixel. Returns false,
// without adding anything, if the radiance is not finite.
bool SampleSums::shade(const PointSample& sample, glm::vec3 weight, const ViewedRay& seen,
                       SummedRadiance shows) {
  places_->start_sample(sample.index);
  const SampledLights::Waiting lights = lights_.waiting();
  const std::size_t reflections = reflections_.waiting();
  OneSample transport(lights_, reflections_, viewer_.shader, sample, weight, *places_, shows);
  const glm::vec3 radiance = weight * viewer_.shader.radiance(seen, transport, statistics_);
  if (std::isfinite(radiance.x + radiance.y + radiance.z)) {
    const SumTarget target{sample.target, sample.part};
    if (shows == SummedRadiance::all) {
      sums().add(target, glm::dvec3(radiance), glm::dvec3(weight * transport.emission()),
                 glm::dvec3(weight * transport.background()));
    } else {
      sums().add(target, glm::dvec3(transport.sky()));
    }
    return true;
  }
  ++statistics_.rejected_samples;
  lights_.forget_since(lights);
  reflections_.forget_since(reflections);
  return false;
}

// Traces continued rays one surface after the other, a batch of rays at a time.
void SampleSums::follow_reflections() {
  while (reflections_.any()) {
    const std::vector<ReflectedSample> samples = reflections_.take();
    for (std::size_t first = 0; first < samples.size(); first += batch) {
      const std::size_t count = std::min(batch, samples.size() - first);
      const std::span some = std::span(samples).subspan(first, count);
      cast_continued(some);
      shade_reflections(some);
    }
  }
}

// Shades the hits of continued rays, at most a batch.
void SampleSums::shade_reflections(std::span<const ReflectedSample> samples) {
  const ContinuedRays waiting{*this, samples};
  simd_.clear();
  alone_count_ = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (simd_.full_for(hits_[i])) shade_waiting_points(waiting);
    const SamplePath path = simd_.add_reflected(i, samples[i].viewed(hits_[i]));
    statistics_.count_sample(path);
    if (path != SamplePath::lanes) alone_[alone_count_++] = i;
  }
  shade_waiting_points(waiting);
  for (std::size_t k = 0; k < alone_count_; ++k) {
    const ReflectedSample& next = samples[alone_[k]];
    const ViewedRay seen = next.viewed(hits_[alone_[k]]);
    if (add_background(viewer_.shader, next.sample, next.weight, seen, sums())) continue;
    places_->start_pixel(next.sample.x, next.sample.y);
    (void)shade(next.sample, next.weight, seen);
  }
}

BlockResult SampleSums::block(PixelRect rect) const {
  BlockResult result;
  result.statistics = statistics_;
  result.tile.rect = rect;
  const auto pixels = static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height);
  result.tile.radiance.reserve(pixels);
  result.tile.split_level.assign(pixels, 0);
  for (std::size_t i = 0; i < pixels; ++i) result.tile.radiance.emplace_back(sum(i).mean());
  return result;
}

}  // namespace asos
