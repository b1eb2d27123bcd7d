// Quality of a picture during its render: a progressive session of ASOS against Sobol sampling, at
// the times at which Sobol sampling has taken 1, 4, 16 and 64 samples per pixel.
//
//   bench anytime [--size WxH] [--reference N] [--cache DIR] [--method NAME] [--curves]
//                 [--strips DIR] [--f-stop N] [--focus M] [--animation N] [--time S] [--shutter S]
//                 [--replay] [--single-samples P] [--search P] [--dearer P] [SCENE...]
//
// Times are CPU seconds of one worker since the first ray; the scene's hierarchy and its edges are
// computed before. Errors are RMSE of linear radiance clipped to 0..1 against halves of --reference
// Sobol samples (HalvedReference), of the whole picture as displayed at that time. One line per
// scene, then medians and the worst values. Columns:
//
//   1 4 16 64    error relative to that of Sobol sampling at each time
//   over direct  total time relative to that of a render without passes
//   rise         largest ratio of a later error to an earlier one
//   p99/16       time from which the 99th percentile of the displayed error stays below 1/64,
//                relative to the time of Sobol sampling with 16 samples
//   left         fraction of pictures with Progress::seconds_left wrong by more than a factor of
//                1.5, from 10 % of the work until 50 ms before the end. Wall-clock time: this and
//                the next column need an idle machine.
//   factor       largest such factor
//
// --curves also prints each picture's time, error and pass, the finished work, and the remaining
// time, estimated and true. --strips writes a picture per scene: the method and Sobol sampling side
// by side, at 1/4, 1/2, 1, 2, 4 and 8 times the time of 16 samples. --replay judges schedules that
// are not built, from measured pictures (print_replays). --single-samples, --search and --dearer
// are the assumed costs of work for single pixels (SinglePixelCost).

#include "renderer/comparison/method.h"
#include "renderer/film/image_io.h"
#include "renderer/study/progress_curve.h"
#include "tests/bench/anytime_replay.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/scene_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace asos::bench::anytime {
namespace {

struct Settings {
  SceneSet set{.size = {160, 90}, .samples = 256};
  std::string method = "asos";
  bool curves = false;
  std::string strips;
  bool replay = false;
  SinglePixelCost single_pixel;
  ExposureChoice exposure;
};

constexpr std::array moments{1, 4, 16, 64};  // samples a pixel

/// The pictures of a render, each 3 % later than the one before.
std::vector<TimedPicture> watched(const Snapshot& snapshot) {
  return watch_render(snapshot, 1.03).pictures;
}

/// The error displayed at a time.
double error_at(const std::vector<CurvePoint>& curve, double seconds) {
  return error_shown_at(curve, seconds).value_or(curve.front().error);
}

/// The picture displayed at a time.
const Film& film_at(const std::vector<TimedPicture>& seen, double seconds) {
  const Film* film = &seen.front().film;
  for (const TimedPicture& one : seen)
    if (one.seconds <= seconds) film = &one.film;
  return *film;
}

/// Two renders side by side, a row per time.
Result<void> write_strip(const std::string& path, const std::vector<TimedPicture>& own,
                         const std::vector<TimedPicture>& sobol, double sixteen_samples) {
  constexpr std::array times{0.25, 0.5, 1.0, 2.0, 4.0, 8.0};
  const int width = own.front().film.width, height = own.front().film.height;
  RgbImage strip;
  strip.width = 2 * width;
  strip.height = static_cast<int>(times.size()) * height;
  strip.rgb.resize(3 * static_cast<std::size_t>(strip.width) *
                   static_cast<std::size_t>(strip.height));
  for (std::size_t row = 0; row < times.size(); ++row) {
    for (const bool right : {false, true}) {
      const Film& film = film_at(right ? sobol : own, times[row] * sixteen_samples);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const glm::u8vec3 shown = display_bytes(film.radiance[film.index(x, y)], 0.0f);
          const std::size_t line =
              row * static_cast<std::size_t>(height) + static_cast<std::size_t>(y);
          const std::size_t at = line * static_cast<std::size_t>(strip.width) +
                                 static_cast<std::size_t>(x + (right ? width : 0));
          for (int c = 0; c < 3; ++c) strip.rgb[3 * at + static_cast<std::size_t>(c)] = shown[c];
        }
      }
    }
  }
  return write_png(path, strip);
}

/// Accuracy of the remaining time that a render estimates.
struct TimeLeft {
  double share_wrong = std::numeric_limits<double>::quiet_NaN();  ///< by more than a factor of 1.5
  double largest_factor = std::numeric_limits<double>::quiet_NaN();
};

TimeLeft judge_time_left(const std::vector<TimedPicture>& seen) {
  constexpr double first_share = 0.1;
  constexpr double least_left = 0.05;  // seconds
  constexpr double most_wrong = 1.5;
  const double end = seen.back().progress.seconds;
  TimeLeft judged;
  int count = 0, wrong = 0;
  for (const TimedPicture& one : seen) {
    const double left = end - one.progress.seconds;
    if (one.progress.fraction < first_share || one.progress.seconds_left < 0.0 || left < least_left)
      continue;
    const double factor =
        std::max(one.progress.seconds_left / left, left / one.progress.seconds_left);
    judged.largest_factor = std::fmax(judged.largest_factor, factor);
    wrong += factor > most_wrong ? 1 : 0;
    ++count;
  }
  if (count > 0) judged.share_wrong = static_cast<double>(wrong) / count;
  return judged;
}

/// Time from which the displayed error stays below 1/64 in 99 % of the pixels.
double good_from(const std::vector<TimedPicture>& seen, const HalvedReference& reference) {
  constexpr double good = 1.0 / 64.0;
  double from = std::numeric_limits<double>::infinity();
  for (auto one = seen.rbegin(); one != seen.rend(); ++one) {
    if (reference.display_p99(one->film) >= good) break;
    from = one->seconds;
  }
  return from;
}

struct Row {
  std::string name;
  std::vector<double> over_sobol;  ///< relative error at each of `moments`
  double over_direct = 0.0;        ///< time to the end
  double rise = 0.0;               ///< largest ratio of a later error to an earlier one
  double good_over_sobol = 0.0;    ///< relative to Sobol sampling's time
  TimeLeft time_left;
};

/// A picture of a scene with its reference.
struct Subject {
  std::string name;
  Snapshot snapshot;
  HalvedReference reference;
};

Result<Subject> opened(const Settings& settings, const NamedScene& named) {
  const std::string label = settings.exposure.label();
  auto snapshot = label.empty()
                      ? settings.set.open(named.source)
                      : exposed_snapshot(named.source, settings.set.size, {}, settings.exposure);
  if (!snapshot) return unexpected(snapshot.error());
  (void)snapshot->scene->features();
  snapshot->settings.threads = 1;
  auto reference = settings.set.reference_of(named.name + label, *snapshot);
  if (!reference) return unexpected(reference.error());
  for (const MethodRow& row : method_table())
    if (settings.method == row.name) snapshot->settings.method = row.value;
  return Subject{named.name, *std::move(snapshot), *std::move(reference)};
}

Result<Row> measure(const Settings& settings, const Subject& subject) {
  Snapshot snapshot = subject.snapshot;
  const HalvedReference& reference = subject.reference;
  const auto last_of = [&](Snapshot of) {
    of.progressive = false;
    const std::vector<TimedPicture> seen = watched(of);
    return CurvePoint{seen.back().seconds, reference.error_of(seen.back().film).rmse};
  };

  const CurvePoint direct = last_of(snapshot);
  snapshot.progressive = true;
  std::vector<CurvePoint> curve;
  const std::vector<TimedPicture> own = watched(snapshot);
  for (const TimedPicture& seen : own) {
    curve.push_back({seen.seconds, reference.error_of(seen.film).rmse});
    if (settings.curves)
      fmt::print(
          "{:>10.4f} s  {:.2e}  {:>4} samples, {:.2f} final, {:>3.0f} %, {:.2f} s left of {:.2f}\n",
          curve.back().seconds, curve.back().error, seen.reached.samples, seen.reached.final_share,
          100.0 * seen.progress.fraction, seen.progress.seconds_left,
          own.back().progress.seconds - seen.progress.seconds);
  }

  Row row{subject.name, {}, curve.back().seconds / direct.seconds, 1.0, 0.0, judge_time_left(own)};
  double least = curve.front().error;
  for (const CurvePoint& point : curve) {
    // Changes of smaller errors are the reference's noise.
    constexpr double told = 1e-3;
    if (least > told) row.rise = std::max(row.rise, point.error / least);
    least = std::min(least, point.error);
  }
  snapshot.settings.method = Method::sobol;
  for (const int samples : moments) {
    snapshot.settings.sampling.spp = samples;
    const CurvePoint sobol = last_of(snapshot);
    if (settings.curves)
      fmt::print("{:>10.4f} s  {:.2e}  sobol {}\n", sobol.seconds, sobol.error, samples);
    if (samples == 16) row.good_over_sobol = good_from(own, reference) / sobol.seconds;
    if (samples == 16 && !settings.strips.empty()) {
      Snapshot rounds = snapshot;
      rounds.settings.sampling.spp = 256;
      const auto written = write_strip(
          settings.strips + "/" + row.name.substr(row.name.find_last_of("/:") + 1) + ".png", own,
          watched(rounds), sobol.seconds);
      if (!written) return unexpected(written.error());
    }
    row.over_sobol.push_back(error_at(curve, sobol.seconds) / std::max(sobol.error, 1e-6));
  }
  return row;
}

void print_row(const Row& row) {
  fmt::print("{:<28}", row.name);
  for (const double ratio : row.over_sobol) fmt::print("{:>8.2f}", ratio);
  fmt::print("{:>12.2f}{:>8.2f}{:>8.2f}{:>8.2f}{:>8.2f}\n", row.over_direct, row.rise,
             row.good_over_sobol, row.time_left.share_wrong, row.time_left.largest_factor);
  std::fflush(stdout);
}

void print_summary(const std::vector<Row>& rows, const std::string& what, const auto& value) {
  std::vector<SceneValue> values;
  for (const Row& row : rows) values.push_back({value(row), row.name});
  print_median(what, std::move(values), "; worst:");
}

}  // namespace

int run(int argc, char** argv) {
  Settings settings;
  Options options("The error of a picture while it renders, beside Sobol sampling");
  SceneSet& set = settings.set;
  set.add_to(options);
  options.exposure(settings.exposure);
  options.number("--reference", set.samples, 256, 65536, "samples");
  std::vector<std::string> methods;
  for (const MethodRow& row : method_table()) methods.emplace_back(row.name);
  options.choice("--method", settings.method, methods);
  options.parsed("--strips", "folder of filmstrips", [&](const std::string& text) -> Result<void> {
    settings.strips = text;
    return {};
  });
  options.flag("--curves", settings.curves, "each picture, too");
  options.flag("--replay", settings.replay, "judge schedules that are not built");
  options.number("--single-samples", settings.single_pixel.samples, 100, 1000,
                 "percent of a sample's time when single pixels take it");
  options.number("--search", settings.single_pixel.search, 0, 100,
                 "percent of a block's time for each of its single pixels' visits");
  options.number("--dearer", settings.single_pixel.dearer, 100, 1000,
                 "percent of a pixel's time when it is rendered alone");
  if (const auto code = options.end(argc, argv)) return *code;

  fmt::print("{}x{}, error of {} over that of sobol at the moment of\n{:<28}", set.size.width,
             set.size.height, settings.method, "");
  if (settings.replay) {
    fmt::print("{:>22}{:>8}{:>12}\n", 16, 64, "over direct");
  } else {
    for (const int samples : moments) fmt::print("{:>8}", samples);
    fmt::print("{:>12}{:>8}{:>8}{:>8}{:>8}\n", "over direct", "rise", "p99/16", "left", "factor");
  }
  std::vector<Row> rows;
  const int code = set.measure([&](const NamedScene& scene) {
    return opened(settings, scene).and_then([&](const Subject& subject) -> Result<void> {
      if (settings.replay) {
        fmt::print("{}\n", subject.name);
        print_replays(subject.snapshot, subject.reference, settings.single_pixel);
        return {};
      }
      return measure(settings, subject).map([&](const Row& row) {
        print_row(row);
        rows.push_back(row);
      });
    });
  });
  for (std::size_t i = 0; i < moments.size(); ++i)
    print_summary(rows, fmt::format("error at {} samples", moments[i]),
                  [&](const Row& row) { return row.over_sobol[i]; });
  print_summary(rows, "time over direct", [](const Row& row) { return row.over_direct; });
  print_summary(rows, "largest rise", [](const Row& row) { return row.rise; });
  print_summary(rows, "99th percentile of display error below 1/64: time over sobol 16",
                [](const Row& row) { return row.good_over_sobol; });
  print_summary(rows, "time left wrong by more than 1.5: share of pictures",
                [](const Row& row) { return row.time_left.share_wrong; });
  print_summary(rows, "time left: largest factor",
                [](const Row& row) { return row.time_left.largest_factor; });
  return code;
}

}  // namespace asos::bench::anytime
