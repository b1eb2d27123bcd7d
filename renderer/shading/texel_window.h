#pragma once

#include "renderer/scene/scene.h"
#include "renderer/shading/bilinear.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace asos {

/// A parallelogram over the texels of one level of a texture, by its edges.
struct TexelPatch {
  glm::vec2 right{0.0f};
  glm::vec2 down{0.0f};

  [[nodiscard]] float longest() const { return std::max(glm::length(right), glm::length(down)); }
  [[nodiscard]] float area() const { return std::abs(right.x * down.y - right.y * down.x); }
};

/// Returns the rectangle with a parallelogram's covariance. It represents parallelograms that are
/// far from rectangular, or have no area.
[[nodiscard]] inline TexelPatch principal_axes(const TexelPatch& p) {
  // Eigenvalues of right right^T + down down^T, and the eigenvector of the larger one.
  const float xx = p.right.x * p.right.x + p.down.x * p.down.x;
  const float yy = p.right.y * p.right.y + p.down.y * p.down.y;
  const float xy = p.right.x * p.right.y + p.down.x * p.down.y;
  const float half = 0.5f * (xx - yy);
  const float root = std::sqrt(half * half + xy * xy);
  const glm::vec2 axis = half > 0.0f ? glm::vec2(half + root, xy) : glm::vec2(xy, root - half);
  const float length = glm::length(axis);
  const glm::vec2 unit = length > 0.0f ? axis / length : glm::vec2(1.0f, 0.0f);
  const float longer = std::sqrt(0.5f * (xx + yy) + root);
  const float shorter = longer > 0.0f ? p.area() / longer : 0.0f;
  return {longer * unit, shorter * glm::vec2(-unit.y, unit.x)};
}

/// The interpolation between texels: bilinear (tent) or nearest (box).
enum class TexelShape { tent, box };

/// The integral of a texture over a parallelogram, as weights of texels. It is exact where the
/// edges are parallel to the texels' rows. Elsewhere each texel has an extent along each edge with
/// the right variance. Constants are preserved, and with tents also linear ramps.
class TexelWindow {
 public:
  /// `centre` is in texels, with texel centres at whole numbers. The patch has an area.
  TexelWindow(glm::vec2 centre, const TexelPatch& patch, TexelShape shape)
      : centre_(centre), box_(shape == TexelShape::box) {
    const float per_area = 1.0f / (patch.right.x * patch.down.y - patch.right.y * patch.down.x);
    across_right_ = per_area * glm::vec2(patch.down.y, -patch.down.x);
    across_down_ = per_area * glm::vec2(-patch.right.y, patch.right.x);
    const float reach = box_ ? 0.5f : 1.0f;
    wide_ = {glm::length(across_right_), glm::length(across_down_)};
    reach_ = 0.5f + reach * wide_;
    height_ = reach_.x * std::abs(patch.right.y) + reach_.y * std::abs(patch.down.y);
  }

  /// Calls visit(x, y, weight) for every texel with a weight, row by row. Indices are not wrapped.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    const int first = floor_int(centre_.y - height_) + 1;
    const int last = floor_int(centre_.y + height_);
    for (int y = first; y <= last; ++y) {
      const float dy = static_cast<float>(y) - centre_.y;
      // Find where both coordinates are within reach.
      glm::vec2 lo(-1e30f), hi(1e30f);
      narrow(across_right_, reach_.x, dy, lo.x, hi.x);
      narrow(across_down_, reach_.y, dy, lo.y, hi.y);
      const int begin = floor_int(centre_.x + std::max(lo.x, lo.y)) + 1;
      const int end = floor_int(centre_.x + std::min(hi.x, hi.y));
      for (int x = begin; x <= end; ++x) {
        const glm::vec2 d(static_cast<float>(x) - centre_.x, dy);
        const float weight =
            share(glm::dot(across_right_, d), wide_.x) * share(glm::dot(across_down_, d), wide_.y);
        if (weight > 0.0f) visit(x, y, weight);
      }
    }
  }

 private:
  static int floor_int(float x) { return static_cast<int>(floor_near(x)); }

  // Narrows lo..hi to the x - centre.x with |coordinate| < reach, in a row.
  static void narrow(glm::vec2 gradient, float reach, float dy, float& lo, float& hi) {
    const float middle = gradient.y * dy;
    if (gradient.x == 0.0f) {
      if (std::abs(middle) >= reach) lo = 1.0f, hi = -1.0f;
      return;
    }
    const float a = (-reach - middle) / gradient.x;
    const float b = (reach - middle) / gradient.x;
    lo = std::min(a, b), hi = std::max(a, b);
  }

  // Returns the fraction of a texel at `at` that lies within an edge from -1/2 to 1/2.
  [[nodiscard]] float share(float at, float width) const {
    return below((0.5f - at) / width) - below((-0.5f - at) / width);
  }

  // Returns the fraction of a tent from -1 to 1, or of a box from -1/2 to 1/2, below t.
  [[nodiscard]] float below(float t) const {
    if (box_) return std::clamp(t + 0.5f, 0.0f, 1.0f);
    t = std::clamp(t, -1.0f, 1.0f);
    return 0.5f + t - 0.5f * t * std::abs(t);
  }

  glm::vec2 centre_;
  bool box_;
  glm::vec2 across_right_{0.0f}, across_down_{0.0f};  // gradients of the edges' coordinates
  glm::vec2 wide_{0.0f};                              // width of a texel along them
  glm::vec2 reach_{0.0f};
  float height_ = 0.0f;
};

}  // namespace asos
