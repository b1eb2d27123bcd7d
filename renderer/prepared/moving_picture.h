#pragma once

#include "renderer/geometry/pixel_rect.h"
#include "renderer/geometry/view.h"
#include "renderer/prepared/exposure.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// An exposure as a camera sees it: the scene and the view at each of its moments, and where
/// something moves in the picture. Immutable; the scene has to outlive it.
class MovingPicture {
 public:
  /// `scene` has an exposure that moves. `camera`: the picture's, as its method sees through it.
  MovingPicture(const RenderScene& scene, const Camera& camera, const RenderSettings& settings);

  /// Steps between the moments 0 to `steps`, an even number.
  [[nodiscard]] int steps() const { return exposure_->steps(); }
  [[nodiscard]] const RenderScene& scene(int moment) const {
    return *exposure_->moments[static_cast<std::size_t>(moment)];
  }
  [[nodiscard]] const View& view(int moment) const {
    return views_[static_cast<std::size_t>(moment)];
  }
  /// The moment that a time stands for, 0 to 1 from the shutter's opening to its closing: the
  /// nearest one, so that the first and the last have half the weight of the others.
  [[nodiscard]] int moment_at(double time) const;

  /// Whether a moving surface may cross a block of pixels from one moment to another. Conservative;
  /// ignores shadows and reflections.
  [[nodiscard]] bool crosses(const PixelRect& block, int first, int last) const;
  /// The farthest that a visible vertex moves meanwhile, in pixels, about.
  [[nodiscard]] double way(int first, int last) const {
    return exposure_->step_pixels * (last - first);
  }

 private:
  void mark(int step, const RenderScene& before, const RenderScene& after);
  void mark_all(int step);
  void mark_box(int step, glm::dvec2 lo, glm::dvec2 hi);

  const Exposure* exposure_;
  std::vector<View> views_;
  double margin_;  // of filters, in pixels
  int tile_;       // side of the tiles below, in pixels
  int columns_, rows_;
  std::vector<std::uint8_t> crossed_;  // tiles of each step
};

}  // namespace asos
