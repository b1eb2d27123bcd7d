#include "renderer/methods/eye_caster.h"

#include "renderer/shading/unevenness.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {
namespace {

// How far one sample may be off the mean of the patch that it stands for: EPS, or a quarter of a
// finest cell where that is more, so that MAX alone refines shading as it refines outlines; but no
// less than an eighth of one step of an 8-bit picture, which nobody sees and which would cost most.
float let_pass(const RenderSettings& settings) {
  if (!settings.refine_shading) return std::numeric_limits<float>::infinity();
  constexpr double invisible = 1.0 / 2048.0;
  return static_cast<float>(
      std::max({settings.eps, std::ldexp(1.0, -2 * (settings.max_level + 1)), invisible}));
}

// The side, in pixels, of the square that a leaf stands for, whatever its shape.
float side_of(double weight) {
  return static_cast<float>(std::sqrt(weight));
}

}  // namespace

EyeCaster::EyeCaster(const RenderScene& scene, const View& view, const RenderSettings& settings,
                     const Frame& frame, PixelRect block, std::size_t roots,
                     const std::stop_token& stop, RenderStatistics& counts)
    : scene_(scene),
      view_(view),
      frame_(frame),
      block_(block),
      stop_(stop),
      counts_(counts),
      shader_(shader_of(scene, settings, view)),
      spacing_(PixelSpacing::of(view)),
      most_uneven_(let_pass(settings)),
      sums_(roots) {}

Caster::SampleId EyeCaster::probe(std::span<const glm::vec2> points) {
  const std::size_t first = rays_.size();
  points_.insert(points_.end(), points.begin(), points.end());
  for (const glm::vec2& p : points) {
    rays_.push_back(view_.ray(block_.x + static_cast<double>(p.x) * block_.width,
                              block_.y + static_cast<double>(p.y) * block_.height));
  }
  hits_.resize(rays_.size());
  // In runs of which each takes well under a millisecond, so that cancelling is quick.
  constexpr std::size_t run = 1024;
  for (std::size_t i = first; i < rays_.size() && !cancelled(); i += run) {
    const std::size_t count = std::min(run, rays_.size() - i);
    scene_.rays.closest(std::span(rays_).subspan(i, count), std::span(hits_).subspan(i, count));
  }
  counts_.eye_rays += points.size();
  return static_cast<SampleId>(first);
}

Cover EyeCaster::cover(SampleId sample) const {
  const Hit& hit = hits_[sample];
  if (!hit.valid()) return Cover::none();
  // What is seen through a surface is not hidden by it.
  if (!opaque(sample)) return Cover::none();
  const glm::uvec3 t = scene_.world.triangles[hit.triangle];
  const glm::dvec3 p0(scene_.world.positions[t.x]);
  const glm::dvec3 e1 = glm::dvec3(scene_.world.positions[t.y]) - p0;
  const glm::dvec3 e2 = glm::dvec3(scene_.world.positions[t.z]) - p0;
  const glm::dvec3 p = p0 + static_cast<double>(hit.b1) * e1 + static_cast<double>(hit.b2) * e2;
  return Cover::plane(frame_, p, glm::cross(e1, e2), scene_.features.departure(hit.triangle));
}

bool EyeCaster::opaque(SampleId sample) const {
  const Hit& hit = hits_[sample];
  if (!hit.valid()) return true;
  const Material& material = scene_.world.material_of(hit.triangle);
  return material.alpha_mode == AlphaMode::opaque && !(material.transmission > 0.0f);
}

std::uint32_t EyeCaster::surface(SampleId sample) const {
  // The background is a surface too.
  const Hit& hit = hits_[sample];
  return hit.valid() ? scene_.features.sheet(hit.triangle) : Hit::none;
}

void EyeCaster::leaf(std::uint32_t root, SampleId sample, double weight) {
  if (cancelled()) return;
  if (root == logged_root_) logged_leaves_.push_back({sample, points_[sample], weight});
  const glm::vec3 radiance =
      shader_.radiance(rays_[sample], hits_[sample], side_of(weight), counts_);
  if (!std::isfinite(radiance.x + radiance.y + radiance.z)) {
    ++counts_.rejected_samples;
    return;
  }
  sums_[root].radiance += weight * glm::dvec3(radiance);
  sums_[root].weight += weight;
}

bool EyeCaster::uneven(SampleId sample, double share) const {
  const Hit& hit = hits_[sample];
  if (!hit.valid() || !std::isfinite(most_uneven_)) return false;
  const glm::uvec3 t = scene_.world.triangles[hit.triangle];
  const glm::vec3 p0 = scene_.world.positions[t.x];
  const glm::vec3 normal = glm::normalize(
      glm::cross(scene_.world.positions[t.y] - p0, scene_.world.positions[t.z] - p0));
  const Ray& ray = rays_[sample];
  const Patch patch =
      patch_on_plane(spacing_, ray.direction, hit.t, normal, static_cast<float>(std::sqrt(share)));
  return midpoint_error(scene_.world, hit, ray.at(hit.t), -ray.direction, patch) > most_uneven_;
}

glm::vec3 EyeCaster::radiance(SampleId sample, double weight) const {
  RenderStatistics uncounted;
  return shader_.radiance(rays_[sample], hits_[sample], side_of(weight), uncounted);
}

glm::vec3 EyeCaster::colour(std::uint32_t root) const {
  const Sum& sum = sums_[root];
  return sum.weight > 0.0 ? glm::vec3(sum.radiance / sum.weight) : glm::vec3(0.0f);
}

}  // namespace asos
