#pragma once

#include "renderer/geometry/frame.h"
#include "renderer/pyray/search_bounds.h"
#include "renderer/pyray/square.h"

#include <cstdint>
#include <span>

namespace asos {

/// A pyramidal ray (CGF'98 section 1): an apex and a quadrilateral, or a direction and a
/// parallelogram, as a projective frame with the unit square (u, v). Pyrays from the eye, to lights
/// and by reflection differ only in the frame and in the caster. Stores references; their targets
/// have to outlive its trace.
struct Pyray {
  Frame frame;
  Square square{0.0f, 0.0f, 1.0f};  ///< the part of the frame's square to trace
  SearchBounds bounds{};            ///< where boundaries of the scene count
  /// Boundaries that are not edges of the scene, in the frame: the outline of a light or of the
  /// leaf that cast the pyray, a horizon, or cuts of surfaces by a camera's planes. They are never
  /// hidden.
  std::span<const BorderEdge> outline{};
  std::uint64_t seed = 0;  ///< for jittered samples
};

/// Neighbouring pyrays in one frame, such as the pixels of a block, which share one search (CGF'98
/// section 6.4, "fat" pyray). With a wide filter, they are wider than their spacing.
struct FatPyray {
  Frame frame;
  int side = 1;     ///< side x side pyrays; a power of two
  int columns = 1;  ///< only columns x rows pyrays are needed, from the top left
  int rows = 1;
  int border = 0;                         ///< number of the frame's steps around the pyrays
  double width = 1.0;                     ///< width of a pyray's square, in steps
  double reach = 0.0;                     ///< search radius around it, in steps, for a lens' blur
  glm::ivec2 origin{0};                   ///< position of the first in the picture, for seeds
  SearchBounds bounds{};                  ///< see Pyray::bounds
  std::span<const BorderEdge> outline{};  ///< see Pyray::outline

  /// Returns the index of a pyray: from left to right, then from top to bottom.
  [[nodiscard]] std::uint32_t index(int x, int y) const {
    return static_cast<std::uint32_t>(y * side + x);
  }
  /// Returns the square around size x size pyrays from (x, y) on.
  [[nodiscard]] Square square_of(int x, int y, int size) const {
    return square_around(x, y, size, 0.5 * (width - 1.0));
  }
  /// Returns that square, widened by the search radius.
  [[nodiscard]] Square searched_square(int x, int y, int size) const {
    return square_around(x, y, size, 0.5 * (width - 1.0) + reach);
  }
  [[nodiscard]] std::uint64_t seed_of(int x, int y) const {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(origin.x + x)) << 32 |
            static_cast<std::uint32_t>(origin.y + y)) *
           0x9e3779b97f4a7c15ULL;
  }

 private:
  [[nodiscard]] Square square_around(int x, int y, int size, double beyond) const {
    const double step = 1.0 / (side + 2 * border);
    return {static_cast<float>((border + x - beyond) * step),
            static_cast<float>((border + y - beyond) * step),
            static_cast<float>((size + 2.0 * beyond) * step)};
  }
};

}  // namespace asos
