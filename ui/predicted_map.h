#pragma once

#include "renderer/film/film.h"
#include "renderer/settings/settings.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos::ui {

/// The split map of a film while its pixels are rendered again with another EPS or MAX. Keeps the
/// data of each pixel from when it was last final, and predicts level and cause from them
/// (LevelPrediction). Valid for one scene, camera and picture size. All members must be called from
/// one thread.
class PredictedMap {
 public:
  /// Forgets all pixels and sets their number.
  void clear(std::size_t pixels);
  /// Call when a render with these settings starts or resumes.
  void render_by(const RenderSettings& settings);
  /// Writes the map for these settings into `film`: predictions for pixels rendered with others.
  /// Returns whether the settings differ from the last call's.
  bool predict(const RenderSettings& asked, Film& film);
  /// Keeps the data of a final tile, whose pixels are in `film` already.
  void note_final(const FinishedTile& tile, Film& film);
  /// Adds the known level, cause and cost to a coarse tile, which has none itself.
  void complete(FinishedTile& coarse, const Film& film) const;

 private:
  static constexpr std::uint16_t unknown = 0xffff;

  struct Known {
    SplitPredictionData outlook;
    std::uint16_t origin = unknown;  ///< index of the settings that the pixel was rendered with
    std::uint8_t level = 0;
    SplitCause cause = SplitCause::none;
  };
  [[nodiscard]] std::uint16_t index_of(const RenderSettings& settings);
  void drop_unused();
  template <typename Pixels>
  void show(const Pixels& pixels, Film& film) const;

  std::vector<Known> known_;             // one a pixel
  std::vector<RenderSettings> origins_;  // by `origin`
  std::uint16_t rendering_ = unknown;    // index of the running render's settings
  RenderSettings asked_;
};

}  // namespace asos::ui
