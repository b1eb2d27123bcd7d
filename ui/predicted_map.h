#pragma once

#include "renderer/film/film.h"
#include "renderer/settings/settings.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos::ui {

/// The split map of a film while its pixels are rendered again with another EPS or MAX: what each
/// pixel told when it was last final, and the level and cause predicted from it (LevelPrediction).
/// Valid for one scene, camera and picture size. All members are for one thread.
class PredictedMap {
 public:
  /// Forgets all pixels. The film has so many.
  void clear(std::size_t pixels);
  /// A render with these settings begins, or goes on.
  void render_by(const RenderSettings& settings);
  /// Shows the map of these settings in `film`: predictions where it was rendered with others.
  /// Returns whether it shows other settings than before.
  bool predict(const RenderSettings& asked, Film& film);
  /// Keeps what a final tile tells. Its pixels are in `film` already.
  void note_final(const FinishedTile& tile, Film& film);
  /// Adds the known level, cause and cost to a coarse tile, which has none.
  void complete(FinishedTile& coarse, const Film& film) const;

 private:
  static constexpr std::uint16_t unknown = 0xffff;

  struct Known {
    SplitOutlook outlook;
    std::uint16_t origin = unknown;  ///< index of the settings that it was rendered with
    std::uint8_t level = 0;
    SplitCause cause = SplitCause::none;
  };
  [[nodiscard]] std::uint16_t index_of(const RenderSettings& settings);
  void drop_unused();
  template <typename Pixels>
  void show(const Pixels& pixels, Film& film) const;

  std::vector<Known> known_;             // one a pixel
  std::vector<RenderSettings> origins_;  // by `origin`
  std::uint16_t rendering_ = unknown;    // of the render that runs
  RenderSettings asked_;
};

}  // namespace asos::ui
