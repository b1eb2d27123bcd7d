#include "ui/refinement.h"

#include <algorithm>

namespace asos::ui {

std::optional<double> Refinement::seconds_to_limit(const Progress& progress) const {
  if (!progress.running || limits_.seconds <= 0.0) return std::nullopt;
  return std::max(0.0, spans_ * limits_.seconds - progress.seconds);
}

bool Refinement::decide(const Progress& progress, std::optional<double> rmse) {
  if (rest_ == PauseReason::stopped) return false;
  PauseReason rest = PauseReason::none;
  if (paused_) {
    rest = PauseReason::paused;
  } else if (limits_.seconds > 0.0 && progress.seconds >= spans_ * limits_.seconds) {
    rest = PauseReason::time;
  } else if (limits_.rmse > 0.0 && !beyond_quality_ && rmse && *rmse <= limits_.rmse) {
    rest = PauseReason::quality;
  }
  if (rest == rest_) return false;
  rest_ = rest;
  return true;
}

void Refinement::go_on() {
  if (rest_ == PauseReason::time) ++spans_;
  if (rest_ == PauseReason::quality) beyond_quality_ = true;
}

void Refinement::begin() {
  spans_ = 1;
  beyond_quality_ = false;
  if (rest_ != PauseReason::paused) rest_ = PauseReason::none;
}

}  // namespace asos::ui
