#pragma once

#include "renderer/film/film.h"
#include "renderer/geometry/pixel_rect.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace asos {

/// The picture that the window shows while a render refines it: first coarse tiles, then final
/// ones, over the picture of the render before. All members are for one thread.
class RefiningFilm {
 public:
  /// Another render begins, of a picture of this size. The picture stays, stretched where the size
  /// is another, so that the window shows something until tiles arrive.
  void begin(int width, int height);
  /// Puts a tile of the render that runs in.
  void put(const FinishedTile& tile);

  [[nodiscard]] const Film& film() const { return film_; }
  /// The parts of the film that changed since the last call.
  [[nodiscard]] std::vector<PixelRect> take_changed() { return std::exchange(changed_, {}); }
  /// Whether the render that runs has covered the picture, coarsely at least.
  [[nodiscard]] bool covered() const { return pixels_taken_ >= pixels(); }
  /// How far the picture is from the finished one: the root mean square difference of linear
  /// values, clipped to 0 to 1, taking the pixels that are left for as wrong as those that are
  /// finished were before. None before any is finished.
  [[nodiscard]] std::optional<double> estimated_rmse() const;

 private:
  [[nodiscard]] std::int64_t pixels() const;

  Film film_;
  std::vector<PixelRect> changed_;
  std::int64_t pixels_taken_ = 0;  // of the tiles of the render that runs
  double corrected_ = 0.0;         // squared differences that its final pixels made
  std::int64_t pixels_finished_ = 0;
};

}  // namespace asos
