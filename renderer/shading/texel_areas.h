#pragma once

#include "renderer/shading/texel_window.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace asos {

/// The integral of a texture of nearest texels over a parallelogram: the area of each texel inside
/// it. It is exact, but slower than a TexelWindow, which is exact only along the texels' rows.
class TexelAreas {
 public:
  /// `centre` is in texels, with texel centres at whole numbers.
  TexelAreas(glm::vec2 centre, const TexelPatch& patch) {
    const glm::vec2 r = 0.5f * patch.right, d = 0.5f * patch.down;
    for (const glm::vec2 corner : {centre - r - d, centre + r - d, centre + r + d, centre - r + d})
      all_.add(corner);
  }

  /// Calls visit(x, y, area) for every texel with an area, row by row. Indices are not wrapped.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for_each_part(all_, 1, [&](int y, const Polygon& row) {
      for_each_part(row, 0, [&](int x, const Polygon& part) {
        const float area = part.area();
        if (area > 0.0f) visit(x, y, area);
      });
    });
  }

 private:
  /// A convex polygon: a parallelogram cut by four lines.
  struct Polygon {
    std::array<glm::vec2, 8> corners{};
    std::size_t count = 0;

    void add(glm::vec2 corner) { corners[count++] = corner; }
    [[nodiscard]] float area() const {
      float twice = 0.0f;
      for (std::size_t i = 2; i < count; ++i) {
        const glm::vec2 p = corners[i - 1] - corners[0], q = corners[i] - corners[0];
        twice += p.x * q.y - p.y * q.x;
      }
      return 0.5f * std::abs(twice);
    }
    /// Returns the part where `sign` times a coordinate is at least `sign` times `bound`.
    [[nodiscard]] Polygon beyond(int axis, float bound, float sign) const {
      Polygon part;
      for (std::size_t i = 0; i < count; ++i) {
        const glm::vec2 from = corners[i], to = corners[i + 1 < count ? i + 1 : 0];
        const float a = sign * (from[axis] - bound), b = sign * (to[axis] - bound);
        if (a >= 0.0f) part.add(from);
        if ((a >= 0.0f) != (b >= 0.0f)) part.add(from + a / (a - b) * (to - from));
      }
      return part;
    }
  };

  // Cuts a polygon at the borders of texels along an axis.
  template <typename Visit>
  static void for_each_part(const Polygon& all, int axis, const Visit& visit) {
    if (all.count < 3) return;
    float lo = all.corners[0][axis], hi = lo;
    for (std::size_t i = 1; i < std::min(all.count, all.corners.size()); ++i) {
      lo = std::min(lo, all.corners[i][axis]);
      hi = std::max(hi, all.corners[i][axis]);
    }
    const int first = static_cast<int>(floor_near(lo + 0.5f));
    const int last = static_cast<int>(floor_near(hi + 0.5f));
    Polygon rest = all;
    for (int i = first; i < last; ++i) {
      const float end = static_cast<float>(i) + 0.5f;
      visit(i, rest.beyond(axis, end, -1.0f));
      rest = rest.beyond(axis, end, 1.0f);
    }
    visit(last, rest);
  }

  Polygon all_;
};

}  // namespace asos
