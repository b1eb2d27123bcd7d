#include "ui/turntable.h"

#include <algorithm>
#include <numbers>

namespace asos::ui {

namespace {

glm::dvec3 back_of(const OrbitCamera& camera) {
  return glm::dvec3(camera.camera().world_from_camera[2]);
}

}  // namespace

void Turntable::set_turning(bool turning) {
  turning_ = turning;
  left_at_.reset();
}

void Turntable::update(OrbitCamera& camera, bool seen, double now_seconds) {
  if (!turning_) return;
  if (!left_at_) {
    left_at_ = back_of(camera);
    stepped_seconds_ = now_seconds;
  }
  if (back_of(camera) != *left_at_) {
    set_turning(false);
    return;
  }
  if (!seen || now_seconds <= stepped_seconds_) return;
  const double turns =
      (now_seconds - stepped_seconds_) / std::clamp(seconds_a_turn, fastest, slowest);
  camera.orbit(2.0 * std::numbers::pi * turns, 0.0);
  left_at_ = back_of(camera);
  stepped_seconds_ = now_seconds;
}

}  // namespace asos::ui
