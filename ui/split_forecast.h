#pragma once

#include "renderer/session/render_session.h"
#include "ui/latest_job.h"

#include <memory>
#include <optional>

namespace asos::ui {

class Previewer;

/// The outcome of a render, forecast from blocks all over the picture.
struct Forecast {
  double split_share = 0.0;        ///< of the pixels, 0 to 1
  double split_error = 0.0;        ///< its standard error
  double wait_seconds = 0.0;       ///< of the clock, that the final pixels take with all workers
  int pixels = 0;                  ///< that were looked at
  double processor_seconds = 0.0;  ///< of one processor, that those took
};

/// Renders blocks of a view, at the places of a sequence that fills the picture evenly (Roberts'
/// R2), for `budget_seconds` of this thread's processor, and at least four.
[[nodiscard]] Forecast forecast(const Snapshot& snapshot, double budget_seconds);

/// Tells in the background what would be split while a setting is being dragged, on a thread of its
/// own. All members are for one thread.
class SplitForecast {
 public:
  SplitForecast();

  /// Asks about the settings as they are.
  void ask(const Previewer& previewer);
  /// Asks whenever EPS or MAX has changed, however that was done. Call once a frame.
  void follow(const Previewer& previewer);
  /// Call once a frame.
  void update();
  /// The forecast for the settings as they are; null: not known.
  [[nodiscard]] const Forecast* of(const Previewer& previewer) const;
  [[nodiscard]] bool busy() const { return job_.pending(); }

 private:
  struct Told {
    RenderSettings settings;
    const RenderScene* scene = nullptr;
    Forecast forecast;
  };
  LatestJob<Snapshot, Told> job_;
  std::optional<RenderSettings> asked_;
  std::optional<AsosSettings> followed_;
  std::optional<Told> told_;
  std::uint64_t camera_ = 0;  // revision that was asked about
};

}  // namespace asos::ui
