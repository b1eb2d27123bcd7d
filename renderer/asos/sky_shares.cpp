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
    Ray& ray = rays_.emplace_back();
    ray.direction = sample->direction;
    ray.origin = spawn_origin(lit.point, ray.direction);
    sent_.push_back({index, sample->carried});
  }
}

void SkyShares::trace() {
  passed_.resize(rays_.size());
  eye_->scene->rays().transmittance(rays_, passed_);
  for (std::size_t i = 0; i < sent_.size(); ++i)
    lit_[sent_[i].lit].arrived += static_cast<double>(passed_[i]) * glm::dvec3(sent_[i].carried);
  rays_.clear();
  sent_.clear();
}

// So many that their mean errs by no more than the leaf's weight allows: by the share of the sky
// that is seen, as its own rays and its neighbours' tell it. The error falls with the power 3/4 of
// their number.
std::uint32_t SkyShares::rays_of(const Lit& lit, double seen_by_all) const {
  const double sent = largest(lit.sent);
  if (!(sent > 0.0)) return 0;
  const double seen =
      (lit.rays * lit.seen() + rays_of_neighbours * seen_by_all) / (lit.rays + rays_of_neighbours);
  const double spread = std::sqrt(std::max(0.0, seen * (1.0 - seen)));
  const double error = eye_->budget.standard_error(shares_[lit.share].weight);
  const double off = std::min(1.0, sent / lit.rays) * spread / error;
  const double rays = std::pow(off, 4.0 / 3.0);
  return std::bit_ceil(static_cast<std::uint32_t>(std::clamp(rays, 1.0, double{most_rays})));
}

// As one ray more would have it that is half hidden.
double SkyShares::seen_by_all() const {
  double rays = 1.0, seen = 0.5;
  for (const Lit& lit : lit_) {
    rays += lit.rays;
    seen += lit.rays * lit.seen();
  }
  return seen / rays;
}

std::span<const SkyShares::Share> SkyShares::run() {
  for (std::size_t i = 0; i < lit_.size(); ++i) {
    const auto part = static_cast<std::uint32_t>(first_rays * shares_[lit_[i].share].weight);
    if (held(lit_[i])) send(i, std::bit_ceil(std::max(fewest_rays, part)));
  }
  trace();
  const double seen = seen_by_all();
  for (std::size_t i = 0; i < lit_.size(); ++i)
    if (held(lit_[i])) send(i, rays_of(lit_[i], seen));
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
