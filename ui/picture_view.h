#pragma once

#include <glm/glm.hpp>

namespace asos::ui {

/// Where the picture lies in the area of the window that shows it: zoom and pan of finished pixels.
/// All lengths are framebuffer pixels, y down, from the area's top left. A picture of the area's
/// size fills it at zoom 1; one of another size (while the window is being resized) is fitted in.
class PictureView {
 public:
  /// Sizes may be 0 (a minimised window); then nothing is visible and no division goes wrong.
  void set_sizes(glm::ivec2 area, glm::ivec2 picture);

  /// Goes `steps` up or down the ladder of zooms 1, 2, 3, 4, 6, 8 ... 64, keeping the picture's
  /// point under `point` where it is.
  void zoom_at(glm::vec2 point, int steps);
  void pan(glm::vec2 delta);
  void reset() { *this = with_sizes(); }

  [[nodiscard]] glm::vec2 area_middle() const { return 0.5f * glm::vec2(area_); }
  /// Relative to the fitted picture.
  [[nodiscard]] int zoom() const;
  /// Framebuffer pixels for each picture pixel; 0 where nothing is visible.
  [[nodiscard]] float scale() const;
  /// The picture's top left corner, whole pixels.
  [[nodiscard]] glm::vec2 offset() const { return offset_; }
  [[nodiscard]] glm::vec2 picture_from_area(glm::vec2 point) const;

 private:
  [[nodiscard]] PictureView with_sizes() const;
  void keep_inside();

  glm::ivec2 area_{0};
  glm::ivec2 picture_{0};
  int step_ = 0;  // on the ladder
  glm::vec2 offset_{0.0f};
};

}  // namespace asos::ui
