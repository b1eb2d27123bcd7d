#pragma once

#include "renderer/geometry/frame.h"
#include "renderer/pyray/search_bounds.h"
#include "renderer/pyray/square.h"

#include <cstdint>
#include <span>

namespace asos {

/// A pyramidal ray (CGF'98 section 1): an apex and a quadrilateral, or a direction and a
/// parallelogram, as a projective frame over whose unit square (u, v) runs. Pyrays from the eye, to
/// lights and by way of mirrors differ in this, and in the caster that looks along them.
/// Keeps references: what it points to has to outlive its trace.
struct Pyray {
  Frame frame;
  Square square{0.0f, 0.0f, 1.0f};  ///< the part of the frame's square that is asked about
  SearchBounds bounds{};            ///< where boundaries of the scene count
  /// Boundaries that are no edges of the scene, in the frame: the outline of a light or of the leaf
  /// that sent the pyray, a horizon, where a camera's planes cut surfaces. Nothing hides them.
  std::span<const BorderEdge> outline{};
  std::uint64_t seed = 0;  ///< of jittered samples
};

/// Pyrays side by side in one frame, the pixels of a block, which share one search (CGF'98 section
/// 6.4, "fat" pyray). They may be wider than they lie apart, as a wide filter makes them.
struct FatPyray {
  Frame frame;
  int side = 1;     ///< side x side pyrays; a power of two
  int columns = 1;  ///< columns x rows of them are wanted, from the top left
  int rows = 1;
  int border = 0;                         ///< steps of the frame around them
  double width = 1.0;                     ///< of a pyray's square, in steps
  double reach = 0.0;                     ///< searched around it, in steps: a lens' blur
  glm::ivec2 origin{0};                   ///< place of the first in the picture, for seeds
  SearchBounds bounds{};                  ///< see Pyray::bounds
  std::span<const BorderEdge> outline{};  ///< see Pyray::outline

  /// From the left, then from the top.
  [[nodiscard]] std::uint32_t index(int x, int y) const {
    return static_cast<std::uint32_t>(y * side + x);
  }
  /// The square around size x size pyrays from (x, y) on.
  [[nodiscard]] Square square_of(int x, int y, int size) const {
    return square_around(x, y, size, 0.5 * (width - 1.0));
  }
  /// The same with its surroundings that are searched.
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
