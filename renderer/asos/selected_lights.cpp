#include "renderer/asos/selected_lights.h"

#include "renderer/pyray/tuning.h"
#include "renderer/shadows/patch_view.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace asos {
namespace {

/// Collects the points that lights illuminate, and evaluates no light.
class LitPoints final : public LightTransport {
 public:
  explicit LitPoints(UnshadowedContributions& carried) : carried_(&carried) {}

  HandledLights gather(const LightingQuery& point) override {
    carried_->add(point);
    return {{}, true};
  }
  void add(const Illumination& /*lit*/, glm::vec3& /*radiance*/,
           RenderStatistics& /*counts*/) override {}
  bool reflect(const Reflection& /*reflection*/, glm::vec3& /*radiance*/,
               RenderStatistics& /*counts*/) override {
    return true;
  }

 private:
  UnshadowedContributions* carried_;
};

// Returns the number of rays per point for lights with these contributions. No light gets two rays,
// so a few bright lights get fewer in total.
double rays_of_point(std::span<const double> carried) {
  const double all = std::accumulate(carried.begin(), carried.end(), 0.0);
  double rays = 0.0;
  for (const double one : carried)
    if (one > 0.0)
      rays += std::min(1.0, static_cast<double>(ShadowTuning::rays_a_point) * one / all);
  return std::max(1.0, rays);
}

}  // namespace

SelectedLights::SelectedLights(const EyeContext& eye, EyeSamples& samples)
    : eye_(&eye), samples_(&samples), places_(eye.seed), lights_(eye.scene->rays(), places_) {}

// Returns whether light selection may pay off: with many lights, and shadows refined to EPS.
bool SelectedLights::sought() const {
  return eye_->viewer.shader.lights().size() > LightSelection::few_lights &&
         eye_->error_budget.refines() && eye_->settings->shadow.cast &&
         eye_->settings->shadow.quality == ShadowQuality::refined;
}

void SelectedLights::take_all() {
  if (!sought()) return;
  for (const PreparedLight& light : eye_->viewer.shader.lights())
    sampled_.push_back(light.casts_shadows ? 1 : 0);
  expected_ = {1.0, static_cast<double>(ShadowTuning::rays_a_point)};
  lights_.restrict_to(sampled_, ShadowTuning::rays_a_point);
}

void SelectedLights::find(int side) {
  if (!sought()) return;
  const std::span<const PreparedLight> lights = eye_->viewer.shader.lights();
  // Collect the points that the lights illuminate.
  carried_.emplace(lights);
  LitPoints transport(*carried_);
  RenderStatistics uncounted;
  for (SampleId i = 0; i < static_cast<SampleId>(side * side); ++i) {
    if (!samples_->hit(i).valid()) continue;
    (void)eye_->viewer.shader.radiance(
        eye_->viewer.viewed(samples_->ray(i), samples_->hit(i), eye_->side_of(1.0)), transport,
        uncounted);
  }
  const std::vector<double> carried = carried_->most();
  // Sort the lights that cast shadows, brightest first.
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    if (lights[i].casts_shadows) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return carried[a] > carried[b]; });
  // Find how many bright lights are worth evaluating one by one.
  double rest = 0.0;
  for (const std::uint32_t i : order) rest += carried[i];
  double asked = 0.0;
  double least = std::numeric_limits<double>::infinity();
  std::size_t strong = 0;
  for (std::size_t k = 0; k <= order.size(); ++k) {
    const double cost = asked + eye_->error_budget.samples(1.0, std::max(rest, 0.0));
    if (cost < least) {
      least = cost;
      strong = k;
    }
    if (k == order.size()) break;
    asked += lights[order[k]].extended() ? LeafCosts::light_view : LeafCosts::patch;
    rest -= carried[order[k]];
  }
  if (strong == order.size()) return;
  sampled_.assign(lights.size(), 0);
  for (std::size_t k = strong; k < order.size(); ++k) sampled_[order[k]] = 1;
  expected_ = expected(carried);
  lights_.restrict_to(sampled_, ShadowTuning::rays_a_point);
}

SelectedLights::Expected SelectedLights::expected(std::span<const double> carried) const {
  std::vector<double> of_sampled;
  for (std::size_t i = 0; i < carried.size(); ++i)
    if (sampled_[i] != 0) of_sampled.push_back(carried[i]);
  const double all = std::accumulate(of_sampled.begin(), of_sampled.end(), 0.0);
  return {std::clamp(all, 0.0, 1.0), rays_of_point(of_sampled)};
}

// Sampled lights may be far brighter at a leaf than at any pixel's centre.
SelectedLights::Expected SelectedLights::expected_at(const LightingQuery& point) {
  if (expected_.intensity >= 1.0) return expected_;
  carried_->start();
  carried_->add(point);
  const Expected here = expected(carried_->most());
  return here.intensity > expected_.intensity ? here : expected_;
}

std::uint32_t SelectedLights::start(const Leaf& leaf) {
  if (queue_.empty()) sums_.clear();
  sums_.emplace_back(0.0);
  return queue_.add(leaf);
}

// Returns the number of points whose rays reach the accuracy that the leaf's weight needs.
std::uint32_t SelectedLights::points_of(double weight, const Expected& expected) const {
  const double rays = eye_->error_budget.samples(weight, expected.intensity);
  return std::bit_ceil(
      static_cast<std::uint32_t>(std::clamp(std::ceil(rays / expected.rays_of_point), 1.0,
                                            static_cast<double>(ShadowTuning::most_points))));
}

// Finds the leaf's points and the surfaces there.
void SelectedLights::look(const LightingQuery& lit, const Leaf& leaf, std::uint32_t count) {
  const SurfacePoint& point = lit.view.point;
  at_.clear();
  number_.clear();
  seen_.clear();
  if (count > 1) {
    const Bounds2 box = bounds_of(leaf.region);
    for (std::uint32_t i = 0; i < count; ++i) {
      places_.start_sample(static_cast<int>(i));
      const PixelPoint p = places_.in_pixel();
      const glm::vec2 at = glm::mix(box.lo, box.hi, glm::vec2(p.x, p.y));
      if (!leaf.region.holds(at)) continue;
      at_.push_back(at);
      number_.push_back(i);
    }
    // Points lie on the plane of the leaf, or on its surface where that is curved.
    const FeatureSet& features = eye_->scene->features();
    if (features.deviation(point.triangle) <= 0.0f) {
      const HalfSpace plane =
          HalfSpace::through(glm::dvec3(point.position), glm::dvec3(point.geometric_normal));
      for (const glm::vec2 at : at_) {
        seen_.push_back(point);
        if (const auto there = eye_->frame->on_plane(glm::dvec2(at), plane))
          seen_.back().position = glm::vec3(*there);
      }
    } else {
      samples_->look(at_, seen_, *eye_->counts);
      for (SurfacePoint& there : seen_) {
        if (there.triangle == Hit::none ||
            features.smooth_surface(there.triangle) != features.smooth_surface(point.triangle))
          there = point;
      }
    }
  }
  if (seen_.empty()) {
    seen_.push_back(point);
    number_.assign(1, 0);
  }
}

void SelectedLights::add(std::uint32_t number, const LightingQuery& lit, const Leaf& leaf) {
  const auto x = static_cast<int>(leaf.seed >> 32), y = static_cast<int>(leaf.seed);
  places_.start_pixel(x, y);
  look(lit, leaf, leaf.region.marginal ? 1 : points_of(leaf.weight, expected_at(lit)));
  const glm::vec3 weight(static_cast<float>(leaf.weight) / static_cast<float>(seen_.size()));
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    ViewedPoint view{seen_[k], lit.view.to_viewer, lit.view.n_dot_v, lit.view.patch,
                     lit.view.distance};
    places_.start_sample(static_cast<int>(number_[k]));
    (void)lights_.gather({lit.lights, view, lit.material, lit.mirrored, lit.share, lit.shadows},
                         {x, y, static_cast<int>(number_[k])}, {{number}, weight});
  }
}

glm::vec3 SelectedLights::at_once(const LightingQuery& point, const Leaf& leaf) {
  add(start(leaf), point, leaf);
  return glm::vec3(run().front().radiance / leaf.weight);
}

std::span<const Contribution> SelectedLights::run() {
  const std::uint64_t before = eye_->counts->rays();
  lights_.trace(sums_, *eye_->counts);
  for (std::uint32_t i = 0; i < queue_.size(); ++i) queue_[i].radiance = sums_[i];
  queue_.share_rays(static_cast<double>(eye_->counts->rays() - before),
                    std::vector<double>(queue_.size(), 1.0));
  return queue_.take();
}

}  // namespace asos
