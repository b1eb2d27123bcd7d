#include "renderer/prepared/screen_motion.h"
#include "renderer/reflections/own_side.h"
#include "renderer/samples/sample_sums.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

// The rays of samples and their hits.

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

}  // namespace

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

// Casts the continued rays of at most a batch of samples.
void SampleSums::cast_continued(std::span<const ReflectedSample> samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) rays_[i] = samples[i].ray;
  scene_->rays().closest(std::span(rays_).first(samples.size()),
                         std::span(hits_).first(samples.size()), faces_);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const ReflectedSample& next = samples[i];
    ++(next.bounces > 0 ? statistics_.reflection_rays : statistics_.eye_rays);
    if (next.passes()) continue;
    if (next.mirror) {
      pass_mirror(*next.mirror, scene_->world(), scene_->rays(), faces_, {&rays_[i], 1},
                  {&hits_[i], 1});
    }
    pass_own_side(next.passage, scene_->world(), scene_->rays(), faces_, {&rays_[i], 1},
                  {&hits_[i], 1});
  }
}

}  // namespace asos
