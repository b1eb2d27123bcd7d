#pragma once

#include "renderer/session/render_session.h"
#include "ui/latest_job.h"

#include <memory>
#include <optional>

namespace asos::ui {

class Previewer;

/// Estimates for a render from blocks distributed over the picture.
struct Forecast {
  double split_share = 0.0;        ///< of the pixels, 0 to 1
  double split_error = 0.0;        ///< its standard error
  double wait_seconds = 0.0;       ///< wall-clock time for the final pixels with all workers
  int pixels = 0;                  ///< rendered for the estimate
  double processor_seconds = 0.0;  ///< CPU time that the estimate's pixels took
};

/// Renders blocks of a view, placed by Roberts' R2 sequence, for `budget_seconds` of this thread's
/// CPU time, and at least four.
[[nodiscard]] Forecast forecast(const Snapshot& snapshot, double budget_seconds);

/// Estimates the split fraction and the render time on its own thread while a setting is dragged.
/// All members must be called from one thread.
class SplitForecast {
 public:
  SplitForecast();

  /// Starts an estimate for the current settings.
  void ask(const Previewer& previewer);
  /// Starts an estimate whenever EPS or MAX has changed. Call once a frame.
  void follow(const Previewer& previewer);
  /// Call once a frame.
  void update();
  /// The estimate for the current settings; null: none.
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
  std::uint64_t camera_ = 0;  // camera revision of the request
};

}  // namespace asos::ui
