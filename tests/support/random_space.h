#pragma once

#include "renderer/lights/receiver.h"

#include <glm/glm.hpp>

#include <cmath>
#include <random>

namespace asos::test {

/// Seeded numbers, directions and receivers, which are the same in every run and with every
/// standard library.
class RandomSpace {
 public:
  explicit RandomSpace(std::uint64_t seed) : engine_(seed) {}

  [[nodiscard]] double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  [[nodiscard]] glm::dvec3 direction() {
    for (;;) {
      const glm::dvec3 p(between(-1, 1), between(-1, 1), between(-1, 1));
      const double length = glm::length(p);
      if (length < 1.0 && length > 0.1) return p / length;
    }
  }
  [[nodiscard]] glm::dvec3 perpendicular(glm::dvec3 axis) {
    for (;;) {
      const glm::dvec3 across = glm::cross(axis, direction());
      if (glm::length(across) > 0.1) return glm::normalize(across);
    }
  }
  /// A receiver at `position`, with `target` above it, anywhere, or near its horizon (by `kind` %
  /// 3). Its two horizons are equal, different, closer than float precision, or the target is near
  /// the second one, too (by `kind` / 3 % 4).
  [[nodiscard]] Receiver receiver(glm::dvec3 position, glm::dvec3 target, int kind) {
    const glm::dvec3 axis = glm::normalize(target - position);
    Receiver receiver;
    receiver.position = position;
    if (kind % 3 == 0) receiver.normal = glm::normalize(axis + between(0.0, 0.9) * direction());
    if (kind % 3 == 1) receiver.normal = direction();
    if (kind % 3 == 2) receiver.normal = near_right_angle(axis, 0.3);
    receiver.geometric = receiver.normal;
    switch (kind / 3 % 4) {
      case 1:
        receiver.geometric = glm::normalize(receiver.normal + 0.7 * direction());
        break;
      case 2:
        receiver.geometric = glm::normalize(receiver.normal + between(0.0, 1e-7) * direction());
        break;
      case 3:
        receiver.geometric = near_right_angle(axis, 0.1);
        break;
      default:
        break;
    }
    return receiver;
  }

 private:
  glm::dvec3 near_right_angle(glm::dvec3 axis, double most) {
    return glm::normalize(perpendicular(axis) + between(-most, most) * axis);
  }

  std::mt19937_64 engine_;
};

}  // namespace asos::test
