#include "ui/turntable.h"

#include <algorithm>
#include <numbers>

namespace asos {

void Turntable::set_turning(bool turning) {
  turning_ = turning;
  left_at_.reset();
}

void Turntable::update(OrbitCamera& camera, bool covered, double now_seconds) {
  if (!turning_) return;
  if (!left_at_) {
    left_at_ = camera.revision();
    stepped_seconds_ = now_seconds;
  }
  if (camera.revision() != *left_at_) {
    set_turning(false);
    return;
  }
  if (!covered || now_seconds <= stepped_seconds_) return;
  const double turns =
      (now_seconds - stepped_seconds_) / std::clamp(seconds_a_turn, fastest, slowest);
  camera.orbit(2.0 * std::numbers::pi * turns, 0.0);
  left_at_ = camera.revision();
  stepped_seconds_ = now_seconds;
}

}  // namespace asos
