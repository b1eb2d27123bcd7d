#include "ui/shown_progress.h"

#include "ui/previewer.h"
#include "ui/split_forecast.h"

#include <algorithm>

namespace asos::ui {

namespace {

// Limit of the displayed percentage ahead of the finished work, as a fraction of the remaining
// work.
constexpr double most_ahead = 0.5;
// Assumed duration of a render without an estimate.
constexpr double usual_seconds = 60.0;

// Whether the render has the window's EPS and MAX already.
bool follows_splitting(const Previewer& previewer) {
  const AsosSettings& asked = previewer.edits().settings().asos;
  const AsosSettings& rendered = previewer.render().settings().asos;
  return asked.eps == rendered.eps && asked.max_level == rendered.max_level;
}

}  // namespace

std::optional<TimeEstimate> time_estimate(const Progress& progress, const Forecast* forecast) {
  if (progress.failed) return std::nullopt;
  if (progress.finished) return TimeEstimate{progress.seconds, 0.0};
  if (progress.seconds_left >= 0.0)
    return TimeEstimate{progress.seconds + progress.seconds_left, progress.seconds_left};
  if (!forecast) return std::nullopt;
  return TimeEstimate{forecast->wait_seconds,
                      std::max(0.0, forecast->wait_seconds - progress.seconds)};
}

std::optional<TimeEstimate> time_estimate(const Previewer& previewer, const Forecast* forecast) {
  return time_estimate(follows_splitting(previewer) ? previewer.render().progress() : Progress{},
                       forecast);
}

std::optional<double> shown_split_share(const Previewer& previewer, const Forecast* forecast) {
  if (follows_splitting(previewer) && previewer.render().progress().finished)
    return previewer.render().split_share();
  return forecast ? std::optional(forecast->split_share) : std::nullopt;
}

void ShownProgress::update(const Progress& progress, std::optional<TimeEstimate> estimate,
                           std::uint64_t restarts, double now_seconds) {
  const double passed = std::max(0.0, now_seconds - now_seconds_);
  now_seconds_ = now_seconds;
  if (restarts != restarts_) {
    restarts_ = restarts;
    fraction_ = 0.0;
    return;
  }
  if (progress.finished) {
    fraction_ = 1.0;
    return;
  }
  fraction_ = std::max(fraction_, std::min(progress.fraction, 1.0));
  if (!progress.running) return;
  // The percentage slows down as it nears its limit.
  const double limit = progress.fraction + most_ahead * (1.0 - progress.fraction);
  const double all = std::max(1.0, estimate ? estimate->all : usual_seconds);
  const double share = passed / (passed + all);
  fraction_ += share * std::max(0.0, limit - fraction_);
}

}  // namespace asos::ui
