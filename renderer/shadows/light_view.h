#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// A leaf's view of an extended light.
struct LightView {
  std::uint32_t light = 0;
  /// There are so many boundaries in between that only rays are useful.
  bool too_detailed = false;
};

/// A leaf's views of the lights, computed once when its estimator is chosen. Stores only views that
/// are not the default, with lights in ascending order.
class LightViews {
 public:
  void clear() { views_.clear(); }
  /// `view` must be of a light that was not added before.
  void add(const LightView& view) {
    if (view.too_detailed) views_.push_back(view);
  }
  [[nodiscard]] bool empty() const { return views_.empty(); }
  /// Returns the view of a light; if none was added, the default without boundaries.
  [[nodiscard]] LightView of(std::uint32_t light) const {
    const auto found = std::find_if(views_.begin(), views_.end(),
                                    [&](const LightView& view) { return view.light == light; });
    return found != views_.end() ? *found : LightView{light};
  }

 private:
  std::vector<LightView> views_;
};

}  // namespace asos
