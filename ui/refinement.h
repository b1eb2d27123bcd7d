#pragma once

#include "renderer/session/render_session.h"

#include <optional>

namespace asos::ui {

/// Limits for refining a picture. Changing one does not restart the render; raising one resumes it.
struct RefinementLimits {
  static constexpr double most_seconds = 86'400.0;

  double seconds = 0.0;  ///< rendering time without pauses; 0: no limit
  double rmse = 0.0;     ///< limit on RefiningFilm::estimated_rmse; 0: no limit

  bool operator==(const RefinementLimits&) const = default;
};

/// Why a render is paused before it is finished.
enum class PauseReason { none, paused, time, quality, stopped };

/// Decides how long a render refines its picture: pause, limits, and the reason for stopping. All
/// members must be called from one thread.
class Refinement {
 public:
  /// Pauses or resumes. While paused, changes still render their coarse picture.
  void set_paused(bool paused) { paused_ = paused; }
  [[nodiscard]] bool paused() const { return paused_; }
  [[nodiscard]] RefinementLimits& limits() { return limits_; }
  [[nodiscard]] const RefinementLimits& limits() const { return limits_; }
  [[nodiscard]] PauseReason rest() const { return rest_; }

  /// Whether the render has stopped at a limit.
  [[nodiscard]] bool at_limit() const {
    return rest_ == PauseReason::time || rest_ == PauseReason::quality;
  }
  /// Resumes a render that stopped at a limit: for as long again, or to its end if it stopped for
  /// its quality. The limits stay for the next render.
  void go_on();

  /// Seconds until the time limit is reached; none: it will not be.
  [[nodiscard]] std::optional<double> seconds_to_limit(const Progress& progress) const;
  /// Decides from the progress whether the render is paused. Returns true if `rest` has changed.
  [[nodiscard]] bool decide(const Progress& progress, std::optional<double> rmse);
  /// Call when a render starts; it is paused only after `set_paused(true)`.
  void begin();
  /// Call when the render was stopped; it stays so until another one starts.
  void end() { rest_ = PauseReason::stopped; }

 private:
  bool paused_ = false;
  RefinementLimits limits_;
  int spans_ = 1;                // number of time limits that this render may take
  bool beyond_quality_ = false;  // the render was resumed after it reached the quality limit
  PauseReason rest_ = PauseReason::none;
};

}  // namespace asos::ui
