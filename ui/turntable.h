#pragma once

#include "ui/orbit_camera.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos::ui {

/// Circles what the camera looks at, counter-clockwise as seen from above, for as long as it is
/// left alone: whoever turns the camera otherwise stops it; moving closer or aside does not. The
/// next step is taken when the picture of the last one has been seen for a moment, as far on as
/// time has gone. One thread.
class Turntable {
 public:
  static constexpr double fastest = 1.0, slowest = 600.0;
  double seconds_a_turn = 12.0;  ///< from fastest to slowest

  void set_turning(bool turning);
  [[nodiscard]] bool turning() const { return turning_; }
  /// Whether it has been switched on and no time has passed since.
  [[nodiscard]] bool begins() const { return turning_ && !left_at_; }

  /// Lets time pass. `seen`: the picture from where the camera is has been. Call once or
  /// more a frame.
  void update(OrbitCamera& camera, bool seen, double now_seconds);

 private:
  bool turning_ = false;
  std::optional<glm::dvec3> left_at_;  // from where the camera looked after the last step
  double stepped_seconds_ = 0.0;       // when that was
};

}  // namespace asos::ui
