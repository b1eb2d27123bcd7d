#pragma once

#include "renderer/session/render_session.h"

#include <optional>

namespace asos::ui {

/// Until when a render refines. Nothing here restarts one: a limit that is raised lets it go on.
struct RefinementLimits {
  static constexpr double most_seconds = 86'400.0;

  double seconds = 0.0;  ///< of rendering, without pauses; 0: no limit
  double rmse = 0.0;     ///< limit on RefiningFilm::estimated_rmse; 0: no limit

  bool operator==(const RefinementLimits&) const = default;
};

/// Why a render rests before it is finished.
enum class Rest { none, paused, time, quality, stopped };

/// How long a render goes on refining its picture: whether it is paused, its limits, and why it
/// rests. All members are for one thread.
class Refinement {
 public:
  /// Lets the render rest, but for its coarse pictures, until it is asked to go on; through
  /// changes, too.
  void set_paused(bool paused) { paused_ = paused; }
  [[nodiscard]] bool paused() const { return paused_; }
  [[nodiscard]] RefinementLimits& limits() { return limits_; }
  [[nodiscard]] const RefinementLimits& limits() const { return limits_; }
  [[nodiscard]] Rest rest() const { return rest_; }

  /// Whether it rests at a limit.
  [[nodiscard]] bool at_limit() const { return rest_ == Rest::time || rest_ == Rest::quality; }
  /// Lets the render that rests at a limit go on: for as long again, or to the end where its
  /// quality was reached. The limits stay, for the next render.
  void go_on();

  /// When the limit of time is reached, in seconds; none: it will not be.
  [[nodiscard]] std::optional<double> seconds_to_limit(const Progress& progress) const;
  /// Decides whether a render that has come so far rests. True if `rest` has changed.
  [[nodiscard]] bool decide(const Progress& progress, std::optional<double> rmse);
  /// Another render has begun; it rests only if it is paused.
  void begin();
  /// The render was stopped: it rests until another begins.
  void end() { rest_ = Rest::stopped; }

 private:
  bool paused_ = false;
  RefinementLimits limits_;
  int spans_ = 1;                // of the limit of time that this render is given
  bool beyond_quality_ = false;  // this render goes on though its quality was reached
  Rest rest_ = Rest::none;
};

}  // namespace asos::ui
