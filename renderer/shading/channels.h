#pragma once

#include <glm/glm.hpp>

namespace asos {

/// A texel's four channels, in a register. Operations have the bits of glm::vec4.
using Channels [[gnu::vector_size(16)]] = float;

[[nodiscard]] inline Channels channels_of(glm::vec4 v) {
  return Channels{v.x, v.y, v.z, v.w};
}
[[nodiscard]] inline glm::vec4 vec4_of(Channels v) {
  return {v[0], v[1], v[2], v[3]};
}
[[nodiscard]] inline Channels channels_of(const float* p) {
  return Channels{p[0], p[1], p[2], p[3]};
}
/// As glm::mix.
[[nodiscard]] inline Channels mixed(Channels a, Channels b, float share) {
  return a * (1.0f - share) + b * share;
}

}  // namespace asos
