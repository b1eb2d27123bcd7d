#pragma once

#include "renderer/film/layer_colours.h"
#include "ui/display_settings.h"

#include <cstdint>
#include <optional>
#include <span>

namespace asos::ui {

/// A layer of the film in false colours, as a film that is shown in place of the picture. One
/// thread.
class LayerViewer {
 public:
  /// Call once a frame. `changed`: the pixels of `film` that differ from the last call. The scale
  /// follows the film about four times a second while it is `unfinished`.
  void update(const Film& film, std::span<const PixelRect> changed, const DisplaySettings& display,
              bool unfinished, double now_seconds);
  /// Its radiance shows the colours at exposure 0 without a tone curve; null: no layer is shown.
  [[nodiscard]] const Film* film() const { return shown_ ? &picture_ : nullptr; }
  /// Grows when all pixels may have changed.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  [[nodiscard]] const LayerScale& scale() const { return shown_->scale; }
  /// Whether a last look at the scale is due.
  [[nodiscard]] bool due() const { return shown_ && shown_->unfinished; }

 private:
  struct Shown {
    Layer layer = Layer::depth;
    DisplayTransform display;
    LayerScale scale;
    bool unfinished = true;  // whether the film was, when the scale was found
    double scaled_seconds = 0.0;
  };
  void convert(const Film& film, const PixelRect& rect);

  std::optional<Shown> shown_;
  Film picture_;
  std::uint64_t revision_ = 0;
};

}  // namespace asos::ui
