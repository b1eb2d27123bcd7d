#include "renderer/lights/textured_emitter.h"

#include "renderer/geometry/finite.h"
#include "renderer/geometry/largest.h"
#include "renderer/lights/light_math.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/work_counts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace asos {
namespace {

// Squares along each side of a light's rectangle, and samples along each side of a square.
constexpr int squares = 64;
constexpr int samples = 3;
// A light with more triangles is not divided.
constexpr std::size_t most_triangles_painted = 256;
// Corners of the polygon that replaces a disk.
constexpr int corners_of_disk = 32;
// Emission that varies by less than this fraction of its mean square is even.
constexpr double even_share = 1e-3;
// A block with less than this fraction of the power gives no light.
constexpr double negligible_power = 1e-4;
// Neither does a block with less than this fraction inside the outline.
constexpr double smallest_part = 1e-6;

/// A part of a light's rectangle: the squares from `begin` up to, but not including, `end`.
struct Block {
  std::array<int, 2> begin{0, 0};
  std::array<int, 2> end{squares, squares};

  bool operator==(const Block&) const = default;
};

/// Sums over squares.
struct EmissionSums {
  double weight = 0.0;  ///< of the part on triangles
  glm::dvec3 radiance{0.0};
  double square = 0.0;

  EmissionSums& operator+=(const EmissionSums& o) {
    weight += o.weight, radiance += o.radiance, square += o.square;
    return *this;
  }
  EmissionSums& operator-=(const EmissionSums& o) {
    weight -= o.weight, radiance -= o.radiance, square -= o.square;
    return *this;
  }
  /// Returns the sum of the squared deviations from the mean.
  [[nodiscard]] double left() const {
    return weight > 0.0 ? std::max(0.0, square - glm::dot(radiance, radiance) / weight) : 0.0;
  }
};

/// The bounding rectangle of a flat light.
struct PaintedFrame {
  glm::dvec3 position{0.0}, half_u{1, 0, 0}, half_v{0, 1, 0};

  /// Returns coordinates from -1 to 1 inside.
  [[nodiscard]] glm::dvec2 place_of(glm::dvec3 p) const {
    const glm::dvec3 from = p - position;
    return {glm::dot(from, half_u) / glm::dot(half_u, half_u),
            glm::dot(from, half_v) / glm::dot(half_v, half_v)};
  }
  [[nodiscard]] glm::dvec3 at(glm::dvec2 p) const { return position + p.x * half_u + p.y * half_v; }
};

/// A triangle in a frame's coordinates.
class PlacedTriangle {
 public:
  PlacedTriangle(const World& world, std::uint32_t triangle, const PaintedFrame& frame)
      : triangle_(triangle) {
    const glm::uvec3 t = world.triangles[triangle];
    std::array<glm::dvec2, 3> p;
    for (int k = 0; k < 3; ++k)
      p[static_cast<std::size_t>(k)] = frame.place_of(glm::dvec3(world.positions[t[k]]));
    corner_ = p[0], first_ = p[1] - p[0], second_ = p[2] - p[0];
    area_ = first_.x * second_.y - first_.y * second_.x;
  }

  /// Returns the weights of its second and third corner at a place inside.
  [[nodiscard]] std::optional<glm::dvec2> holds(glm::dvec2 at) const {
    const glm::dvec2 d = at - corner_;
    const double b1 = (d.x * second_.y - d.y * second_.x) / area_;
    const double b2 = (first_.x * d.y - first_.y * d.x) / area_;
    constexpr double slack = -1e-9;
    if (!(b1 >= slack && b2 >= slack && b1 + b2 <= 1.0 - slack)) return std::nullopt;
    return glm::dvec2(b1, b2);
  }
  [[nodiscard]] std::uint32_t triangle() const { return triangle_; }

 private:
  std::uint32_t triangle_;
  glm::dvec2 corner_, first_, second_;
  double area_;
};

/// A summed-area table of the emission of a light's rectangle.
class EmissionTable {
 public:
  EmissionTable() = default;
  EmissionTable(const World& world, EmissionAt emission, std::span<const PlacedTriangle> triangles)
      : sums_(static_cast<std::size_t>(squares + 1) * (squares + 1)) {
    for (int y = 0; y < squares; ++y) {
      for (int x = 0; x < squares; ++x) {
        EmissionSums sum = square(world, emission, triangles, x, y);
        sum += at(x, y + 1);
        sum += at(x + 1, y);
        sum -= at(x, y);
        sums_[index(x + 1, y + 1)] = sum;
      }
    }
  }

  [[nodiscard]] EmissionSums of(const Block& b) const {
    EmissionSums sum = at(b.end[0], b.end[1]);
    sum -= at(b.begin[0], b.end[1]);
    sum -= at(b.end[0], b.begin[1]);
    sum += at(b.begin[0], b.begin[1]);
    return sum;
  }

 private:
  [[nodiscard]] static std::size_t index(int x, int y) {
    return static_cast<std::size_t>(y) * (squares + 1) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] const EmissionSums& at(int x, int y) const { return sums_[index(x, y)]; }

  static EmissionSums square(const World& world, EmissionAt emission,
                             std::span<const PlacedTriangle> triangles, int x, int y) {
    EmissionSums sum;
    constexpr int all = squares * samples;
    for (int j = 0; j < samples; ++j) {
      for (int i = 0; i < samples; ++i) {
        const glm::dvec2 place(2.0 * (x * samples + i + 0.5) / all - 1.0,
                               2.0 * (y * samples + j + 0.5) / all - 1.0);
        for (const PlacedTriangle& t : triangles) {
          const auto weights = t.holds(place);
          if (!weights) continue;
          const glm::vec2 b(*weights);
          WorkDone::add(Work::emission_lookups);
          const glm::dvec3 radiance(emission(world, t.triangle(), b.x, b.y));
          if (finite(radiance)) sum += {1.0, radiance, glm::dot(radiance, radiance)};
          break;
        }
      }
    }
    return sum;
  }

  std::vector<EmissionSums> sums_;
};

/// The cut of a block with the least variance.
struct Cut {
  Block first, second;
  double saved = 0.0;
};

Cut best_cut(const EmissionTable& table, const Block& block) {
  Cut best;
  const double whole = table.of(block).left();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (int at = block.begin[axis] + 1; at < block.end[axis]; ++at) {
      Block first = block, second = block;
      first.end[axis] = second.begin[axis] = at;
      const double saved = whole - table.of(first).left() - table.of(second).left();
      if (saved > best.saved) best = {first, second, saved};
    }
  }
  return best;
}

/// Returns the direction in a triangle's plane in which its texture changes across columns; 0:
/// none.
glm::dvec3 texture_axis(const World& world, std::uint32_t triangle) {
  const Material& m = world.material_of(triangle);
  const TextureUse& use = m.emissive_texture.used() ? m.emissive_texture : m.base_color_texture;
  if (!use.used() || use.texcoord < 0 || use.texcoord > 1) return glm::dvec3(0.0);
  const Attribute<glm::vec2>& uv = world.texcoords[use.texcoord];
  if (uv.empty()) return glm::dvec3(0.0);
  const glm::uvec3 t = world.triangles[triangle];
  const glm::mat2 transform(use.uv_transform);
  const auto column = [&](int k) {
    return static_cast<double>((transform * (uv[t[k]] - uv[t[0]])).x);
  };
  const glm::dvec3 first = glm::dvec3(world.positions[t[1]]) - glm::dvec3(world.positions[t[0]]);
  const glm::dvec3 second = glm::dvec3(world.positions[t[2]]) - glm::dvec3(world.positions[t[0]]);
  const glm::dvec3 normal = glm::cross(first, second);
  const glm::dvec3 axis =
      column(1) * glm::cross(second, normal) + column(2) * glm::cross(normal, first);
  const double length = glm::length(axis);
  return length > 0.0 && std::isfinite(length) ? axis / length : glm::dvec3(0.0);
}

/// Returns the outline of a polygon or a disk; empty for a rectangle.
std::vector<glm::dvec3> outline_of(const Light& light) {
  if (light.type == Light::Type::polygon) return light.outlines.front();
  if (light.type != Light::Type::disk) return {};
  constexpr double step = 2.0 * std::numbers::pi / corners_of_disk;
  const double radius = light.radius * std::sqrt(step / std::sin(step));
  const glm::dvec3 x = any_perpendicular(light.direction), y = glm::cross(light.direction, x);
  std::vector<glm::dvec3> outline;
  for (int k = 0; k < corners_of_disk; ++k)
    outline.push_back(light.position + radius * (std::cos(k * step) * x + std::sin(k * step) * y));
  return outline;
}

/// Returns the bounding rectangle of an outline, along its texture if it has one.
PaintedFrame frame_of(const Light& light, std::span<const glm::dvec3> outline, glm::dvec3 axis) {
  if (outline.empty()) return {light.position, light.half_u, light.half_v};
  const glm::dvec3 normal = glm::normalize(light.direction);
  axis -= glm::dot(axis, normal) * normal;
  if (!(glm::length(axis) > 0.5)) axis = prepare_light(light).half_u;
  const glm::dvec3 x = glm::normalize(axis), y = glm::cross(normal, x);
  glm::dvec2 lo(std::numeric_limits<double>::infinity()), hi(-lo);
  for (const glm::dvec3 corner : outline) {
    const glm::dvec3 from = corner - light.position;
    const glm::dvec2 at(glm::dot(from, x), glm::dot(from, y));
    lo = glm::min(lo, at), hi = glm::max(hi, at);
  }
  const glm::dvec2 middle = 0.5 * (lo + hi), half = 0.5 * (hi - lo);
  return {light.position + middle.x * x + middle.y * y, half.x * x, half.y * y};
}

using FlatOutline = std::vector<glm::dvec2>;

/// Returns the part of an outline on one side of a line along an axis (Sutherland and Hodgman
/// 1974). If it has several pieces, the sides along the line that connect them cancel.
FlatOutline cut_off(const FlatOutline& outline, int axis, double at, double sign) {
  FlatOutline kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 p = outline[i], q = outline[(i + 1) % outline.size()];
    const double hp = sign * (p[axis] - at), hq = sign * (q[axis] - at);
    if (hp >= 0.0) kept.push_back(p);
    if ((hp < 0.0) == (hq < 0.0)) continue;
    glm::dvec2 on = glm::mix(p, q, hp / (hp - hq));
    on[axis] = at;
    if (on != p && on != q) kept.push_back(on);
  }
  return kept;
}

double area_of(const FlatOutline& outline) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const glm::dvec2 a = outline[i] - outline[0], b = outline[i + 1] - outline[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * std::abs(twice);
}

/// A flat light with the table of its emission, in its bounding rectangle.
struct PaintedLight {
  PaintedLight(const World& world, EmissionAt emission, std::span<const EmitterTriangle> triangles,
               const FlatEmitter& emitter)
      : light(emitter.light) {
    const std::vector<glm::dvec3> corners = outline_of(light);
    frame =
        frame_of(light, corners, texture_axis(world, triangles[emitter.region.front()].triangle));
    for (const glm::dvec3 corner : corners) outline.push_back(frame.place_of(corner));
    std::vector<PlacedTriangle> placed;
    for (const std::uint32_t i : emitter.region)
      placed.emplace_back(world, triangles[i].triangle, frame);
    table = EmissionTable(world, emission, placed);
    scale = glm::length(frame.half_u) * glm::length(frame.half_v);
  }

  /// Returns the light of a block, without its strength; none if the outline excludes it.
  [[nodiscard]] std::optional<Light> part(const Block& block) const {
    glm::dvec2 lo, hi;
    for (int k = 0; k < 2; ++k) {
      lo[k] = 2.0 * block.begin[static_cast<std::size_t>(k)] / squares - 1.0;
      hi[k] = 2.0 * block.end[static_cast<std::size_t>(k)] / squares - 1.0;
    }
    Light part = light;
    if (!outline.empty()) {
      FlatOutline kept = outline;
      for (int k = 0; k < 2; ++k) kept = cut_off(cut_off(kept, k, lo[k], 1.0), k, hi[k], -1.0);
      const double area = area_of(kept), whole = (hi.x - lo.x) * (hi.y - lo.y);
      if (!(area > smallest_part * whole)) return std::nullopt;
      if (area < whole * (1.0 - 1e-12)) {
        part.type = Light::Type::polygon;
        part.position = frame.at(0.5 * (lo + hi));
        part.outlines.assign(1, {});
        for (const glm::dvec2 corner : kept) part.outlines[0].push_back(frame.at(corner));
        return part;
      }
      part.outlines.clear();
      part.type = Light::Type::rectangle;
    }
    part.position = frame.at(0.5 * (lo + hi));
    part.half_u = 0.5 * (hi.x - lo.x) * frame.half_u;
    part.half_v = 0.5 * (hi.y - lo.y) * frame.half_v;
    return part;
  }

  Light light;
  PaintedFrame frame;
  FlatOutline outline;  ///< in the frame; empty: the whole frame
  EmissionTable table;
  double scale = 1.0;  ///< area of a unit of the frame
};

/// A block of one of several lights, and its best cut.
struct PaintedBlock {
  std::size_t light = 0;
  Block block;
  Cut cut;
};

/// Repeatedly cuts the block whose best cut reduces the variance most.
std::vector<PaintedBlock> blocks_of(std::span<const PaintedLight> lights, std::size_t most) {
  const auto block_of = [&](std::size_t i, const Block& block) {
    Cut cut = best_cut(lights[i].table, block);
    cut.saved *= lights[i].scale;
    return PaintedBlock{i, block, cut};
  };
  std::vector<PaintedBlock> blocks;
  double left = 0.0, even = 0.0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    blocks.push_back(block_of(i, {}));
    left += lights[i].scale * lights[i].table.of({}).left();
    even += even_share * lights[i].scale * lights[i].table.of({}).square;
  }
  while (blocks.size() < most && left > even) {
    const auto best = std::max_element(
        blocks.begin(), blocks.end(),
        [](const PaintedBlock& a, const PaintedBlock& b) { return a.cut.saved < b.cut.saved; });
    if (!(best->cut.saved > 0.0)) break;
    const auto [light, block, cut] = *best;
    left -= cut.saved;
    *best = block_of(light, cut.first);
    blocks.push_back(block_of(light, cut.second));
  }
  return blocks;
}

}  // namespace

bool can_be_split(const FlatEmitter& emitter) {
  const Light::Type type = emitter.light.type;
  if (emitter.region.size() > most_triangles_painted) return false;
  return type == Light::Type::rectangle || type == Light::Type::disk ||
         (type == Light::Type::polygon && emitter.light.outlines.size() == 1);
}

std::vector<Light> split_by_texture(const World& world, EmissionAt emission,
                                    std::span<const EmitterTriangle> triangles,
                                    std::span<const FlatEmitter> emitters, std::size_t most) {
  std::vector<PaintedLight> painted;
  double brightest = 0.0;
  for (const FlatEmitter& emitter : emitters) {
    const PaintedLight& light = painted.emplace_back(world, emission, triangles, emitter);
    brightest = std::max(brightest, light.scale * largest(light.table.of({}).radiance));
  }
  const std::vector<PaintedBlock> blocks = blocks_of(painted, most);
  std::vector<Light> lights;
  for (const PaintedBlock& b : blocks) {
    const PaintedLight& from = painted[b.light];
    if (b.block == Block{}) {
      lights.push_back(from.light);
      continue;
    }
    const EmissionSums sums = from.table.of(b.block);
    std::optional<Light> light = from.part(b.block);
    if (!light || !(from.scale * largest(sums.radiance) > negligible_power * brightest)) continue;
    const glm::dvec3 radiance = sums.radiance / sums.weight;
    light->intensity = static_cast<float>(largest(radiance));
    if (!std::isfinite(light->intensity)) continue;
    light->color = glm::vec3(radiance / static_cast<double>(light->intensity));
    lights.push_back(*std::move(light));
  }
  return lights;
}

}  // namespace asos
