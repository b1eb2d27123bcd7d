#include "renderer/geometry/finite.h"
#include "renderer/geometry/largest.h"
#include "renderer/lights/emitter_mesh.h"
#include "renderer/lights/lit_texels.h"
#include "renderer/load_progress.h"
#include "renderer/work_counts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace asos {
namespace {

// A bilinear texel is about two wide, so steps of two miss none. Edges with few texels need more
// steps, since a border between two texels may be anywhere.
constexpr double texels_a_step = 2.0;
constexpr double steps_a_texel = 4.0;
constexpr double steps_of_few_texels = 16.0;
constexpr int most_steps = 64;
constexpr double most_samples_a_part = 4e6;
// Emission that counts as black: less than an sRGB byte of 13. Lossy compression may make it of
// black next to white.
constexpr double dark_share = 4e-3;
static_assert(LitTexels::black < 13);
// Mean emission below which a triangle counts as black: texels beyond seams, or noise above the
// limit.
constexpr double dark_triangle_share = 1e-3;
// The dimmest triangles that together have this fraction of a part's power are dropped.
constexpr double negligible_share = 5e-3;

/// Returns the longest edge of a triangle in texels of a texture; 0 where there is none.
double texels_along(const World& world, const TextureUse& use, glm::uvec3 t) {
  if (!use.used() || use.texcoord < 0 || use.texcoord > 1) return 0.0;
  const int image = world.textures[static_cast<std::size_t>(use.texture)].image;
  const auto& uv = world.texcoords[use.texcoord];
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

/// Returns the number of parts along a triangle's edges for averaging its emission.
int steps_of(const World& world, std::uint32_t triangle) {
  const Material& m = world.material_of(triangle);
  const glm::uvec3 t = world.triangles[triangle];
  double texels = texels_along(world, m.emissive_texture, t);
  double least = 1.0;
  if (m.alpha_mode != AlphaMode::opaque) {
    texels = std::max(texels, texels_along(world, m.base_color_texture, t));
    if (!world.colors.empty()) least = 4.0;
  }
  const double steps =
      std::max(texels / texels_a_step, std::min(steps_a_texel * texels, steps_of_few_texels));
  return static_cast<int>(std::clamp(std::ceil(steps), least, static_cast<double>(most_steps)));
}

/// Returns the material's emission, in its brightest channel, where its emissive texture is white;
/// 0 without one.
double full_emission(const Material& material) {
  if (!material.emissive_texture.used()) return 0.0;
  return largest(material.emissive) * material.emissive_strength;
}

/// The places of a triangle where its emissive texture is not black.
class LitPlaces {
 public:
  LitPlaces(const World& world, std::uint32_t triangle, const LitTexels& lit) : lit_(lit) {
    const TextureUse& use = world.material_of(triangle).emissive_texture;
    if (!use.used() || use.texcoord < 0 || use.texcoord > 1 || world.is_face(triangle)) return;
    const auto& uv = world.texcoords[use.texcoord];
    if (uv.empty()) return;
    const glm::uvec3 t = world.triangles[triangle];
    known_ = true;
    for (int k = 0; k < 3; ++k) {
      corners_[k] = glm::vec2(use.uv_transform * glm::vec3(uv[t[k]], 1.0f));
      known_ = known_ && std::isfinite(corners_[k].x + corners_[k].y);
    }
  }

  /// Returns false if the texture is black all over the triangle, without a sample.
  [[nodiscard]] bool any() const {
    return !known_ || lit_.any(glm::min(corners_[0], glm::min(corners_[1], corners_[2])),
                               glm::max(corners_[0], glm::max(corners_[1], corners_[2])));
  }
  /// Does so for the part with second and third barycentric coordinates from `low` to `high`.
  [[nodiscard]] bool any(glm::vec2 low, glm::vec2 high) const {
    if (!known_) return true;
    const glm::vec2 a = corners_[1] - corners_[0], b = corners_[2] - corners_[0];
    const glm::vec2 first = corners_[0] + low.x * a + low.y * b, more = high - low;
    const glm::vec2 along_a = more.x * a, along_b = more.y * b;
    return lit_.any(first + glm::min(along_a, 0.0f) + glm::min(along_b, 0.0f),
                    first + glm::max(along_a, 0.0f) + glm::max(along_b, 0.0f));
  }

 private:
  const LitTexels& lit_;
  bool known_ = false;  // which places are black
  glm::vec2 corners_[3]{};
};

/// Returns the mean over the centroids of the steps^2 equal triangles that divide a triangle.
/// Groups of them where the texture is black are not read.
glm::dvec3 mean_emission(const World& world, std::uint32_t triangle, int steps, EmissionAt emission,
                         const LitPlaces& lit) {
  constexpr int group = 4;  // steps
  const double least = dark_share * full_emission(world.material_of(triangle));
  glm::dvec3 sum(0.0);
  std::uint64_t lookups = 0;
  const auto add = [&](double i, double j) {
    const glm::dvec3 at(
        emission(world, triangle, static_cast<float>(i / steps), static_cast<float>(j / steps)));
    ++lookups;
    if (!(largest(at) < least)) sum += at;
  };
  std::array<bool, most_steps / group> black{};
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; i % group == 0 && steps > group && i + j < steps; j += group) {
      const glm::vec2 low(i, j), size(static_cast<float>(steps));
      black[static_cast<std::size_t>(j / group)] =
          !lit.any(low / size, (low + static_cast<float>(group)) / size);
    }
    for (int j = 0; i + j < steps; ++j) {
      if (black[static_cast<std::size_t>(j / group)]) continue;
      add(i + 1.0 / 3.0, j + 1.0 / 3.0);
      if (i + j + 1 < steps) add(i + 2.0 / 3.0, j + 2.0 / 3.0);
    }
  }
  WorkDone::add(Work::emission_lookups, lookups);
  return sum / (static_cast<double>(steps) * steps);
}

/// Drops the dimmest textured triangles, which would become many small lights with almost no power,
/// and gives their power to the others.
void leave_out_dimmest(std::vector<EmitterTriangle>& triangles) {
  std::vector<double> radiance;
  double power = 0.0;
  for (const EmitterTriangle& t : triangles) {
    radiance.push_back(largest(t.radiance));
    power += radiance.back() * t.area;
  }
  std::vector<std::uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return radiance[a] < radiance[b]; });
  double left_out = 0.0;
  double least = 0.0;
  for (const std::uint32_t i : order) {
    if (left_out + radiance[i] * triangles[i].area > negligible_share * power) {
      least = radiance[i];
      break;
    }
    left_out += radiance[i] * triangles[i].area;
  }
  std::erase_if(triangles, [&](const EmitterTriangle& t) { return largest(t.radiance) < least; });
  double kept = 0.0;
  for (const EmitterTriangle& t : triangles) kept += largest(t.radiance) * t.area;
  for (EmitterTriangle& t : triangles) t.radiance *= power / kept;
}

/// Numbers the corners' coordinates along one axis. Values closer to each other than `gap` get the
/// same number, as long as those with one number span at most four gaps.
std::vector<std::uint32_t> numbers_along(const std::vector<EmitterTriangle>& triangles, int axis,
                                         double gap) {
  std::vector<std::pair<double, std::uint32_t>> values;
  values.reserve(3 * triangles.size());
  for (const EmitterTriangle& t : triangles) {
    for (const glm::dvec3& p : t.corner)
      values.emplace_back(p[axis], static_cast<std::uint32_t>(values.size()));
  }
  std::sort(values.begin(), values.end());
  std::vector<std::uint32_t> numbers(values.size());
  std::uint32_t number = 0;
  double first = values.empty() ? 0.0 : values[0].first;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double at = values[i].first;
    if (at - values[i - 1].first > gap || at - first > 4.0 * gap) {
      ++number;
      first = at;
    }
    numbers[values[i].second] = number;
  }
  return numbers;
}

/// Gives vertices at the same position, up to rounding in single precision, the same number.
void weld(std::vector<EmitterTriangle>& triangles) {
  double size = 0.0;
  for (const EmitterTriangle& t : triangles) {
    for (const glm::dvec3& p : t.corner)
      size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  const double gap = 2.0 * std::numeric_limits<float>::epsilon() * size;
  const std::array along{numbers_along(triangles, 0, gap), numbers_along(triangles, 1, gap),
                         numbers_along(triangles, 2, gap)};
  std::vector<std::array<std::uint32_t, 4>> corners;
  corners.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < 3 * triangles.size(); ++i)
    corners.push_back({along[0][i], along[1][i], along[2][i], i});
  std::sort(corners.begin(), corners.end());
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i > 0 && !std::equal(corners[i].begin(), corners[i].begin() + 3, corners[i - 1].begin()))
      ++number;
    triangles[corners[i][3] / 3].vertex[corners[i][3] % 3] = number;
  }
}

}  // namespace

std::vector<EmitterTriangle> emitting_triangles(const World& world, std::uint32_t part,
                                                EmissionAt emission, const LitTexels& lit) {
  const Part& of = world.parts[part];
  std::vector<int> steps(of.triangle_count);
  double samples = 0.0;
  for (std::uint32_t i = 0; i < of.triangle_count; ++i) {
    steps[i] = steps_of(world, of.first_triangle + i);
    samples += static_cast<double>(steps[i]) * steps[i];
  }
  const double fewer = std::min(1.0, std::sqrt(most_samples_a_part / samples));

  const double least = dark_triangle_share * full_emission(world.materials[of.material]);
  std::vector<EmitterTriangle> triangles;
  for (std::uint32_t i = 0; i < of.triangle_count; ++i) {
    stop_point();
    EmitterTriangle t;
    const glm::uvec3 v = world.triangles[of.first_triangle + i];
    for (int k = 0; k < 3; ++k) t.corner[static_cast<std::size_t>(k)] = world.positions[v[k]];
    const glm::dvec3 across = glm::cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]);
    const double length = glm::length(across);
    if (!(length > 0.0) || !std::isfinite(length)) continue;
    t.triangle = of.first_triangle + i;
    t.area = 0.5 * length;
    t.normal = across / length;
    const LitPlaces places(world, t.triangle, lit);
    if (!places.any()) continue;
    const int n = std::max(1, static_cast<int>(fewer * steps[i]));
    t.radiance = mean_emission(world, t.triangle, n, emission, places);
    if (finite(t.radiance) && largest(t.radiance) > least) triangles.push_back(t);
  }
  if (world.materials[of.material].emissive_texture.used()) leave_out_dimmest(triangles);
  weld(triangles);
  return triangles;
}

}  // namespace asos
