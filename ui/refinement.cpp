#include "ui/refinement.h"

#include <algorithm>

namespace asos::ui {

std::optional<double> Refinement::seconds_to_limit(const Progress& progress) const {
  if (!progress.running || limits_.seconds <= 0.0) return std::nullopt;
  return std::max(0.0, spans_ * limits_.seconds - progress.seconds);
}

bool Refinement::decide(const Progress& progress, std::optional<double> rmse) {
  if (rest_ == Rest::stopped) return false;
  Rest rest = Rest::none;
  if (paused_) {
    rest = Rest::paused;
  } else if (limits_.seconds > 0.0 && progress.seconds >= spans_ * limits_.seconds) {
    rest = Rest::time;
  } else if (limits_.rmse > 0.0 && !beyond_quality_ && rmse && *rmse <= limits_.rmse) {
    rest = Rest::quality;
  }
  if (rest == rest_) return false;
  rest_ = rest;
  return true;
}

void Refinement::go_on() {
  if (rest_ == Rest::time) ++spans_;
  if (rest_ == Rest::quality) beyond_quality_ = true;
}

void Refinement::begin() {
  spans_ = 1;
  beyond_quality_ = false;
  if (rest_ != Rest::paused) rest_ = Rest::none;
}

}  // namespace asos::ui
