#pragma once

#include "ui/orbit_camera.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos::ui {

/// Circles the camera's pivot, counter-clockwise seen from above, until the user rotates the
/// camera; dolly and pan do not stop it. A step is taken once the last picture has been displayed
/// for a moment; its angle follows the elapsed time. Not thread-safe.
class Turntable {
 public:
  static constexpr double fastest = 1.0, slowest = 600.0;
  double seconds_a_turn = 12.0;  ///< from fastest to slowest

  void set_turning(bool turning);
  [[nodiscard]] bool turning() const { return turning_; }
  /// Whether it was switched on and no time has passed since.
  [[nodiscard]] bool begins() const { return turning_ && !left_at_; }

  /// Advances the time. `seen`: the picture from the current position has been displayed. Call at
  /// least once a frame.
  void update(OrbitCamera& camera, bool seen, double now_seconds);

 private:
  bool turning_ = false;
  std::optional<glm::dvec3> left_at_;  // view direction after the last step
  double stepped_seconds_ = 0.0;       // when that was
};

}  // namespace asos::ui
