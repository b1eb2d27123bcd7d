#pragma once

#include "renderer/film/film.h"
#include "renderer/geometry/pixel_rect.h"
#include "renderer/settings/settings.h"
#include "ui/predicted_map.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace asos::ui {

/// The window's picture during a render: first coarse tiles, then final ones, drawn over the
/// picture of the previous render. All members must be called from one thread.
class RefiningFilm {
 public:
  /// Call when a render starts. The picture stays until tiles arrive, stretched if the size
  /// differs. `same_view`: only EPS and MAX differ from the previous render. Then the split map
  /// stays and is predicted for pixels that are not final, and pixels stay until finer ones arrive.
  void begin(const RenderSettings& settings, bool same_view);
  /// Shows a finished picture that was kept, with its map.
  void show(const RefiningFilm& kept);
  /// Adds a tile of the running render. `samples`: a coarse tile has at least so many in each
  /// pixel.
  void put(FinishedTile tile, int samples = 0);
  /// Shows the split map predicted for another EPS and MAX at once: see PredictedMap.
  void predict(const RenderSettings& asked);

  [[nodiscard]] const Film& film() const { return film_; }
  /// Returns the areas of the film that changed since the last call.
  [[nodiscard]] std::vector<PixelRect> take_changed() { return std::exchange(changed_, {}); }
  /// Counts changes of the split map as a whole.
  [[nodiscard]] std::uint64_t map_revision() const { return map_revision_; }
  /// Fraction of pixels that are split, 0 to 1, predicted for pixels that are not final.
  [[nodiscard]] double split_share() const;
  /// Whether the running render has covered the picture, at least coarsely.
  [[nodiscard]] bool covered() const { return pixels_taken_ >= pixels(); }
  /// Estimated RMSE of the picture against the finished one, of linear values clipped to 0 to 1.
  /// Unfinished pixels count with the mean squared error that the finished ones had before. None
  /// before any pixel is finished.
  [[nodiscard]] std::optional<double> estimated_rmse() const;

 private:
  void put_coarse(FinishedTile tile, int samples);
  void finish(const FinishedTile& tile);
  [[nodiscard]] std::int64_t pixels() const;

  Film film_;
  /// Fineness of each pixel of this view, from 0: 1 + log2 of the samples of a coarse pixel, and
  /// 2 + 2 MAX for a final one, which has up to 4^MAX cells.
  std::vector<std::uint8_t> fineness_;
  std::uint8_t final_fineness_ = 0;  // of the running render
  bool view_covered_ = false;        // by earlier renders of this view
  PredictedMap map_;
  std::uint64_t map_revision_ = 0;
  std::vector<PixelRect> changed_;
  std::int64_t pixels_taken_ = 0;  // pixels of the running render's tiles
  double corrected_ = 0.0;         // sum of squared differences that its final pixels made
  std::int64_t pixels_finished_ = 0;
};

}  // namespace asos::ui
