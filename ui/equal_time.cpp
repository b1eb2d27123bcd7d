#include "ui/equal_time.h"

#include "renderer/comparison/method.h"
#include "renderer/study/timed_render.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
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

}  // namespace

double processor_seconds(const Film& film) {
  return std::accumulate(film.seconds.begin(), film.seconds.end(), 0.0);
}

std::optional<EqualTimeFrame> render_in_time(Snapshot snapshot, Method method, double seconds,
                                             const std::function<bool()>& stop) {
  snapshot.progressive = false;
  snapshot.settings.method = method;
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
  const int wanted = samples_for(method, seconds / std::max(taken, 1e-9) * samples);
  if (wanted != samples) {
    rendered = render(wanted);
    if (!rendered) return std::nullopt;
    taken = processor_seconds(rendered->film);
  }
  return EqualTimeFrame{
      std::move(rendered->film),
      fmt::format("{}, {} samples in {:.2f} s of one processor, {:.0f} % of {:.2f} s",
                  row_of(method).name, wanted, taken, 100.0 * taken / seconds, seconds)};
}

}  // namespace asos
