#include "ui/picture_view.h"

#include <algorithm>
#include <array>

namespace asos::ui {

namespace {

constexpr std::array ladder{1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};

}  // namespace

void PictureView::set_sizes(glm::ivec2 area, glm::ivec2 picture) {
  if (area == area_ && picture == picture_) return;
  area_ = area;
  picture_ = picture;
  keep_inside();
}

int PictureView::zoom() const {
  return ladder[static_cast<std::size_t>(step_)];
}

float PictureView::scale() const {
  if (area_.x <= 0 || area_.y <= 0 || picture_.x <= 0 || picture_.y <= 0) return 0.0f;
  const float fit = std::min(static_cast<float>(area_.x) / static_cast<float>(picture_.x),
                             static_cast<float>(area_.y) / static_cast<float>(picture_.y));
  return fit * static_cast<float>(zoom());
}

glm::vec2 PictureView::picture_from_area(glm::vec2 point) const {
  const float s = scale();
  return s > 0.0f ? (point - offset_) / s : glm::vec2(0.0f);
}

void PictureView::zoom_at(glm::vec2 point, int steps) {
  const glm::vec2 fixed = picture_from_area(point);
  step_ = std::clamp(step_ + steps, 0, static_cast<int>(ladder.size()) - 1);
  offset_ = point - fixed * scale();
  keep_inside();
}

void PictureView::pan(glm::vec2 delta) {
  offset_ += delta;
  keep_inside();
}

PictureView PictureView::with_sizes() const {
  PictureView view;
  view.set_sizes(area_, picture_);
  return view;
}

// A picture larger than the area covers it; a smaller one is centred. Whole-pixel offsets align
// zoomed pixels with the screen.
void PictureView::keep_inside() {
  const glm::vec2 area(area_);
  const glm::vec2 free = area - glm::vec2(picture_) * scale();
  for (int axis = 0; axis < 2; ++axis) {
    offset_[axis] =
        free[axis] >= 0.0f ? 0.5f * free[axis] : std::clamp(offset_[axis], free[axis], 0.0f);
  }
  offset_ = glm::round(offset_);
}

}  // namespace asos::ui
