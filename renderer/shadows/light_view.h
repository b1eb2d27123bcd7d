#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// A leaf's view of a light of some size.
struct LightView {
  std::uint32_t light = 0;
  /// Bound on what the edges of the light's shadow make the leaf's centre differ from its mean, in
  /// display intensity.
  double penumbra = 0.0;
  /// Too many boundaries lie between for anything but rays.
  bool saturated = false;
};

/// A leaf's view of the lights, found once, when its estimator is chosen: only what is worth
/// noting, lights in ascending order.
class LightViews {
 public:
  void clear() { views_.clear(); }
  /// `view`: of another light than before.
  void add(const LightView& view) {
    if (view.penumbra > 0.0 || view.saturated) views_.push_back(view);
  }
  [[nodiscard]] bool empty() const { return views_.empty(); }
  /// The view of a light; by default nothing lies between.
  [[nodiscard]] LightView of(std::uint32_t light) const {
    const auto found = std::find_if(views_.begin(), views_.end(),
                                    [&](const LightView& view) { return view.light == light; });
    return found != views_.end() ? *found : LightView{light};
  }

 private:
  std::vector<LightView> views_;
};

}  // namespace asos
