#pragma once

#include "ui/panels/overlays.h"
#include "ui/panels/seen_lines.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace asos::ui {

/// Step of a grid under an object of this radius: 1, 2 or 5 times a power of ten, with about ten
/// squares across it; 0 without a radius.
[[nodiscard]] double grid_step(double radius);

/// Draws a grid through the scene's lowest point and the author's three axes over the picture.
/// Surfaces hide the grid; hidden parts of axes are pale. Visibility is computed again when scene
/// or view have changed, with about 4,000 rays.
class GridOverlay {
 public:
  void draw(const Previewer& previewer, const PictureView& view, const PictureArea& area);

 private:
  void find(const Previewer& previewer);

  // Scene, view and culling of the current lines.
  std::weak_ptr<const RenderScene> scene_;
  std::uint64_t camera_revision_ = 0;
  glm::ivec2 size_{0};
  bool cull_ = true;

  std::vector<LinePart> grid_;
  std::array<std::vector<LinePart>, 3> axes_;
  std::array<glm::dvec3, 3> tips_{};
};

}  // namespace asos::ui
