#pragma once

#include "renderer/lights/light_math.h"
#include "renderer/sampling/random.h"
#include "renderer/shading/dfr.h"
#include "renderer/shading/sky.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

// Skies, and their means by sums over many directions.

namespace asos::test::sky_sums {

using Radiance = std::function<double(glm::dvec3)>;

inline glm::dvec3 direction_of(double u, double v) {
  const double angle = 2.0 * std::numbers::pi * (u - 0.5);
  return {std::sin(std::numbers::pi * v) * std::sin(angle), std::cos(std::numbers::pi * v),
          -std::sin(std::numbers::pi * v) * std::cos(angle)};
}

inline SkyMap map_of(int height, const Radiance& radiance) {
  std::vector<glm::vec3> texels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < 2 * height; ++x)
      texels.emplace_back(
          static_cast<float>(radiance(direction_of((x + 0.5) / (2 * height), (y + 0.5) / height))));
  return {2 * height, height, std::move(texels)};
}

inline SkyMap noise_map(int height) {
  std::uint64_t bits = 1;
  return map_of(height, [&](glm::dvec3) { return unit_pair(bits = mix_bits(bits)).u; });
}

struct Patch3 {
  glm::vec3 direction;
  glm::vec3 right;
  glm::vec3 down;
};

/// A random patch, every fourth across a pole, with sides from 1/4 to 1 of `size`.
inline Patch3 random_patch(int index, double size) {
  const auto r = [&](int k) { return unit_pair(pixel_random(index, k, 7)); };
  const double v =
      index % 4 == 0 ? 0.1 * size * r(0).u : std::acos(1.0 - 2.0 * r(0).u) / std::numbers::pi;
  const glm::dvec3 d = direction_of(r(0).v, v);
  const glm::dvec3 a =
      glm::normalize(glm::cross(d, glm::dvec3(r(1).u - 0.5, r(1).v - 0.5, r(2).u - 0.5)));
  return {d, (0.25 + 0.75 * r(2).v) * size * a, (0.25 + 0.75 * r(3).u) * size * glm::cross(d, a)};
}

inline double brute_force(const Radiance& radiance, const Patch3& patch) {
  constexpr int n = 64;
  double sum = 0.0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      sum += radiance(glm::normalize(glm::dvec3(patch.direction) +
                                     ((i + 0.5) / n - 0.5) * glm::dvec3(patch.right) +
                                     ((j + 0.5) / n - 0.5) * glm::dvec3(patch.down)));
  return sum / (n * n);
}

/// Returns the roughness of a lobe of this width.
inline float roughness_of(float width) {
  return std::sqrt(width / static_cast<float>(lobe_width(1.0)));
}

inline double mean_of(const Sky& sky, const Patch3& patch) {
  return static_cast<double>(sky.radiance(patch.direction, patch.right, patch.down).g);
}

/// Irradiance of a surface under the sky, divided by pi.
inline double irradiance(const Radiance& radiance, glm::dvec3 normal) {
  constexpr int n = 400;
  double sum = 0.0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < 2 * n; ++i) {
      const double v = (j + 0.5) / n;
      const glm::dvec3 d = direction_of((i + 0.5) / (2 * n), v);
      sum += radiance(d) * std::max(0.0, glm::dot(d, normal)) * std::sin(std::numbers::pi * v);
    }
  }
  return sum * (std::numbers::pi / n) * (std::numbers::pi / n) / std::numbers::pi;
}

}  // namespace asos::test::sky_sums
