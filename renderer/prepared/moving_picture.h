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
  /// `scene` has an exposure that moves. `camera` is the picture's viewed_camera (method.h).
  MovingPicture(const RenderScene& scene, const Camera& camera, const RenderSettings& settings);

  /// Returns the number of steps between moments 0 and `steps`; even.
  [[nodiscard]] int steps() const { return exposure_->steps(); }
  [[nodiscard]] const RenderScene& scene(int moment) const {
    return *exposure_->moments[static_cast<std::size_t>(moment)];
  }
  [[nodiscard]] const View& view(int moment) const {
    return views_[static_cast<std::size_t>(moment)];
  }
  /// Returns the moment nearest to a time, 0 to 1 from the shutter's opening to its closing. The
  /// first and the last moment thus have half the weight of the others.
  [[nodiscard]] int moment_at(double time) const;
  /// Returns whether the camera moves while the shutter is open.
  [[nodiscard]] bool camera_moves() const { return camera_moves_; }
  /// Returns the rays at any time; null: see MovingRays.
  [[nodiscard]] const RayScene* rays() const { return exposure_->rays->get(); }

  /// Returns whether a moving surface may cross a block of pixels from one moment to another.
  /// Conservative; ignores shadows and reflections.
  [[nodiscard]] bool crosses(const PixelRect& block, int first, int last) const;
  /// Returns about how far a visible vertex moves at most in between, in pixels.
  [[nodiscard]] double way(int first, int last) const {
    return exposure_->step_pixels * (last - first);
  }

 private:
  void mark(int step, const RenderScene& before, const RenderScene& after);
  void mark_all(int step);
  void mark_box(int step, glm::dvec2 lo, glm::dvec2 hi);

  const Exposure* exposure_;
  std::vector<View> views_;
  bool camera_moves_ = false;
  double margin_;  // of filters, in pixels
  int tile_;       // side of the tiles below, in pixels
  int columns_, rows_;
  std::vector<std::uint8_t> crossed_;  // tiles of each step
};

}  // namespace asos
