#include "tests/bench/anytime_replay.h"

#include "renderer/study/progress_curve.h"
#include "tests/bench/schedule_replay.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace asos::bench {
namespace {

constexpr std::array rounds{1, 4, 16, 64, 256};

TimedRender rendered(Snapshot snapshot, Method method, int samples) {
  snapshot.settings.method = method;
  snapshot.settings.sampling.spp = samples;
  return timed_render(std::move(snapshot)).value();
}

/// A pixel's part of its 8x8 block's time: the same for each pixel, or in proportion to its rays.
std::vector<double> seconds_of_pixels(const Film& film, bool by_rays) {
  std::vector<double> seconds(film.seconds.begin(), film.seconds.end());
  if (!by_rays) return seconds;
  constexpr int side = 8;
  for (int top = 0; top < film.height; top += side) {
    for (int left = 0; left < film.width; left += side) {
      const PixelRect block =
          intersection({left, top, side, side}, {0, 0, film.width, film.height});
      const auto each = [&](const auto& see) {
        for (int y = block.y; y < block.y + block.height; ++y)
          for (int x = block.x; x < block.x + block.width; ++x) see(film.index(x, y));
      };
      double time = 0.0, rays = 0.0;
      each([&](std::size_t i) {
        time += static_cast<double>(film.seconds[i]);
        rays += static_cast<double>(film.rays[i]);
      });
      if (rays > 0.0)
        each([&](std::size_t i) { seconds[i] = time * static_cast<double>(film.rays[i]) / rays; });
    }
  }
  return seconds;
}

std::vector<double> changes(const Film& film, const Film& before) {
  std::vector<double> changed(film.radiance.size());
  for (std::size_t i = 0; i < changed.size(); ++i)
    changed[i] = squared_error(film.radiance[i], before.radiance[i], true);
  return changed;
}

/// The times of Sobol sampling, and the errors of its pictures.
struct Sobol {
  std::array<double, rounds.size()> seconds{}, error{};
};

/// Returns the time of a progressive render to its second round.
double seconds_of_rounds(Snapshot snapshot) {
  snapshot.progressive = true;
  snapshot.settings.method = Method::sobol;
  snapshot.settings.sampling.spp = rounds[1];
  return watch_render(snapshot, 1e6).pictures.back().seconds;
}

MeasuredPicture measured(const Snapshot& snapshot, const HalvedReference& reference,
                         const SinglePixelCost& cost, Sobol& sobol) {
  MeasuredPicture picture;
  picture.width = snapshot.settings.width;
  picture.height = snapshot.settings.height;
  Film before;
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    TimedRender render = rendered(snapshot, Method::sobol, rounds[i]);
    sobol.seconds[i] = render.cpu_seconds;
    sobol.error[i] = reference.error_of(render.film).rmse;
    MeasuredPicture::Round& round = picture.rounds.emplace_back();
    round.samples = rounds[i];
    round.squared_error = reference.squared_errors(render.film);
    if (i > 0) round.changed = changes(render.film, before);
    before = std::move(render.film);
  }
  picture.seconds = seconds_of_rounds(snapshot);
  // The last picture's times contain the least overhead per sample.
  for (const float seconds : before.seconds)
    picture.sample_seconds.push_back(0.01 * cost.samples * static_cast<double>(seconds) /
                                     rounds.back());
  return picture;
}

}  // namespace

void print_replays(Snapshot snapshot, const HalvedReference& reference,
                   const SinglePixelCost& cost) {
  Sobol sobol;
  MeasuredPicture even = measured(snapshot, reference, cost, sobol);
  const TimedRender direct = rendered(snapshot, snapshot.settings.method, 1);
  even.exact_squared_error = reference.squared_errors(direct.film);
  even.exact_seconds = seconds_of_pixels(direct.film, false);
  MeasuredPicture by_rays = even;
  by_rays.exact_seconds = seconds_of_pixels(direct.film, true);

  constexpr double limit = 0.2;
  Schedule blocks, samples, pixels;
  samples.exact = Schedule::Exact::none;
  Schedule blocks_alone = blocks;
  blocks_alone.samples = false;
  Schedule limited = blocks;
  limited.most_samples = limit;
  Schedule expected = limited;
  expected.times_known = false;
  pixels.exact = Schedule::Exact::pixels;
  pixels.search = 0.01 * cost.search;
  pixels.dearer = 0.01 * cost.dearer;
  Schedule limited_pixels = pixels;
  limited_pixels.most_samples = limit;
  Schedule free_pixels = pixels;
  free_pixels.search = 0.0;
  free_pixels.dearer = 1.0;
  struct Line {
    const char* name;
    const MeasuredPicture& picture;
    Schedule schedule;
  };
  for (const auto& [name, picture, schedule] :
       {Line{"exact blocks", even, blocks_alone}, Line{"samples", even, samples},
        Line{"samples, exact blocks", even, blocks},
        Line{"  samples at most 0.2 of a block", even, limited},
        Line{"  and with expected times", even, expected},
        Line{"samples, exact pixels at the mean cost", even, free_pixels},
        Line{"  with a search for each visit", even, pixels},
        Line{"  and costs by rays", by_rays, pixels},
        Line{"  samples at most 0.2 of a block", by_rays, limited_pixels}}) {
    const std::vector<CurvePoint> curve = replayed(picture, schedule);
    fmt::print("  {:<40}", name);
    for (const std::size_t i : {std::size_t{2}, std::size_t{3}})
      fmt::print("{:>8.2f}",
                 replayed_error_at(curve, sobol.seconds[i]) / std::max(sobol.error[i], 1e-6));
    fmt::print("{:>12.2f}\n", curve.back().seconds / direct.cpu_seconds);
  }
  std::fflush(stdout);
}

}  // namespace asos::bench
