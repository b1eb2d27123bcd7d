#include "renderer/asos/soft_shadows.h"

#include "renderer/asos/light_counts.h"
#include "renderer/pyray/prices.h"
#include "renderer/shadows/penumbra.h"

#include <algorithm>
#include <utility>

namespace asos {

bool soft_shadows(const EyeContext& eye) {
  const auto lights = eye.viewer.shader.lights();
  return eye.settings->shadow.cast &&
         std::any_of(lights.begin(), lights.end(), [](const PreparedLight& light) {
           return light.casts_shadows && light.extended();
         });
}

// Whether it is a light of some size that is asked for its shadows by itself.
bool SoftShadows::casts(std::uint32_t light) const {
  const PreparedLight& asked = eye_->viewer.shader.lights()[light];
  return asked.casts_shadows && asked.extended() && !weak_lights_->holds(light);
}

SoftShadows::Verdict SoftShadows::judge(const SurfacePoint& point, const Patch& patch,
                                        float reflected, int level, double share) {
  const auto lights = eye_->viewer.shader.lights();
  const float tolerance = eye_->budget.penumbra_tolerance(lights.size());
  // Add up the errors of the lights until they exceed the tolerance.
  float error = 0.0f;
  std::vector<std::uint32_t> saturated;
  for (std::uint32_t i = 0; i < lights.size() && !(error > tolerance); ++i) {
    if (!casts(i)) continue;
    const CountForLight count(*eye_->counts, i);
    const Penumbra penumbra = find_penumbra(
        *shadows_, {lights[i], i, point, patch, reflected, level, share}, *eye_->counts);
    error += penumbra.error;
    if (penumbra.saturated) saturated.push_back(i);
  }
  if (error > tolerance) return {error};
  // Note the saturated lights.
  if (saturated.empty()) return {};
  saturated_.push_back(std::move(saturated));
  return {0.0f, static_cast<std::uint32_t>(saturated_.size())};
}

std::span<const std::uint32_t> SoftShadows::saturated(std::uint32_t note) const {
  if (note == 0) return {};
  return saturated_[note - 1];
}

double SoftShadows::price() const {
  double price = 0.0;
  for (std::uint32_t i = 0; i < eye_->viewer.shader.lights().size(); ++i) {
    if (casts(i)) price += Prices::soft_shadow;
  }
  return price;
}

}  // namespace asos
