#pragma once

#include "renderer/film/film.h"
#include "renderer/geometry/frame.h"
#include "ui/panels/overlays.h"
#include "ui/picture_view.h"
#include "ui/viewpoint.h"

#include <glm/glm.hpp>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace asos::ui {

/// Converts between world, picture and window coordinates.
class Projection {
 public:
  Projection(const Viewpoint& viewpoint, const Film& film, const PictureView& view,
             const PictureArea& area)
      : Projection(viewpoint.view(), {film.width, film.height}, view, area) {}
  /// `size`: of the picture that `seen` is a view of, in pixels.
  Projection(const View& seen, glm::ivec2 size, const PictureView& view, const PictureArea& area)
      : frame_(seen.frame(0.0, 0.0, size.x, size.y)), size_(size), view_(view), area_(area) {}

  /// Homogeneous coordinates; z is positive in front of the viewer.
  [[nodiscard]] glm::dvec3 homogeneous(glm::dvec3 p) const { return frame_.homogeneous(p); }
  [[nodiscard]] bool visible(glm::dvec3 h) const { return frame_.parallel() || h.z > 0.0; }

  [[nodiscard]] ImVec2 window(glm::dvec3 h) const {
    const FramePoint p = frame_.project(h);
    const glm::vec2 pixel(glm::dvec2(p.u, p.v) * size_);
    const glm::vec2 at = area_.rect.lo + (view_.offset() + pixel * view_.scale()) / area_.scale;
    return {at.x, at.y};
  }
  /// The displacement in the world of a point whose mark is moved by `by` in the window, parallel
  /// to the picture plane.
  [[nodiscard]] glm::dvec3 moved(glm::dvec3 p, glm::vec2 by) const {
    const FramePoint from = frame_.project(homogeneous(p));
    const glm::dvec2 share = glm::dvec2(by * area_.scale / view_.scale()) / size_;
    return frame_.world({from.u + share.x, from.v + share.y, from.nearness}) - frame_.world(from);
  }

  /// Draws a straight line, clipped in front of the viewer.
  void line(ImDrawList& draw, glm::dvec3 a, glm::dvec3 b, std::uint32_t colour,
            float width = 1.5f) const {
    glm::dvec3 from = homogeneous(a), to = homogeneous(b);
    if (!frame_.parallel()) {
      const double least = 1e-6 * std::max(std::abs(from.z), std::abs(to.z));
      if (from.z < least && to.z < least) return;
      const auto clipped = [&](glm::dvec3 h, glm::dvec3 other) {
        return h.z >= least ? h : glm::mix(h, other, (least - h.z) / (other.z - h.z));
      };
      const glm::dvec3 start = clipped(from, to);
      to = clipped(to, from);
      from = start;
    }
    draw.AddLine(window(from), window(to), colour, width);
  }

 private:
  Frame frame_;
  glm::dvec2 size_;
  const PictureView& view_;
  const PictureArea& area_;
};

}  // namespace asos::ui
