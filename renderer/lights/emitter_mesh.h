#pragma once

#include "renderer/lights/emitters.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Triangles of one flat light lie this close to its plane, in the longest edge of the largest of
/// them, and as far again by rounding.
inline constexpr double flatness_of_emitters = 1e-4;

/// A triangle that emits, of positive area. Vertices at the same position have the same number.
struct EmitterTriangle {
  std::array<glm::dvec3, 3> corner;
  std::array<std::uint32_t, 3> vertex{};
  std::uint32_t triangle = 0;  ///< of the world
  glm::dvec3 normal{0.0};      ///< unit, of the front side: counter-clockwise (glTF)
  double area = 0.0;
  glm::dvec3 radiance{0.0};  ///< nits, the mean over the triangle

  [[nodiscard]] glm::dvec3 middle() const { return (corner[0] + corner[1] + corner[2]) / 3.0; }
};

/// Indices of a part's emitting triangles that belong together.
using Piece = std::vector<std::uint32_t>;

/// The triangles of a part that emit. Where an emissive texture leaves less than 1/250 of the
/// material's emission it counts as black, as does a triangle with less than 1/1000 on the whole.
/// The dimmest others by texture, with half a percent of the power, give it to the rest.
[[nodiscard]] std::vector<EmitterTriangle> emitting_triangles(const World& world,
                                                              std::uint32_t part,
                                                              EmissionAt emission);

/// Which triangles share an edge with which.
class EmitterNeighbours {
 public:
  explicit EmitterNeighbours(std::span<const EmitterTriangle> triangles);

  /// Whether each of the triangle's edges is another one's too.
  [[nodiscard]] bool surrounded(std::uint32_t triangle) const { return !open_[triangle]; }

  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t triangle) const {
    return std::span(others_).subspan(first_[triangle], first_[triangle + 1] - first_[triangle]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> others_;
  std::vector<bool> open_;
};

/// The triangles that lie in one plane, face the same way and are joined by edges: region by
/// region, the largest triangles' first.
[[nodiscard]] std::vector<Piece> flat_regions(std::span<const EmitterTriangle> triangles,
                                              const EmitterNeighbours& neighbours);

/// The triangles that edges join, whichever way they face: piece by piece, each by its flat
/// regions, which are `flat_regions`.
[[nodiscard]] std::vector<std::vector<Piece>> connected_pieces(
    std::span<const EmitterTriangle> triangles, const EmitterNeighbours& neighbours);

}  // namespace asos
