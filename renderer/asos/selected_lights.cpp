#include "renderer/asos/selected_lights.h"

#include "renderer/asos/unshadowed_contributions.h"
#include "renderer/kernels/light_selection.h"
#include "renderer/pyray/tuning.h"

#include <algorithm>
#include <limits>

namespace asos {

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
}

void SelectedLights::find(int side) {
  if (!sought()) return;
  const std::span<const PreparedLight> lights = eye_->viewer.shader.lights();
  UnshadowedContributions contributions(lights);
  RenderStatistics uncounted;
  for (SampleId i = 0; i < static_cast<SampleId>(side * side); ++i) {
    if (!samples_->hit(i).valid()) continue;
    (void)eye_->viewer.shader.radiance(
        eye_->viewer.viewed(samples_->ray(i), samples_->hit(i), eye_->side_of(1.0)), contributions,
        uncounted);
  }
  const std::vector<double> most = contributions.most();
  // Sort the lights that cast shadows, brightest first.
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    if (lights[i].casts_shadows) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return most[a] > most[b]; });
  // Find how many bright lights are worth evaluating one by one.
  double rest = 0.0;
  for (const std::uint32_t i : order) rest += most[i];
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
    rest -= most[order[k]];
  }
  if (strong == order.size()) return;
  sampled_.assign(lights.size(), 0);
  for (std::size_t k = strong; k < order.size(); ++k) sampled_[order[k]] = 1;
}

}  // namespace asos
