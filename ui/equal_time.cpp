#include "ui/equal_time.h"

#include "renderer/session/film_render.h"
#include "ui/snapshot_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace asos::ui {

namespace {

constexpr int most_equal_samples = 1 << 14;

/// Returns the valid sample count nearest to `wanted`: some methods need a square.
int samples_for(Method method, double wanted) {
  const double least = std::clamp(wanted, 1.0, 1.0 * most_equal_samples);
  if (row_of(method).samples == SampleCount::any) return static_cast<int>(std::lround(least));
  const auto side = static_cast<int>(std::lround(std::sqrt(least)));
  return side * side;
}

// Renders a method at one quality after another and reports the progress.
class Tries {
 public:
  Tries(const std::function<bool()>& stop, const TellEqualTime& tell) : stop_(stop), tell_(tell) {}

  std::optional<Film> render(const Snapshot& snapshot, const std::string& doing) {
    std::optional<RenderResult> rendered = render_.render(
        snapshot, [&] { return !stop_(); },
        [&](const Progress& progress) {
          if (tell_) tell_({std::nullopt, doing, progress.fraction});
        });
    if (!rendered) return std::nullopt;
    return std::move(rendered->film);
  }

 private:
  const std::function<bool()>& stop_;
  const TellEqualTime& tell_;
  FilmRender render_;
};

EqualTimeFrame frame_of(Film film, const RenderSettings& settings, const std::string& quality,
                        double wanted) {
  const double taken = processor_seconds(film);
  return {std::move(film), snapshot_name(settings, taken),
          fmt::format("{}, {}, {:.3g} s CPU ({:.0f} % of {:.3g} s)", row_of(settings.method).title,
                      quality, taken, 100.0 * taken / wanted, wanted)};
}

std::optional<EqualTimeFrame> render_by_samples(Snapshot snapshot, double seconds, Tries& tries) {
  const auto render = [&](int samples) {
    snapshot.settings.sampling.spp = samples;
    return tries.render(snapshot, fmt::format("{} spp", samples));
  };
  auto rendered = render(1);
  if (!rendered) return std::nullopt;
  double taken = processor_seconds(*rendered);
  int samples = 1;
  // Time per sample is measured with a few samples: a single one includes fixed costs.
  constexpr int few = 4;
  if (seconds > 2.0 * few * taken) {
    samples = few;
    rendered = render(few);
    if (!rendered) return std::nullopt;
    taken = processor_seconds(*rendered);
  }
  const int wanted =
      samples_for(snapshot.settings.method, seconds / std::max(taken, 1e-9) * samples);
  if (wanted != samples) rendered = render(wanted);
  if (!rendered) return std::nullopt;
  return frame_of(std::move(*rendered), snapshot.settings, fmt::format("{} spp", wanted), seconds);
}

// The time grows by a scene-dependent power of 1 / EPS, which each try estimates for the next one.
std::optional<EqualTimeFrame> render_by_eps(Snapshot snapshot, double seconds, Tries& tries) {
  constexpr int most_tries = 5;
  constexpr double coarsest = 0.25;
  constexpr double finest = 1.0 / 65536.0;
  constexpr double near_enough = 0.1;
  constexpr double most_at_once = 8.0;
  RenderSettings& settings = snapshot.settings;
  settings.asos.max_level = 6;  // EPS alone sets the quality, up to most_equal_samples
  double eps = 1.0 / 16.0;
  double exponent = 1.0;  // of the time in 1 / EPS
  double eps_before = eps;
  double taken_before = 0.0;
  for (int tried = 1;; ++tried) {
    settings.asos.eps = eps;
    auto rendered = tries.render(snapshot, fmt::format("EPS {:.2g}", eps));
    if (!rendered) return std::nullopt;
    const double taken = std::max(processor_seconds(*rendered), 1e-9);
    if (eps != eps_before)
      exponent = std::clamp(std::log(taken / taken_before) / std::log(eps_before / eps), 0.25, 2.0);
    const double finer = std::pow(std::max(seconds, 1e-9) / taken, 1.0 / exponent);
    const double next =
        std::clamp(eps / std::clamp(finer, 1.0 / most_at_once, most_at_once), finest, coarsest);
    const bool there = std::abs(taken - seconds) <= near_enough * seconds;
    if (there || tried == most_tries || next == eps)
      return frame_of(std::move(*rendered), settings, fmt::format("EPS {:.2g}", eps), seconds);
    eps_before = std::exchange(eps, next);
    taken_before = taken;
  }
}

}  // namespace

double processor_seconds(const Film& film) {
  return std::accumulate(film.seconds.begin(), film.seconds.end(), 0.0);
}

bool can_be_timed(const MethodRow& method) {
  return method.samples != SampleCount::none || method.samples_by_eps;
}

std::optional<EqualTimeFrame> render_in_time(Snapshot snapshot, Method method, double seconds,
                                             const std::function<bool()>& stop,
                                             const TellEqualTime& tell) {
  snapshot.progressive = false;
  snapshot.settings.method = method;
  Tries tries(stop, tell);
  return row_of(method).samples_by_eps ? render_by_eps(std::move(snapshot), seconds, tries)
                                       : render_by_samples(std::move(snapshot), seconds, tries);
}

}  // namespace asos::ui
