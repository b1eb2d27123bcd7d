#include "renderer/samples/sample_sums.h"

#include "renderer/prepared/screen_motion.h"
#include "renderer/reflections/own_side.h"
#include "renderer/samples/one_sample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace asos {
namespace {

/// Returns the ray at a fraction of the way from one to another.
Ray between(const Ray& from, const Ray& to, double way) {
  const auto part = static_cast<float>(way);
  Ray ray = from;
  ray.origin = glm::mix(from.origin, to.origin, part);
  ray.direction = glm::normalize(glm::mix(from.direction, to.direction, part));
  return ray;
}

/// A ray of a sample, with its hit and the weight of its radiance in the sample.
struct SeenSample {
  const PointSample& sample;
  glm::vec3 weight;
  ViewedRay seen;
};

}  // namespace

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
  if (shows_ == SummedRadiance::lobes) {
    gather_lobes();
  } else {
    shade_batch();
  }
  follow_reflections();
  bounced_.follow(lights_.take_sky_rays(), lights_, sums(), statistics_);
  lights_.trace(sums(), statistics_);
  used_ = 0;
}

void SampleSums::cast_rays() {
  const std::span rays = std::span(rays_).first(used_);
  const std::span hits = std::span(hits_).first(used_);
  const bool lens = viewer_.view.has_lens();
  aim(viewer_.view, rays);
  if (motion_)
    cast_in_motion();
  else
    scene_->rays().closest(rays, hits, faces_);
  if (viewer_.mirror)
    pass_mirror(*viewer_.mirror, scene_->world(), scene_->rays(), faces_, rays, hits);
  pass_own_side(viewer_.passage, scene_->world(), scene_->rays(), faces_, rays, hits);
  if (lens) widen_footprints();
  (viewer_.bounces > 0 ? statistics_.reflection_rays : statistics_.eye_rays) += used_;
}

// Adds the layers of the waiting samples.
void SampleSums::add_layers() {
  if (!probe_) probe_.emplace(*scene_, viewer_, *layer_settings_);
  for (std::size_t i = 0; i < used_; ++i) {
    LayerSum* sum = layers_->surfaces[samples_[i].target / layers_->targets_each];
    if (sum) sum->add(probe_->at(seen_by(i, samples_[i].side), statistics_), 1.0);
  }
}

// Each sample's ray starts at its own point of the lens.
void SampleSums::aim(const View& view, std::span<Ray> rays) {
  if (!view.has_lens()) {
    view.rays(std::span(points_).first(used_), rays);
    return;
  }
  for (std::size_t i = 0; i < used_; ++i) {
    const PointSample& sample = samples_[i];
    if (i == 0 || sample.x != samples_[i - 1].x || sample.y != samples_[i - 1].y)
      places_->start_pixel(sample.x, sample.y);
    places_->start_sample(sample.index);
    const ExposurePoint exposure{point_on_aperture(view.lens(), places_->on_lens())};
    rays[i] = view.ray(points_[i].x, points_[i].y, exposure);
  }
}

// Each sample's ray meets the scene at its own time. The surface is then shaded as at the moment:
// the ray is shifted by the way that its point moves until then.
void SampleSums::cast_in_motion() {
  const std::span rays = std::span(rays_).first(used_);
  const int steps = motion_->steps();
  const auto after = [&](std::size_t i) {
    return static_cast<double>(times_[i]) * steps - moment_;
  };
  const auto neighbour = [&](std::size_t i) { return moment_ + (after(i) > 0.0 ? 1 : -1); };
  if (motion_->camera_moves()) {
    std::array<Ray, batch> others;
    for (const int other : {moment_ - 1, moment_ + 1}) {
      if (other < 0 || other > steps) continue;
      aim(motion_->view(other), std::span(others).first(used_));
      for (std::size_t i = 0; i < used_; ++i)
        if (neighbour(i) == other) rays[i] = between(rays[i], others[i], std::abs(after(i)));
    }
  }
  motion_->rays()->closest(rays, std::span(times_).first(used_), scene_->world(),
                           std::span(hits_).first(used_), faces_);
  for (std::size_t i = 0; i < used_; ++i) {
    if (!hits_[i].valid() || after(i) == 0.0) continue;
    const glm::dvec3 way =
        way_of_point(motion_->scene(neighbour(i)).world(), scene_->world(), hits_[i]);
    rays[i].origin += glm::vec3(std::abs(after(i)) * way);
  }
}

// Widens the footprints, since the samples of a pixel share the pixel and its circle of confusion.
void SampleSums::widen_footprints() {
  const View& view = viewer_.view;
  const double pixel = static_cast<double>(viewer_.pixel) * static_cast<double>(viewer_.pixel);
  const double disk = std::numbers::pi * aperture_share(view.lens()) / pixel;
  for (std::size_t i = 0; i < used_; ++i) {
    const double depth = hits_[i].valid() ? view.depth(rays_[i], hits_[i].t)
                                          : std::numeric_limits<double>::infinity();
    const double radius = view.confusion(depth);
    samples_[i].side *= static_cast<float>(std::sqrt(1.0 + disk * radius * radius));
  }
}

// Collects the lobes' reflections at the hits of the waiting samples.
void SampleSums::gather_lobes() {
  simd_.clear();
  std::size_t alone = 0;
  for (std::size_t i = 0; i < used_; ++i) {
    hit_[samples_[i].target] = hits_[i];
    count(samples_[i].target);
    const SamplePath path = simd_.add(i, rays_[i], hits_[i], samples_[i].side);
    statistics_.count_sample(path);
    if (path != SamplePath::lanes && hits_[i].valid()) alone_[alone++] = i;
  }
  const Shader& shader = viewer_.shader;
  const auto gather = [&](std::size_t i, const auto& reflect) {
    const PointSample& sample = samples_[i];
    places_->start_pixel(sample.x, sample.y);
    places_->start_sample(sample.index);
    OneLobeSample transport(reflections_, shader, sample);
    reflect(seen_by(i, sample.side), transport);
  };
  ShadingPoints& points = lights_.first_points().points;
  const bool plain = simd_.count() > 0 && simd_.shade(points);
  if (!plain) count_lost_batch();
  for (std::size_t k = 0; k < simd_.count(); ++k) {
    if (!plain) {
      alone_[alone++] = simd_.index(k);
    } else if (simd_.may_mirror(k)) {
      gather(simd_.index(k), [&](const ViewedRay& seen, OneLobeSample& transport) {
        (void)simd_.reflect(k, seen, points, transport, statistics_);
      });
    }
  }
  for (std::size_t k = 0; k < alone; ++k) {
    gather(alone_[k], [&](const ViewedRay& seen, OneLobeSample& transport) {
      (void)shader.radiance(seen, transport, statistics_);
    });
  }
}

// Counts the samples of a batch that is shaded one by one after all.
void SampleSums::count_lost_batch() {
  const auto count = [this](SamplePath path) -> std::uint64_t& {
    return statistics_.samples_by_path[static_cast<std::size_t>(path)];
  };
  count(SamplePath::lanes) -= simd_.count();
  count(SamplePath::not_finite) += simd_.count();
}

// Shades the hits of the waiting samples.
void SampleSums::shade_batch() {
  simd_.clear();
  std::size_t alone = 0;
  for (std::size_t i = 0; i < used_; ++i) {
    hit_[samples_[i].target] = hits_[i];
    const SamplePath path = simd_.add(i, rays_[i], hits_[i], samples_[i].side);
    statistics_.count_sample(path);
    if (path == SamplePath::lanes) continue;
    if (!hits_[i].valid() && simd_.background()) {
      const glm::dvec3 background(*simd_.background());
      sums().add({samples_[i].target}, background, glm::dvec3(0.0), background);
      count(samples_[i].target);
    } else {
      alone_[alone++] = i;
    }
  }
  const auto seen_sample = [this](std::size_t i) {
    return SeenSample{samples_[i], glm::vec3(1.0f), seen_by(i, samples_[i].side)};
  };
  if (simd_.count() > 0 && !shade_plain(seen_sample)) {
    count_lost_batch();
    for (std::size_t i = 0; i < simd_.count(); ++i) alone_[alone++] = simd_.index(i);
  } else {
    for (std::size_t i = 0; i < simd_.count(); ++i) count(samples_[simd_.index(i)].target);
  }
  for (std::size_t k = 0; k < alone; ++k) {
    const PointSample& sample = samples_[alone_[k]];
    if (k == 0 || sample.x != samples_[alone_[k - 1]].x || sample.y != samples_[alone_[k - 1]].y)
      places_->start_pixel(sample.x, sample.y);
    if (shade(sample, glm::vec3(1.0f), seen_by(alone_[k], sample.side))) count(sample.target);
  }
}

// Shades the points of the SIMD path; sample(i) is that of ray i. Returns false, without adding
// anything, if any value is not finite.
template <typename Sample>
bool SampleSums::shade_plain(const Sample& sample) {
  SampledLights::Gathered& gathered = lights_.first_points();
  ShadingPoints& points = gathered.points;
  if (!simd_.shade(points)) return false;
  const Shader& shader = viewer_.shader;
  lights_.prepare(shader.lights(), shader.settings().shadows);
  lights_.gathered(simd_.count());
  const bool sky_rays = shader.settings().sky_shadows;
  for (std::size_t i = 0; i < simd_.count(); ++i) {
    const SeenSample of = sample(simd_.index(i));
    const PointSample& place = of.sample;
    gathered.samples[i] = {place.x, place.y, place.index};
    gathered.targets[i] = {place.target, place.part};
    bool mirrors = false;
    if (sky_rays || lights_.picks_lights() || simd_.may_mirror(i)) {
      places_->start_pixel(place.x, place.y);
      places_->start_sample(place.index);
    }
    if (lights_.picks_lights()) gathered.picks[i] = lights_.pick_place();
    OneSample transport(lights_, reflections_, shader, place, of.weight);
    if (simd_.may_mirror(i)) mirrors = simd_.reflect(i, of.seen, points, transport, statistics_);
    simd_.set_mirrors(i, mirrors);
    if (sky_rays) simd_.add_sky(i, points, transport, statistics_);
  }
  if (!sky_rays) simd_.reflect_skies(points);
  for (std::size_t i = 0; i < simd_.count(); ++i) {
    const glm::vec3 weight = sample(simd_.index(i)).weight;
    const glm::dvec3 emission(weight * simd_.emission(i));
    const glm::dvec3 radiance =
        sky_rays ? emission : glm::dvec3(weight * simd_.unlit_radiance(i, points));
    sums().add(gathered.targets[i], radiance, emission, glm::dvec3(0.0));
    if (weight != glm::vec3(1.0f)) points.weigh(i, weight);
  }
  return true;
}

// Adds the radiance along a ray of the sample; `places_` must be at its pixel. Returns false,
// without adding anything, if the radiance is not finite.
bool SampleSums::shade(const PointSample& sample, glm::vec3 weight, const ViewedRay& seen) {
  places_->start_sample(sample.index);
  const SampledLights::Waiting lights = lights_.waiting();
  const std::size_t reflections = reflections_.waiting();
  OneSample transport(lights_, reflections_, viewer_.shader, sample, weight);
  const glm::vec3 radiance = weight * viewer_.shader.radiance(seen, transport, statistics_);
  if (std::isfinite(radiance.x + radiance.y + radiance.z)) {
    sums().add({sample.target, sample.part}, glm::dvec3(radiance),
               glm::dvec3(weight * transport.emission()),
               glm::dvec3(weight * transport.background()));
    return true;
  }
  ++statistics_.rejected_samples;
  lights_.forget_since(lights);
  reflections_.forget_since(reflections);
  return false;
}

// Traces reflections bounce by bounce, a batch of rays at a time.
void SampleSums::follow_reflections() {
  while (reflections_.waiting() > 0) {
    const std::vector<ReflectedSample> samples = reflections_.take();
    for (std::size_t first = 0; first < samples.size(); first += batch) {
      const std::size_t count = std::min(batch, samples.size() - first);
      for (std::size_t i = 0; i < count; ++i) rays_[i] = samples[first + i].ray;
      scene_->rays().closest(std::span(rays_).first(count), std::span(hits_).first(count), faces_);
      statistics_.reflection_rays += count;
      for (std::size_t i = 0; i < count; ++i) {
        const ReflectedSample& next = samples[first + i];
        if (next.mirror) {
          pass_mirror(*next.mirror, scene_->world(), scene_->rays(), faces_, {&rays_[i], 1},
                      {&hits_[i], 1});
        }
        pass_own_side(next.passage, scene_->world(), scene_->rays(), faces_, {&rays_[i], 1},
                      {&hits_[i], 1});
      }
      shade_reflections(std::span(samples).subspan(first, count));
    }
  }
}

// Shades the hits of reflected rays, at most a batch.
void SampleSums::shade_reflections(std::span<const ReflectedSample> samples) {
  const auto seen_sample = [&](std::size_t i) {
    return SeenSample{samples[i].sample, samples[i].weight, samples[i].viewed(hits_[i])};
  };
  simd_.clear();
  std::size_t alone = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const SamplePath path = simd_.add_reflected(i, samples[i].viewed(hits_[i]));
    statistics_.count_sample(path);
    if (path != SamplePath::lanes) alone_[alone++] = i;
  }
  if (simd_.count() > 0) {
    lights_.trace(sums(), statistics_);  // makes room for the first points
    if (!shade_plain(seen_sample)) {
      count_lost_batch();
      for (std::size_t i = 0; i < simd_.count(); ++i) alone_[alone++] = simd_.index(i);
    }
  }
  for (std::size_t k = 0; k < alone; ++k) {
    const ReflectedSample& next = samples[alone_[k]];
    places_->start_pixel(next.sample.x, next.sample.y);
    (void)shade(next.sample, next.weight, next.viewed(hits_[alone_[k]]));
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
