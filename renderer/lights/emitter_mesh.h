#pragma once

#include "renderer/lights/emitters.h"
#include "renderer/lights/lit_texels.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Largest distance of the triangles of a flat light from its plane, relative to the longest edge
/// of the largest triangle. Rounding may double it.
inline constexpr double flatness_of_emitters = 1e-4;

/// An emitting triangle with an area above 0. Vertices at the same position have the same number.
struct EmitterTriangle {
  std::array<glm::dvec3, 3> corner;
  std::array<std::uint32_t, 3> vertex{};
  std::uint32_t triangle = 0;  ///< of the world
  glm::dvec3 normal{0.0};      ///< unit normal of the front side, counter-clockwise (glTF)
  double area = 0.0;
  glm::dvec3 radiance{0.0};  ///< mean over the triangle, in nits

  [[nodiscard]] glm::dvec3 middle() const { return (corner[0] + corner[1] + corner[2]) / 3.0; }
};

/// Indices of connected emitting triangles of a part.
using Piece = std::vector<std::uint32_t>;

/// Returns the emitting triangles of a part. A place where the texture leaves less than 1/250 of
/// the material's emission counts as black, and so does a triangle whose mean is below 1/1000. The
/// dimmest textured triangles, up to half a percent of the power, are dropped, and their power goes
/// to the others. `lit` is of the part's emissive texture.
[[nodiscard]] std::vector<EmitterTriangle> emitting_triangles(const World& world,
                                                              std::uint32_t part,
                                                              EmissionAt emission,
                                                              const LitTexels& lit);

/// The triangles that share each triangle's edges.
class EmitterNeighbours {
 public:
  explicit EmitterNeighbours(std::span<const EmitterTriangle> triangles);

  /// Returns whether each of the triangle's edges belongs to another triangle, too.
  [[nodiscard]] bool surrounded(std::uint32_t triangle) const { return !open_[triangle]; }

  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t triangle) const {
    return std::span(others_).subspan(first_[triangle], first_[triangle + 1] - first_[triangle]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> others_;
  std::vector<bool> open_;
};

/// Returns the connected triangles in one plane that face the same way, region by region, starting
/// with the largest triangles.
[[nodiscard]] std::vector<Piece> flat_regions(std::span<const EmitterTriangle> triangles,
                                              const EmitterNeighbours& neighbours);

/// Returns the triangles connected by edges, for any orientation: piece by piece, each as a list of
/// its flat regions, as in `flat_regions`.
[[nodiscard]] std::vector<std::vector<Piece>> connected_pieces(
    std::span<const EmitterTriangle> triangles, const EmitterNeighbours& neighbours);

}  // namespace asos
