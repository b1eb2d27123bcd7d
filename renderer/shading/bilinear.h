#pragma once

#include "renderer/scene/scene.h"
#include "renderer/shading/channels.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

// Lookups in one level of a texture. A level has `width`, `height` and `at(x, y)`, a glm::vec4.

namespace asos {

/// std::floor for results that fit an integer. Without SSE 4.1, std::floor is a function call.
inline float floor_near(float x) {
  if (!(std::abs(x) < 8388608.0f)) return std::floor(x);
  const auto whole = static_cast<float>(static_cast<int>(x));
  return whole > x ? whole - 1.0f : whole;
}

/// Wraps a coordinate to [0, 1]. This comes before the scaling to texels, so that no coordinate
/// overflows an integer.
inline float wrapped(float x, Wrap wrap) {
  if (!std::isfinite(x)) return 0.0f;
  switch (wrap) {
    case Wrap::repeat:
      return x - floor_near(x);
    case Wrap::mirrored_repeat: {
      const float t = x - 2.0f * floor_near(0.5f * x);  // 0 to 2
      return t <= 1.0f ? t : 2.0f - t;
    }
    case Wrap::clamp_to_edge:
      break;
  }
  return std::clamp(x, 0.0f, 1.0f);
}

/// Wraps a texel's index that lies at most one step outside 0..size-1, as bilinear neighbours do.
inline int wrapped_neighbour(int i, int size, Wrap wrap) {
  if (i >= 0 && i < size) return i;
  if (wrap == Wrap::repeat) return i < 0 ? size - 1 : 0;
  return i < 0 ? 0 : size - 1;  // mirroring repeats the edge texel
}

template <typename Level>
glm::vec4 nearest(const Level& level, glm::vec2 uv, Wrap wrap_u, Wrap wrap_v) {
  const float x = wrapped(uv.x, wrap_u) * static_cast<float>(level.width);
  const float y = wrapped(uv.y, wrap_v) * static_cast<float>(level.height);
  return level.at(std::min(static_cast<int>(x), level.width - 1),
                  std::min(static_cast<int>(y), level.height - 1));
}

/// The four texels around a place, and the place's fractions between them.
struct BilinearTexels {
  int left, right, top, bottom;
  float fx, fy;

  BilinearTexels(int width, int height, glm::vec2 uv, Wrap wrap_u, Wrap wrap_v) {
    // Texel centres lie at half integers.
    const float x = wrapped(uv.x, wrap_u) * static_cast<float>(width) - 0.5f;
    const float y = wrapped(uv.y, wrap_v) * static_cast<float>(height) - 0.5f;
    const float x0 = floor_near(x);
    const float y0 = floor_near(y);
    fx = x - x0;
    fy = y - y0;
    left = wrapped_neighbour(static_cast<int>(x0), width, wrap_u);
    right = wrapped_neighbour(static_cast<int>(x0) + 1, width, wrap_u);
    top = wrapped_neighbour(static_cast<int>(y0), height, wrap_v);
    bottom = wrapped_neighbour(static_cast<int>(y0) + 1, height, wrap_v);
  }
};

/// Returns the bilinear value of a level whose `at` returns Channels.
template <typename Level>
Channels bilinear_channels(const Level& level, glm::vec2 uv, Wrap wrap_u, Wrap wrap_v) {
  const BilinearTexels p(level.width, level.height, uv, wrap_u, wrap_v);
  return mixed(mixed(level.at(p.left, p.top), level.at(p.right, p.top), p.fx),
               mixed(level.at(p.left, p.bottom), level.at(p.right, p.bottom), p.fx), p.fy);
}
template <typename Level>
glm::vec4 bilinear(const Level& level, glm::vec2 uv, Wrap wrap_u, Wrap wrap_v) {
  const BilinearTexels p(level.width, level.height, uv, wrap_u, wrap_v);
  const auto at = [&](int x, int y) { return channels_of(level.at(x, y)); };
  return vec4_of(mixed(mixed(at(p.left, p.top), at(p.right, p.top), p.fx),
                       mixed(at(p.left, p.bottom), at(p.right, p.bottom), p.fx), p.fy));
}

/// Decodes a normal map's unsigned value to a unit direction; 0 where it has none.
inline glm::vec3 unit_normal(glm::vec4 texel) {
  const glm::vec3 n = 2.0f * glm::vec3(texel) - 1.0f;
  const float length = glm::length(n);
  return length > 0.0f ? n / length : n;
}

}  // namespace asos
