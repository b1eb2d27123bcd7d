#include "renderer/lights/emitter_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asos {
namespace {

// A bilinear texel is about two wide, so that steps of two miss none.
constexpr double texels_a_step = 2.0;
constexpr int most_steps = 64;
constexpr double most_samples_a_part = 4e6;
// An sRGB byte of 3 beside a white one: what lossy compression makes of black.
constexpr double dark_share = 1e-3;

bool finite(glm::dvec3 v) {
  return std::isfinite(v.x + v.y + v.z);
}

/// The longest edge of a triangle in the texels of a texture; 0 where there is none.
double texels_along(const World& world, const TextureUse& use, glm::uvec3 t) {
  if (!use.used() || use.texcoord < 0 || use.texcoord > 1) return 0.0;
  const int image = world.textures[static_cast<std::size_t>(use.texture)].image;
  const std::vector<glm::vec2>& uv = world.texcoords[use.texcoord];
  if (image < 0 || uv.empty()) return 0.0;
  const Image& texels = world.images[static_cast<std::size_t>(image)];
  const glm::vec2 size(texels.width, texels.height);
  const glm::mat2 transform(use.uv_transform);
  double longest = 0.0;
  for (int k = 0; k < 3; ++k) {
    const glm::vec2 edge = size * (transform * (uv[t[(k + 1) % 3]] - uv[t[k]]));
    const double length = glm::length(glm::dvec2(edge));
    if (std::isfinite(length)) longest = std::max(longest, length);
  }
  return longest;
}

/// Into how many parts a triangle's edges are cut to average its emission.
int steps_of(const World& world, std::uint32_t triangle) {
  const Material& m = world.material_of(triangle);
  const glm::uvec3 t = world.triangles[triangle];
  double texels = texels_along(world, m.emissive_texture, t);
  double least = 1.0;
  if (m.alpha_mode != AlphaMode::opaque) {
    texels = std::max(texels, texels_along(world, m.base_color_texture, t));
    if (!world.colors.empty()) least = 4.0;
  }
  return static_cast<int>(
      std::clamp(std::ceil(texels / texels_a_step), least, static_cast<double>(most_steps)));
}

/// The mean over the centroids of the steps^2 equal triangles that a triangle falls into.
glm::dvec3 mean_emission(const World& world, std::uint32_t triangle, int steps,
                         EmissionAt emission) {
  glm::dvec3 sum(0.0);
  const auto add = [&](double i, double j) {
    sum += glm::dvec3(
        emission(world, triangle, static_cast<float>(i / steps), static_cast<float>(j / steps)));
  };
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; i + j < steps; ++j) {
      add(i + 1.0 / 3.0, j + 1.0 / 3.0);
      if (i + j + 1 < steps) add(i + 2.0 / 3.0, j + 2.0 / 3.0);
    }
  }
  return sum / (static_cast<double>(steps) * steps);
}

double brightest_channel(glm::dvec3 c) {
  return std::max({c.x, c.y, c.z});
}

/// Gives vertices at the same position the same number.
void weld(std::vector<EmitterTriangle>& triangles) {
  std::vector<std::uint32_t> order(3 * triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto position = [&](std::uint32_t i) { return triangles[i / 3].corner[i % 3]; };
  const auto key = [&](std::uint32_t i) {
    const glm::dvec3 p = position(i);
    return std::array{p.x, p.y, p.z};
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && position(order[i]) != position(order[i - 1])) ++number;
    triangles[order[i] / 3].vertex[order[i] % 3] = number;
  }
}

}  // namespace

std::vector<EmitterTriangle> emitting_triangles(const World& world, std::uint32_t part,
                                                EmissionAt emission) {
  const Part& of = world.parts[part];
  std::vector<int> steps(of.triangle_count);
  double samples = 0.0;
  for (std::uint32_t i = 0; i < of.triangle_count; ++i) {
    steps[i] = steps_of(world, of.first_triangle + i);
    samples += static_cast<double>(steps[i]) * steps[i];
  }
  const double fewer = std::min(1.0, std::sqrt(most_samples_a_part / samples));

  std::vector<EmitterTriangle> triangles;
  double brightest = 0.0;
  for (std::uint32_t i = 0; i < of.triangle_count; ++i) {
    EmitterTriangle t;
    const glm::uvec3 v = world.triangles[of.first_triangle + i];
    for (int k = 0; k < 3; ++k) t.corner[static_cast<std::size_t>(k)] = world.positions[v[k]];
    const glm::dvec3 across = glm::cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]);
    const double length = glm::length(across);
    if (!(length > 0.0) || !std::isfinite(length)) continue;
    t.area = 0.5 * length;
    t.normal = across / length;
    const int n = std::max(1, static_cast<int>(fewer * steps[i]));
    t.radiance = mean_emission(world, of.first_triangle + i, n, emission);
    if (!finite(t.radiance)) continue;
    brightest = std::max(brightest, brightest_channel(t.radiance));
    triangles.push_back(t);
  }
  std::erase_if(triangles, [&](const EmitterTriangle& t) {
    return !(brightest_channel(t.radiance) > dark_share * brightest);
  });
  weld(triangles);
  return triangles;
}

}  // namespace asos
