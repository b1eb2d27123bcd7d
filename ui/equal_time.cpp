#include "ui/equal_time.h"

#include "renderer/study/timed_render.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace asos {

namespace {

constexpr int most_equal_samples = 1 << 14;

/// Number of samples that a method takes for about `wanted`: some methods need a square.
int samples_for(Method method, double wanted) {
  const double least = std::clamp(wanted, 1.0, 1.0 * most_equal_samples);
  if (row_of(method).samples == SampleCount::any) return static_cast<int>(std::lround(least));
  const auto side = static_cast<int>(std::lround(std::sqrt(least)));
  return side * side;
}

EqualTimeFrame frame_of(TimedRender rendered, const RenderSettings& settings,
                        const std::string& quality, double wanted) {
  const double taken = processor_seconds(rendered.film);
  return {std::move(rendered.film),
          fmt::format("{}, {}, {:.2f} s CPU ({:.0f} % of {:.2f} s)", row_of(settings.method).name,
                      quality, taken, 100.0 * taken / wanted, wanted)};
}

using Stop = std::function<bool()>;

std::optional<EqualTimeFrame> render_by_samples(Snapshot snapshot, double seconds,
                                                const Stop& stop) {
  const auto render = [&](int samples) {
    snapshot.settings.sampling.spp = samples;
    return timed_render(snapshot, stop);
  };
  auto rendered = render(1);
  if (!rendered) return std::nullopt;
  double taken = processor_seconds(rendered->film);
  int samples = 1;
  // A few samples tell better than one what many take.
  constexpr int few = 4;
  if (seconds > 2.0 * few * taken) {
    samples = few;
    rendered = render(few);
    if (!rendered) return std::nullopt;
    taken = processor_seconds(rendered->film);
  }
  const int wanted =
      samples_for(snapshot.settings.method, seconds / std::max(taken, 1e-9) * samples);
  if (wanted != samples) rendered = render(wanted);
  if (!rendered) return std::nullopt;
  return frame_of(std::move(*rendered), snapshot.settings, fmt::format("{} samples", wanted),
                  seconds);
}

// How the time grows as EPS falls depends on the scene: each try tells the next one.
std::optional<EqualTimeFrame> render_by_eps(Snapshot snapshot, double seconds, const Stop& stop) {
  constexpr int most_tries = 5;
  constexpr double coarsest = 0.25;
  constexpr double finest = 1.0 / 65536.0;
  constexpr double near_enough = 0.1;
  constexpr double most_at_once = 8.0;
  RenderSettings& settings = snapshot.settings;
  settings.asos.max_level = 6;  // EPS alone decides, up to most_equal_samples
  double eps = 1.0 / 16.0;
  double exponent = 1.0;  // of the time in 1 / EPS
  double eps_before = eps;
  double taken_before = 0.0;
  for (int tries = 1;; ++tries) {
    settings.asos.eps = eps;
    auto rendered = timed_render(snapshot, stop);
    if (!rendered) return std::nullopt;
    const double taken = std::max(processor_seconds(rendered->film), 1e-9);
    if (eps != eps_before)
      exponent = std::clamp(std::log(taken / taken_before) / std::log(eps_before / eps), 0.25, 2.0);
    const double finer = std::pow(std::max(seconds, 1e-9) / taken, 1.0 / exponent);
    const double next =
        std::clamp(eps / std::clamp(finer, 1.0 / most_at_once, most_at_once), finest, coarsest);
    const bool there = std::abs(taken - seconds) <= near_enough * seconds;
    if (there || tries == most_tries || next == eps)
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
                                             const std::function<bool()>& stop) {
  snapshot.progressive = false;
  snapshot.settings.method = method;
  return row_of(method).samples_by_eps ? render_by_eps(std::move(snapshot), seconds, stop)
                                       : render_by_samples(std::move(snapshot), seconds, stop);
}

}  // namespace asos
