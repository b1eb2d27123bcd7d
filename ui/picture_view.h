#pragma once

#include <glm/glm.hpp>

namespace asos::ui {

/// Zoom and pan of the finished picture in its area of the window. All lengths are framebuffer
/// pixels, y down, from the area's top left. A picture of the area's size fills it at zoom 1; one
/// of another size (while the window is being resized) is fitted in.
class PictureView {
 public:
  /// Sizes may be 0 (a minimised window): then nothing is visible.
  void set_sizes(glm::ivec2 area, glm::ivec2 picture);

  /// Moves `steps` up or down the list of zooms 1, 2, 3, 4, 6, 8 ... 64, and keeps the picture's
  /// point under `point` in place.
  void zoom_at(glm::vec2 point, int steps);
  void pan(glm::vec2 delta);
  void reset() { *this = with_sizes(); }

  [[nodiscard]] glm::vec2 area_middle() const { return 0.5f * glm::vec2(area_); }
  /// Zoom relative to the fitted picture.
  [[nodiscard]] int zoom() const;
  /// Framebuffer pixels per picture pixel; 0 if nothing is visible.
  [[nodiscard]] float scale() const;
  /// The picture's top left corner, in whole pixels.
  [[nodiscard]] glm::vec2 offset() const { return offset_; }
  [[nodiscard]] glm::vec2 picture_from_area(glm::vec2 point) const;

 private:
  [[nodiscard]] PictureView with_sizes() const;
  void keep_inside();

  glm::ivec2 area_{0};
  glm::ivec2 picture_{0};
  int step_ = 0;  // index in the list of zooms
  glm::vec2 offset_{0.0f};
};

}  // namespace asos::ui
