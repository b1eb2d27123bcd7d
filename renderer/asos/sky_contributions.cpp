#include "renderer/asos/sky_contributions.h"

#include "renderer/geometry/finite.h"
#include "renderer/geometry/largest.h"
#include "renderer/pyray/tuning.h"
#include "renderer/sampling/sequential_mean.h"
#include "renderer/sampling/sobol_points.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shading/sky.h"
#include "renderer/shading/sky_light.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace asos {
namespace {

// Returns the sky's radiance that a surface reflects to its viewer if nothing occludes the sky, to
// within `error`. It uses the closed form where there is one (unoccluded_sky), and samples without
// rays elsewhere. `leaf` is the leaf's Sobol sequence; the samples use another stream of it
// than rays do.
glm::vec3 unoccluded_sky_within(const SkyQuery& point, const SobolPixel& leaf, double error) {
  if (const auto known = unoccluded_sky(point)) return *known;
  const SkySampler sampler(point);
  // Matte reflection has a closed form under more skies. Samples determine the rest.
  const std::optional<glm::vec3> matte = open_sky_of_matte(point);
  const SamplingGoal goal{
      error, error > SkyTuning::coarse ? SkyTuning::few_samples : SkyTuning::enough_samples,
      SkyTuning::most_samples, false};
  SequentialMean mean;
  std::uint32_t taken = 0;
  for (std::uint32_t end = goal.least;; end = goal.after_next_round(end)) {
    for (; taken < end; ++taken) {
      const auto sample = sampler.at(leaf.light(taken, number_of(SkyStream::unoccluded)));
      glm::dvec3 carried(0.0);
      if (sample && std::isfinite(sample->carried.x + sample->carried.y + sample->carried.z))
        carried = glm::dvec3(sample->carried) - (matte ? glm::dvec3(sample->matte) : carried);
      mean.add(carried);
    }
    if (goal.met(end, mean.standard_error()))
      return glm::max(glm::vec3(mean.mean()) + matte.value_or(glm::vec3(0.0f)), 0.0f);
  }
}

/// Sums of the rays' errors and squared errors.
struct ErrorSums {
  double rays = 0.0, error = 0.0, error2 = 0.0;

  ErrorSums& operator+=(const ErrorSums& other) {
    rays += other.rays;
    error += other.error;
    error2 += other.error2;
    return *this;
  }
  [[nodiscard]] double variance() const {
    const double mean = error / rays;
    return std::max(0.0, error2 / rays - mean * mean);
  }
};

}  // namespace

SkyContributions::SkyContributions(const EyeContext& eye)
    : eye_(&eye),
      bounces_(eye.viewer.shader.settings().bounces),
      places_(eye.seed),
      lights_(eye.scene->rays(), places_),
      bounced_(*eye.scene, eye.viewer.shader, places_) {
  packet_->count = 0;
}

// Returns the leaf's own Sobol sequence.
SobolPixel SkyContributions::leaf_places(const SkyLeaf& lit) const {
  return {static_cast<int>(lit.leaf->seed >> 32), static_cast<int>(lit.leaf->seed),
          static_cast<std::uint32_t>(eye_->seed)};
}

void SkyContributions::add(std::uint32_t number, const SkyQuery& point, const Leaf& leaf) {
  SkyLeaf& lit = lit_.emplace_back();
  lit.share = number;
  lit.leaf = &leaf;
  lit.point = point.view.point;
  lit.flat = !leaf.region.marginal && lit.point.triangle != Hit::none &&
             !(eye_->scene->features().deviation(lit.point.triangle) > 0.0f);
  lit.smooth_surface = eye_->scene->features().smooth_surface(lit.point.triangle);
  lit.material = point.material;
  lit.to_viewer = point.view.to_viewer;
  lit.n_dot_v = point.view.n_dot_v;
  lit.sky = point.sky;
  lit.mirrors = point.mirrors;
  lit.factor = point.share;
  lit.open = unoccluded_sky_within(
      point, leaf_places(lit),
      SkyTuning::share_of_unoccluded * eye_->error_budget.standard_error(leaf.weight));
  const glm::vec3 specular = point.mirrors ? glm::vec3(0.0f) : point.material.specular;
  lit.unit = bounces_ ? point.share * (point.material.diffuse + specular) : lit.open;
}

glm::vec3 SkyContributions::at_once(const SkyQuery& point, const Leaf& leaf) {
  add(start(leaf), point, leaf);
  return glm::vec3(run().front().radiance / leaf.weight);
}

// Returns where the next ray of a plane leaf starts, relative to its sample: at any place in its
// region, whose bounding rectangle is `box`.
glm::vec3 SkyContributions::beside(const SkyLeaf& lit, const Bounds2& box,
                                   const SobolPixel& leaf) const {
  if (!lit.flat) return glm::vec3(0.0f);
  const LeafRegion& all = lit.leaf->region;
  const glm::dvec3 from(lit.point.position);
  const HalfSpace plane = HalfSpace::through(from, glm::dvec3(lit.point.geometric_normal));
  for (std::uint32_t i = 0; i < sky_place_tries; ++i) {
    const glm::vec2 at =
        glm::mix(box.lo, box.hi, glm::vec2(leaf.light(lit.rays, number_of(SkyStream::places, i))));
    if (!all.holds(at)) continue;
    const auto found = eye_->frame->on_plane(glm::dvec2(at), plane);
    return found ? glm::vec3(*found - from) : glm::vec3(0.0f);
  }
  return glm::vec3(0.0f);
}

// Sends the rays of a surface up to number `end`.
void SkyContributions::send(std::size_t index, std::uint32_t end) {
  SkyLeaf& lit = lit_[index];
  if (lit.rays >= end) return;
  const ViewedPoint view{lit.point, lit.to_viewer, lit.n_dot_v};
  const SkySampler sampler(lit.lit_point(view));
  // Directions take the sequence's first two dimensions, and places the next ones.
  const SobolPixel leaf = leaf_places(lit);
  SobolPixelSampler places;
  const Bounds2 box = bounds_of(lit.leaf->region);
  for (; lit.rays < end; ++lit.rays) {
    const auto sample = sampler.at(places.at(leaf, lit.rays));
    if (!sample) continue;
    if (!finite(sample->carried)) {
      ++eye_->counts->rejected_samples;
      continue;
    }
    lit.sent += glm::dvec3(sample->carried);
    ++eye_->counts->sky_rays;
    const std::size_t i = packet_->count++;
    packet_->rays[i] = sky_ray(lit.point, *sample);
    packet_->rays[i].origin += beside(lit, box, leaf);
    packet_->sent[i] = {index, sample->carried, sample->weight, lit.rays};
    if (packet_->count == Packet::size) trace();
  }
}

void SkyContributions::trace() {
  if (bounces_) return trace_bounces();
  Packet& packet = *packet_;
  const std::size_t count = std::exchange(packet.count, 0);
  eye_->scene->rays().transmittance(std::span(packet.rays).first(count), packet.passed);
  for (std::size_t i = 0; i < count; ++i)
    lit_[packet.sent[i].lit].arrive(
        glm::dvec3(packet.passed[i]) * glm::dvec3(packet.sent[i].carried), packet.sent[i].carried);
}

// A ray's bounced radiance replaces the sky's. Each ray is summed by itself, for the variance.
void SkyContributions::trace_bounces() {
  const std::size_t count = std::exchange(packet_->count, 0);
  sky_rays_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const Sent& sent = packet_->sent[i];
    const std::uint64_t seed = lit_[sent.lit].leaf->seed;
    const SampleIndex sample{static_cast<int>(seed >> 32), static_cast<int>(seed),
                             static_cast<int>(sent.number)};
    sky_rays_.push_back({packet_->rays[i], sent.weight, sample, {i}});
  }
  brought_.assign(count, glm::dvec3(0.0));
  bounced_.follow(sky_rays_, lights_, brought_, *eye_->counts);
  lights_.trace(brought_, *eye_->counts);
  for (std::size_t i = 0; i < count; ++i)
    lit_[packet_->sent[i].lit].arrive(brought_[i], packet_->sent[i].carried);
}

// Returns the expected variance, from the leaf's own rays and its neighbours', and the number of
// rays that brings the mean's error within the allowance of its weight.
SkyFits::Expected SkyContributions::expected(const SkyLeaf& lit, double of_neighbours) const {
  if (lit.rays == 0 || (!bounces_ && !(largest(lit.sent) > 0.0))) return {};
  const double variance = (lit.squares() + SkyTuning::rays_of_prior * of_neighbours) /
                          (lit.rays - 1.0 + SkyTuning::rays_of_prior);
  const double unit = std::min(1.0, static_cast<double>(largest(lit.unit)));
  const double error = eye_->error_budget.standard_error(lit.leaf->weight) / unit;
  const double rays = SkyLeaf::rays_for(variance, error * error);
  const double most =
      std::min(eye_->error_budget.most_samples(lit.leaf->weight), double{SkyTuning::most_rays});
  return {variance, std::bit_ceil(static_cast<std::uint32_t>(std::clamp(rays, 1.0, most)))};
}

// Neighbouring pixels see almost the same part of the sky, and the whole block a similar one. The
// block starts with one half-occluded ray as its prior.
void SkyContributions::expect() {
  const int side = std::max(1, static_cast<int>(std::lround(1.0f / eye_->root_side())));
  const auto place = [&](const SkyLeaf& lit) {
    return glm::clamp(glm::ivec2(lit.leaf->at * static_cast<float>(side)), 0, side - 1);
  };
  const auto index = [side](int x, int y) { return static_cast<std::size_t>(y * side + x); };
  ErrorSums block{1.0, 0.5, 0.5};
  std::vector<ErrorSums> pixels(index(0, side));
  for (const SkyLeaf& lit : lit_) {
    const glm::ivec2 at = place(lit);
    const ErrorSums sums{static_cast<double>(lit.rays), lit.error, lit.error2};
    block += sums;
    pixels[index(at.x, at.y)] += sums;
  }
  expected_.clear();
  for (const SkyLeaf& lit : lit_) {
    const glm::ivec2 at = place(lit);
    const double rays = SkyTuning::rays_of_prior / block.rays;
    ErrorSums around{rays * block.rays, rays * block.error, rays * block.error2};
    for (int y = std::max(0, at.y - 1); y <= std::min(side - 1, at.y + 1); ++y)
      for (int x = std::max(0, at.x - 1); x <= std::min(side - 1, at.x + 1); ++x)
        around += pixels[index(x, y)];
    expected_.push_back(expected(lit, around.variance()));
  }
}

void SkyContributions::share_surfaces() {
  const SkyFits sky_fits(lit_, expected_, eye_->error_budget.standard_error(1.0));
  std::vector<SkyFits::Cell> cells = sky_fits.cells(), parts;
  while (!cells.empty()) {
    std::erase_if(cells, [&](SkyFits::Cell& cell) { return !sky_fits.choose_nodes(cell); });
    for (const SkyFits::Cell& cell : cells)
      for (const std::uint32_t node : cell.nodes) send(node, cell.node_rays);
    trace();
    parts.clear();
    for (const SkyFits::Cell& cell : cells)
      if (!sky_fits.assign(cell)) sky_fits.divide(cell, parts);
    cells.swap(parts);
  }
}

std::span<const Contribution> SkyContributions::run() {
  for (std::size_t i = 0; i < lit_.size(); ++i) {
    const auto part = static_cast<std::uint32_t>(SkyTuning::first_rays * lit_[i].leaf->weight);
    if (held(lit_[i])) send(i, std::bit_ceil(std::max(SkyTuning::fewest_rays, part)));
  }
  trace();
  expect();
  if (!eye_->mirrored()) share_surfaces();
  for (std::size_t i = 0; i < lit_.size(); ++i)
    if (held(lit_[i]) && !lit_[i].fitted) send(i, expected_[i].rays);
  trace();
  for (const SkyLeaf& lit : lit_) {
    if (!held(lit)) continue;
    Contribution& found = queue_[lit.share];
    found.radiance += lit.leaf->weight * lit.mean();
    found.rays += lit.rays;
  }
  lit_.clear();
  return queue_.take();
}

}  // namespace asos
