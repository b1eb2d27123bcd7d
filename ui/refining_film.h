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

/// The picture that the window shows while a render refines it: first coarse tiles, then final
/// ones, over the picture of the render before. All members are for one thread.
class RefiningFilm {
 public:
  /// Another render begins. The picture stays, stretched where the size is another, so that the
  /// window shows something until tiles arrive. `keeps_map`: but for EPS and MAX it is of the same
  /// as the one before, so that the split map stays and is predicted where no pixel is final.
  void begin(const RenderSettings& settings, bool keeps_map);
  /// Puts a tile of the render that runs in.
  void put(FinishedTile tile);
  /// Shows the split map that another EPS and MAX would give, at once; see PredictedMap.
  void predict(const RenderSettings& asked);

  [[nodiscard]] const Film& film() const { return film_; }
  /// The parts of the film that changed since the last call.
  [[nodiscard]] std::vector<PixelRect> take_changed() { return std::exchange(changed_, {}); }
  /// Counts the changes of the whole split map.
  [[nodiscard]] std::uint64_t map_revision() const { return map_revision_; }
  /// The weight of split pixels among all, 0 to 1, predicted where none is final.
  [[nodiscard]] double split_share() const;
  /// Whether the render that runs has covered the picture, coarsely at least.
  [[nodiscard]] bool covered() const { return pixels_taken_ >= pixels(); }
  /// How far the picture is from the finished one: the root mean square difference of linear
  /// values, clipped to 0 to 1, taking the pixels that are left for as wrong as those that are
  /// finished were before. None before any is finished.
  [[nodiscard]] std::optional<double> estimated_rmse() const;

 private:
  void finish(const FinishedTile& tile);
  [[nodiscard]] std::int64_t pixels() const;

  Film film_;
  PredictedMap map_;
  std::uint64_t map_revision_ = 0;
  std::vector<PixelRect> changed_;
  std::int64_t pixels_taken_ = 0;  // of the tiles of the render that runs
  double corrected_ = 0.0;         // squared differences that its final pixels made
  std::int64_t pixels_finished_ = 0;
};

}  // namespace asos::ui
