#include "tests/bench/schedule_replay.h"

#include <algorithm>
#include <cmath>

namespace asos::bench {
namespace {

constexpr int block_side = 8;
// Steps are taken in the order of falling thresholds of the gain, each so much below the last.
constexpr double falling = 0.85;
constexpr int thresholds = 200;

class Replay {
 public:
  Replay(const MeasuredPicture& picture, const Schedule& schedule)
      : of_(picture),
        schedule_(schedule),
        across_((picture.width + block_side - 1) / block_side),
        pixels_(picture.exact_squared_error.size()),
        seconds_(picture.seconds) {
    const auto down = static_cast<std::size_t>((picture.height + block_side - 1) / block_side);
    blocks_.resize(static_cast<std::size_t>(across_) * down);
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      pixels_[i] = {1, of_.rounds[1].squared_error[i], expected(1, i), false};
      Block& block = blocks_[block_of(i)];
      block.pixels.push_back(i);
      block.seconds += of_.exact_seconds[i];
      squared_error_ += pixels_[i].error;
    }
    expect_seconds();
  }

  std::vector<CurvePoint> run() {
    curve_.push_back(now());
    double threshold = highest_gain();
    for (int i = 0; i < thresholds; ++i) {
      for (Block& block : blocks_) work(block, threshold);
      note();
      threshold *= falling;
    }
    // Work without expected gain comes last.
    for (Block& block : blocks_) render(block, 0.0);
    note();
    return std::move(curve_);
  }

 private:
  struct Pixel {
    std::size_t round = 0;
    double error = 0.0, expected = 0.0;  // squared
    bool exact = false;
  };
  struct Block {
    std::vector<std::size_t> pixels;
    double seconds = 0.0;          // exact
    double expected = 0.0;         // seconds
    double sampled_seconds = 0.0;  // of its pixels' samples
    int visits = 0;
  };

  [[nodiscard]] std::size_t block_of(std::size_t pixel) const {
    const auto width = static_cast<std::size_t>(of_.width);
    return pixel / width / block_side * static_cast<std::size_t>(across_) +
           pixel % width / block_side;
  }

  [[nodiscard]] double expected(std::size_t round, std::size_t pixel) const {
    const std::vector<double>& changed = of_.rounds[round].changed;
    const int x = static_cast<int>(pixel) % of_.width, y = static_cast<int>(pixel) / of_.width;
    double largest = 0.0;
    for (int v = std::max(0, y - 1); v <= std::min(of_.height - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(of_.width - 1, x + 1); ++u)
        largest = std::max(largest, changed[static_cast<std::size_t>(v * of_.width + u)]);
    return (0.6 * largest + 0.4 * changed[pixel]) / 6.0;
  }

  // As StepQueue does, whose squared errors are sums over three channels.
  void expect_seconds() {
    double all = 0.0, relative = 0.0;
    for (Block& block : blocks_) {
      double samples = 0.0, roots = 0.0;
      for (const std::size_t i : block.pixels) {
        samples += of_.sample_seconds[i];
        roots += std::sqrt(std::sqrt(3.0 * pixels_[i].expected));
      }
      block.expected = samples * (1.0 + roots);
      all += block.seconds;
      relative += block.expected;
    }
    for (Block& block : blocks_)
      block.expected = schedule_.times_known ? block.seconds : block.expected * all / relative;
  }

  // Returns the time from n to 4n samples.
  [[nodiscard]] double sample_seconds(std::size_t pixel) const {
    return 3.0 * of_.rounds[pixels_[pixel].round].samples * of_.sample_seconds[pixel];
  }
  [[nodiscard]] double gain_of_samples(std::size_t pixel) const {
    return pixels_[pixel].expected * (7.0 / 8.0) / sample_seconds(pixel);
  }

  [[nodiscard]] double highest_gain() const {
    double highest = 0.0;
    for (const Block& block : blocks_) {
      double error = 0.0;
      for (const std::size_t i : block.pixels) {
        error += pixels_[i].expected;
        highest = std::max(
            {highest, gain_of_samples(i), pixels_[i].expected / std::max(1e-12, pixel_seconds(i))});
      }
      highest = std::max(highest, error / std::max(1e-12, block.expected));
    }
    return highest;
  }

  void work(Block& block, double threshold) {
    if (schedule_.samples)
      for (const std::size_t i : block.pixels) sample(block, i, threshold);
    render(block, threshold);
  }

  void sample(Block& block, std::size_t i, double threshold) {
    Pixel& pixel = pixels_[i];
    while (!pixel.exact && pixel.round + 1 < of_.rounds.size() && gain_of_samples(i) > threshold) {
      const double seconds = sample_seconds(i);
      if (block.sampled_seconds + seconds > schedule_.most_samples * block.expected) return;
      block.sampled_seconds += seconds;
      seconds_ += seconds;
      ++pixel.round;
      set(i, of_.rounds[pixel.round].squared_error[i],
          std::max(expected(pixel.round, i), pixel.expected / 12.0));
    }
  }

  void render(Block& block, double threshold) {
    if (schedule_.exact == Schedule::Exact::blocks) render_block(block, threshold);
    if (schedule_.exact == Schedule::Exact::pixels) render_pixels(block, threshold);
  }

  void render_block(Block& block, double threshold) {
    if (block.visits > 0) return;
    double error = 0.0;
    for (const std::size_t i : block.pixels) error += pixels_[i].expected;
    if (threshold > 0.0 && !(error > threshold * block.expected)) return;
    ++block.visits;
    seconds_ += block.seconds;
    for (const std::size_t i : block.pixels) make_exact(i);
  }

  [[nodiscard]] double pixel_seconds(std::size_t i) const {
    return (1.0 - schedule_.search) * schedule_.dearer * of_.exact_seconds[i];
  }

  void render_pixels(Block& block, double threshold) {
    const double search = schedule_.search * block.seconds;
    const bool all = threshold == 0.0 || block.visits + 1 >= schedule_.visits;
    std::vector<std::size_t> chosen;
    double error = 0.0, seconds = search;
    const auto choose = [&](bool with_all) {
      for (const std::size_t i : block.pixels) {
        const Pixel& pixel = pixels_[i];
        if (pixel.exact || !(with_all || pixel.expected > threshold * pixel_seconds(i))) continue;
        chosen.push_back(i);
        error += pixel.expected;
        seconds += pixel_seconds(i);
      }
    };
    choose(all);
    if (chosen.empty() || (threshold > 0.0 && !(error > threshold * seconds))) return;
    ++block.visits;
    seconds_ += seconds;
    for (const std::size_t i : chosen) make_exact(i);
  }

  void make_exact(std::size_t i) {
    pixels_[i].exact = true;
    set(i, of_.exact_squared_error[i], 0.0);
  }

  void set(std::size_t i, double error, double expected) {
    squared_error_ += error - pixels_[i].error;
    pixels_[i].error = error;
    pixels_[i].expected = expected;
  }

  [[nodiscard]] CurvePoint now() const {
    const double mean = squared_error_ / static_cast<double>(pixels_.size());
    return {seconds_, std::sqrt(std::max(0.0, mean))};
  }
  void note() {
    if (seconds_ > curve_.back().seconds) curve_.push_back(now());
  }

  const MeasuredPicture& of_;
  const Schedule& schedule_;
  int across_;
  std::vector<Pixel> pixels_;
  std::vector<Block> blocks_;
  double seconds_;
  double squared_error_ = 0.0;
  std::vector<CurvePoint> curve_;
};

}  // namespace

std::vector<CurvePoint> replayed(const MeasuredPicture& picture, const Schedule& schedule) {
  return Replay(picture, schedule).run();
}

double replayed_error_at(const std::vector<CurvePoint>& curve, double seconds) {
  if (seconds <= curve.front().seconds) return curve.front().error;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const CurvePoint &a = curve[i - 1], &b = curve[i];
    if (seconds > b.seconds) continue;
    const double at = (seconds - a.seconds) / (b.seconds - a.seconds);
    return std::sqrt(a.error * a.error * (1.0 - at) + b.error * b.error * at);
  }
  return curve.back().error;
}

}  // namespace asos::bench
