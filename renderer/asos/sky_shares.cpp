#include "renderer/asos/sky_shares.h"

#include "renderer/geometry/largest.h"
#include "renderer/shading/sky_light.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace asos {
namespace {

// A whole pixel's at first; parts of one get their share of them, but a few.
constexpr double first_rays = 8.0;
constexpr std::uint32_t fewest_rays = 2;
constexpr std::uint32_t most_rays = 1024;
// What all of a block see is worth so many rays of a leaf's own.
constexpr double rays_of_neighbours = 8.0;

bool finite(glm::vec3 v) {
  return std::isfinite(v.x + v.y + v.z);
}

}  // namespace

SkyShares::SkyShares(const EyeContext& eye)
    : eye_(&eye),
      bounces_(eye.viewer.shader.settings().bounces),
      places_(eye.seed),
      lights_(eye.scene->rays(), places_),
      bounced_(*eye.scene, eye.viewer.shader, places_) {}

double SkyShares::Lit::seen() const {
  return largest(sent) > 0.0 ? std::min(1.0, largest(arrived) / largest(sent)) : 1.0;
}

// Where most of the sky is seen, the rays tell what of it is hidden.
glm::dvec3 SkyShares::Lit::mean() const {
  const double all = rays;
  if (!open || seen() < 0.5) return arrived / all;
  return glm::max(glm::dvec3(*open) - (sent - arrived) / all, 0.0);
}

std::uint32_t SkyShares::start(std::uint32_t root, SampleId sample, double weight) {
  shares_.push_back({root, sample, weight});
  return static_cast<std::uint32_t>(shares_.size() - 1);
}

void SkyShares::add(std::uint32_t share, const SkyLitPoint& point, const LeafContext& leaf) {
  lit_.push_back({share, point.view.point, point.material, point.view.to_viewer, point.view.n_dot_v,
                  point.sky, point.mirrors, point.share, leaf.seed, open_sky(point)});
}

glm::vec3 SkyShares::at_once(const SkyLitPoint& point, const LeafContext& leaf) {
  add(start(0, 0, leaf.weight), point, leaf);
  return glm::vec3(run().front().radiance / leaf.weight);
}

// Sends the rays of a surface up to number `end`.
void SkyShares::send(std::size_t index, std::uint32_t end) {
  Lit& lit = lit_[index];
  const ViewedPoint view{lit.point, lit.to_viewer, lit.n_dot_v};
  const SkyLitPoint point{lit.sky, view, lit.material, lit.mirrors, lit.factor};
  const SobolPixel places(static_cast<int>(lit.seed >> 32), static_cast<int>(lit.seed),
                          static_cast<std::uint32_t>(eye_->seed));
  for (; lit.rays < end; ++lit.rays) {
    const auto sample = sample_sky(point, places.lobe(lit.rays, lobe_of_sky));
    if (!sample) continue;
    if (!finite(sample->carried)) {
      ++eye_->counts->rejected_samples;
      continue;
    }
    lit.sent += glm::dvec3(sample->carried);
    if (!sample->above) continue;
    ++eye_->counts->sky_rays;
    rays_.push_back(sky_ray(lit.point, *sample));
    sent_.push_back({index, sample->carried, sample->weight, lit.rays});
  }
}

void SkyShares::trace() {
  if (bounces_) return trace_bounces();
  passed_.resize(rays_.size());
  eye_->scene->rays().transmittance(rays_, passed_);
  for (std::size_t i = 0; i < sent_.size(); ++i)
    lit_[sent_[i].lit].arrived += glm::dvec3(passed_[i]) * glm::dvec3(sent_[i].carried);
  rays_.clear();
  sent_.clear();
}

// What a ray brings takes the place of the sky's share; its sum is of its own, for their spread.
void SkyShares::trace_bounces() {
  sky_rays_.clear();
  for (std::size_t i = 0; i < sent_.size(); ++i) {
    const std::uint64_t seed = lit_[sent_[i].lit].seed;
    const SampleIndex sample{static_cast<int>(seed >> 32), static_cast<int>(seed),
                             static_cast<int>(sent_[i].number)};
    sky_rays_.push_back({rays_[i], sent_[i].weight, sample, i});
  }
  brought_.assign(sent_.size(), glm::dvec3(0.0));
  bounced_.follow(sky_rays_, lights_, brought_, *eye_->counts);
  lights_.trace(brought_, *eye_->counts);
  for (std::size_t i = 0; i < sent_.size(); ++i) {
    Lit& lit = lit_[sent_[i].lit];
    lit.arrived += brought_[i];
    glm::dvec3 off = brought_[i];
    if (lit.open) off -= glm::dvec3(sent_[i].carried);
    const double error = std::min(1.0, (off.x + off.y + off.z) / 3.0);
    lit.error += error;
    lit.error2 += error * error;
  }
  rays_.clear();
  sent_.clear();
}

// Of what one ray brings: as its own rays and its neighbours' tell it.
double SkyShares::spread(const Lit& lit, const Neighbours& neighbours) const {
  const double all = lit.rays + rays_of_neighbours;
  if (bounces_) {
    const double own = lit.error2 - lit.error * lit.error / lit.rays;
    return std::sqrt(std::max(0.0, (own + rays_of_neighbours * neighbours.variance) / all));
  }
  const double seen = (lit.rays * lit.seen() + rays_of_neighbours * neighbours.seen) / all;
  return std::min(1.0, largest(lit.sent) / lit.rays) *
         std::sqrt(std::max(0.0, seen * (1.0 - seen)));
}

// So many that their mean errs by no more than the leaf's weight allows. The error falls with the
// power 3/4 of their number.
std::uint32_t SkyShares::rays_of(const Lit& lit, const Neighbours& neighbours) const {
  if (lit.rays == 0 || (!bounces_ && !(largest(lit.sent) > 0.0))) return 0;
  const double error = eye_->budget.standard_error(shares_[lit.share].weight);
  const double rays = std::pow(spread(lit, neighbours) / error, 4.0 / 3.0);
  return std::bit_ceil(static_cast<std::uint32_t>(std::clamp(rays, 1.0, double{most_rays})));
}

// As one ray more would have it that is half hidden.
SkyShares::Neighbours SkyShares::neighbours() const {
  double rays = 1.0, seen = 0.5, squares = 0.0;
  for (const Lit& lit : lit_) {
    if (lit.rays == 0) continue;
    rays += lit.rays;
    seen += lit.rays * lit.seen();
    squares += lit.error2 - lit.error * lit.error / lit.rays;
  }
  return {seen / rays, squares / rays};
}

std::span<const SkyShares::Share> SkyShares::run() {
  for (std::size_t i = 0; i < lit_.size(); ++i) {
    const auto part = static_cast<std::uint32_t>(first_rays * shares_[lit_[i].share].weight);
    if (held(lit_[i])) send(i, std::bit_ceil(std::max(fewest_rays, part)));
  }
  trace();
  const Neighbours all = neighbours();
  for (std::size_t i = 0; i < lit_.size(); ++i)
    if (held(lit_[i])) send(i, rays_of(lit_[i], all));
  trace();
  for (const Lit& lit : lit_) {
    if (!held(lit)) continue;
    Share& share = shares_[lit.share];
    share.radiance += share.weight * lit.mean();
    share.rays += lit.rays;
  }
  lit_.clear();
  done_.swap(shares_);
  shares_.clear();
  return done_;
}

}  // namespace asos
