#pragma once

#include "ui/preview_render.h"
#include "ui/split_check.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

/// The pixels of a picture that MAX ended, and the difference from the last finished picture if
/// only MAX differs.
struct MaxEffect {
  struct Change {
    int from = 0, to = 0;    ///< values of MAX
    std::size_t pixels = 0;  ///< that differ by a display step or more
    float steps = 0.0f;      ///< the largest difference, in steps of an 8-bit picture
  };
  std::vector<PixelRun> ended;
  std::size_t ended_pixels = 0;
  std::size_t pixels = 0;        ///< that are final
  bool finished = false;         ///< all are
  std::optional<Change> change;  ///< none: not finished, or nothing to compare with
  /// At most `most_worst` pixels, some pixels apart: those that changed most, or else those of
  /// `ended` with the largest contrast to a neighbour.
  std::vector<glm::ivec2> worst;

  static constexpr std::size_t most_worst = 5;
};
[[nodiscard]] MaxEffect max_effect(const PreviewRender& render, const DisplayTransform& display);
/// The number of pixels that ended, and the change; empty: no pixel is final.
[[nodiscard]] std::string max_words(const MaxEffect& effect, int max_level);

/// Keeps the effect of the displayed picture.
class MaxExplainer {
 public:
  /// Call once a frame. `asked`: the effect is to be known. Returns whether it has changed.
  bool update(const PreviewRender& render, const DisplayTransform& display, bool asked);
  /// Null: not asked for.
  [[nodiscard]] const MaxEffect* effect() const { return effect_ ? &*effect_ : nullptr; }

 private:
  std::optional<MaxEffect> effect_;
  std::uint64_t restarts_ = 0;
  std::uint64_t percent_ = 0;  // final pixels of the explained picture
};

}  // namespace asos::ui
