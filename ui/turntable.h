#pragma once

#include "ui/orbit_camera.h"

#include <cstdint>
#include <optional>

namespace asos {

/// Circles what the camera looks at, counter-clockwise as seen from above, for as long as it is
/// left alone: whoever moves the camera otherwise stops it. The next step is taken when the picture
/// of the last one has covered the window once, as far on as time has gone. One thread.
class Turntable {
 public:
  static constexpr double fastest = 1.0, slowest = 600.0;
  double seconds_a_turn = 12.0;  ///< from fastest to slowest

  void set_turning(bool turning);
  [[nodiscard]] bool turning() const { return turning_; }

  /// Lets time pass. `covered`: the picture from where the camera is has been seen. Call once or
  /// more a frame.
  void update(OrbitCamera& camera, bool covered, double now_seconds);

 private:
  bool turning_ = false;
  std::optional<std::uint64_t> left_at_;  // the camera's revision after the last step
  double stepped_seconds_ = 0.0;          // when that was
};

}  // namespace asos
