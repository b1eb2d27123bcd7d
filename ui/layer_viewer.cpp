#include "ui/layer_viewer.h"

#include <array>
#include <cmath>

namespace asos::ui {

namespace {

constexpr double scale_seconds = 0.25;

/// The linear values that the sRGB curve shows as each byte.
struct LinearBytes {
  std::array<float, 256> linear{};
  LinearBytes() {
    for (std::size_t i = 0; i < linear.size(); ++i) {
      const double x = static_cast<double>(i) / 255.0;
      linear[i] = static_cast<float>(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4));
    }
  }
};
const LinearBytes linear_bytes;

}  // namespace

void LayerViewer::update(const Film& film, std::span<const PixelRect> changed,
                         const DisplaySettings& display, bool unfinished, double now_seconds) {
  if (!display.layer) {
    shown_.reset();
    return;
  }
  const PixelRect whole{0, 0, film.width, film.height};
  const bool other = !shown_ || shown_->layer != *display.layer ||
                     shown_->display != display.transform() || picture_.width != film.width ||
                     picture_.height != film.height;
  const bool stale = other || (!changed.empty() && !shown_->unfinished) ||
                     (shown_->unfinished &&
                      (!unfinished || now_seconds - shown_->scaled_seconds >= scale_seconds));
  if (stale) {
    const LayerScale scale = layer_scale(film, *display.layer);
    const bool rescaled = other || scale != shown_->scale;
    shown_ = {*display.layer, display.transform(), scale, unfinished, now_seconds};
    if (rescaled) {
      if (picture_.width != film.width || picture_.height != film.height)
        picture_ = Film(film.width, film.height);
      convert(film, whole);
      ++revision_;
      return;
    }
  }
  for (const PixelRect& rect : changed) convert(film, intersection(rect, whole));
}

void LayerViewer::convert(const Film& film, const PixelRect& rect) {
  for (int y = rect.y; y < rect.y + rect.height; ++y)
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      const std::size_t i = film.index(x, y);
      const glm::u8vec3 colour =
          layer_colour(film, shown_->layer, i, shown_->scale, shown_->display);
      for (int c = 0; c < 3; ++c) picture_.radiance[i][c] = linear_bytes.linear[colour[c]];
    }
}

}  // namespace asos::ui
