#include "renderer/lights/textured_emitter.h"

#include "renderer/geometry/finite.h"
#include "renderer/geometry/largest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace asos {
namespace {

// Squares along either side of a rectangle, and samples along either side of each square.
constexpr int squares = 64;
constexpr int samples = 3;
// A rectangle that is painted on more triangles is left whole.
constexpr std::size_t most_triangles_of_rectangle = 256;
// Emission that varies by less than this share of its mean square is even.
constexpr double even_share = 1e-3;
// A block with less than this share of the power gives no light.
constexpr double negligible_power = 1e-4;

/// A part of the rectangle: squares from `begin` on and before `end`.
struct Block {
  std::array<int, 2> begin{0, 0};
  std::array<int, 2> end{squares, squares};
};

/// Sums over squares.
struct EmissionSums {
  double weight = 0.0;  ///< of what lies on a triangle
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
  /// What the mean leaves of the squares.
  [[nodiscard]] double left() const {
    return weight > 0.0 ? std::max(0.0, square - glm::dot(radiance, radiance) / weight) : 0.0;
  }
};

/// A triangle in the rectangle's coordinates, from -1 to 1.
class PlacedTriangle {
 public:
  PlacedTriangle(const World& world, std::uint32_t triangle, const Light& rectangle)
      : triangle_(triangle) {
    const glm::uvec3 t = world.triangles[triangle];
    std::array<glm::dvec2, 3> p;
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 from = glm::dvec3(world.positions[t[k]]) - rectangle.position;
      p[static_cast<std::size_t>(k)] = {
          glm::dot(from, rectangle.half_u) / glm::dot(rectangle.half_u, rectangle.half_u),
          glm::dot(from, rectangle.half_v) / glm::dot(rectangle.half_v, rectangle.half_v)};
    }
    corner_ = p[0], first_ = p[1] - p[0], second_ = p[2] - p[0];
    area_ = first_.x * second_.y - first_.y * second_.x;
  }

  /// The weights of its second and third corner where it holds a place.
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

/// A summed table of what the rectangle emits.
class EmissionTable {
 public:
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

/// The cut of a block that leaves the least variance.
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

/// Repeatedly cuts the block whose best cut saves most variance.
std::vector<Block> blocks_of(const EmissionTable& table, std::size_t most) {
  std::vector<Block> blocks{Block{}};
  std::vector<Cut> cuts{best_cut(table, blocks[0])};
  const double even = even_share * table.of(blocks[0]).square;
  double left = table.of(blocks[0]).left();
  while (blocks.size() < most && left > even) {
    const auto best = std::max_element(
        cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.saved < b.saved; });
    if (!(best->saved > 0.0)) break;
    const Cut cut = *best;
    left -= cut.saved;
    const auto i = static_cast<std::size_t>(best - cuts.begin());
    blocks[i] = cut.first;
    cuts[i] = best_cut(table, cut.first);
    blocks.push_back(cut.second);
    cuts.push_back(best_cut(table, cut.second));
  }
  return blocks;
}

Light part_of(const Light& rectangle, const Block& block) {
  Light light = rectangle;
  std::array<double, 2> middle{}, half{};
  for (std::size_t k = 0; k < 2; ++k) {
    const double from = 2.0 * block.begin[k] / squares - 1.0;
    const double to = 2.0 * block.end[k] / squares - 1.0;
    middle[k] = 0.5 * (from + to);
    half[k] = 0.5 * (to - from);
  }
  light.position += middle[0] * rectangle.half_u + middle[1] * rectangle.half_v;
  light.half_u *= half[0];
  light.half_v *= half[1];
  return light;
}

}  // namespace

std::vector<Light> split_by_texture(const World& world, EmissionAt emission, const Light& rectangle,
                                    std::span<const EmitterTriangle> triangles,
                                    std::span<const std::uint32_t> region, std::size_t most) {
  if (region.size() > most_triangles_of_rectangle) return {rectangle};
  std::vector<PlacedTriangle> placed;
  for (const std::uint32_t i : region) placed.emplace_back(world, triangles[i].triangle, rectangle);
  const EmissionTable table(world, emission, placed);
  const std::vector<Block> blocks = blocks_of(table, most);
  const EmissionSums all = table.of({});
  if (blocks.size() == 1 || !(all.weight > 0.0)) return {rectangle};
  const double negligible = negligible_power * largest(all.radiance);
  std::vector<Light> lights;
  for (const Block& block : blocks) {
    const glm::dvec3 sum = table.of(block).radiance;
    const double area = static_cast<double>(block.end[0] - block.begin[0]) *
                        static_cast<double>(block.end[1] - block.begin[1]);
    const glm::dvec3 radiance = sum / (area * samples * samples);
    Light light = part_of(rectangle, block);
    light.intensity = static_cast<float>(largest(radiance));
    if (!(largest(sum) > negligible) || !std::isfinite(light.intensity)) continue;
    light.color = glm::vec3(radiance / static_cast<double>(light.intensity));
    lights.push_back(std::move(light));
  }
  return lights.empty() ? std::vector<Light>{rectangle} : lights;
}

}  // namespace asos
