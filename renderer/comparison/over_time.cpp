#include "renderer/comparison/over_time.h"

#include "renderer/comparison/method.h"
#include "renderer/film/layer_mean.h"
#include "renderer/film/tone.h"
#include "renderer/pyray/error_budget.h"
#include "renderer/samples/sample_sums.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace asos {
namespace {

// Longest motion between two moments, in pixels, after which a surface that crosses a block is in
// it at one of them or half-way.
constexpr double longest_way = 4.0;
constexpr int probed_moments = 5;
// Samples of two moments differ by less than this many EPS, where their standard errors are EPS
// / 2.
constexpr double sampling_noise = 4.0;
constexpr unsigned seed_step = 0x9e3779b1u;

/// Raises the counts of pixels to those of one moment: the exposure has the largest.
void take_larger_counts(const RenderStatistics& moment, RenderStatistics& all) {
  all.split_pixels = std::max(all.split_pixels, moment.split_pixels);
  all.missed_splits = std::max(all.missed_splits, moment.missed_splits);
  all.uneven_pixels = std::max(all.uneven_pixels, moment.uneven_pixels);
  all.saturated_pixels = std::max(all.saturated_pixels, moment.saturated_pixels);
  for (std::size_t i = 0; i < all.pixels_by_cause.size(); ++i)
    all.pixels_by_cause[i] = std::max(all.pixels_by_cause[i], moment.pixels_by_cause[i]);
}

class BlockOverTime {
 public:
  BlockOverTime(const BlockJob& job, const MethodRow& row)
      : job_(job), row_(row), steps_(job.motion->steps()) {}

  BlockResult run() {
    if (stands_still()) return row_.render(job_.at(steps_ / 2));
    if (jumps()) return sampled();
    const Shot first = shot(0), last = shot(steps_);
    result_ = std::move(newest_);  // the latest shot has all arrays of the method
    sum_.assign(first.colours.size(), glm::dvec3(0.0));
    bisect({0, &first}, {steps_, &last});
    for (std::size_t i = 0; i < sum_.size(); ++i) result_.tile.radiance[i] = glm::vec3(sum_[i]);
    note_motion();
    result_.tile.split_level = std::move(level_);
    result_.tile.cause = std::move(cause_);
    result_.tile.rays = std::move(rays_);
    result_.tile.layers = layers_.planes(job_.settings.layers);
    result_.statistics = std::move(statistics_);
    result_.statistics.unresolved_area /= shots_;
    return std::move(result_);
  }

 private:
  using Colours = std::vector<glm::vec3>;
  struct Shot {
    Colours colours;
    std::vector<LayerPlane> layers;
  };
  struct Moment {
    int number;
    const Shot* shot;
  };

  // Returns whether neither surfaces nor the samples at the pixels' centres change.
  [[nodiscard]] bool stands_still() const {
    if (job_.motion->crosses(job_.block, 0, steps_)) return false;
    std::vector<glm::dvec3> before;
    for (int i = 0; i < probed_moments; ++i) {
      const BlockJob at = job_.at(i * steps_ / (probed_moments - 1));
      GridSampler places(1, false);
      SampleSums sums(at, places);
      const PixelRect& block = job_.block;
      sums.resize(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
      std::size_t pixel = 0;
      for (int y = block.y; y < block.y + block.height; ++y)
        for (int x = block.x; x < block.x + block.width; ++x)
          (void)sums.add({{x + 0.5, y + 0.5}, 1.0f, x, y, 0, pixel++});
      sums.trace();
      std::vector<glm::dvec3> now;
      for (std::size_t k = 0; k < pixel; ++k) now.push_back(sums.sum(k).radiance);
      if (i > 0 && now != before) return false;
      before = std::move(now);
    }
    return true;
  }

  // Returns whether a surface that may cross the block moves too far between moments.
  [[nodiscard]] bool jumps() const {
    return job_.motion->way(0, 1) > Exposure::longest_step &&
           job_.motion->crosses(job_.block, 0, steps_) && job_.motion->rays();
  }

  // Renders the block by samples with times of their own.
  [[nodiscard]] BlockResult sampled() const {
    BlockResult block = row_of(Method::sobol_adaptive).render(job_);
    const std::size_t pixels = block.tile.radiance.size();
    block.tile.cause.assign(pixels, SplitCause::motion);
    block.statistics.split_pixels = pixels;
    block.statistics.pixels_by_cause = {};
    block.statistics.pixels_by_cause[static_cast<std::size_t>(SplitCause::motion)] = pixels;
    return block;
  }

  // Each moment has samples of its own, so that their errors average out.
  Shot shot(int moment) {
    RenderSettings settings = job_.settings;
    settings.seed = static_cast<int>(
        (static_cast<unsigned>(settings.seed) + static_cast<unsigned>(moment) * seed_step) &
        0x7fffffffu);
    settings.layers = LayerMean::needed(settings.layers);
    newest_ = row_.render(job_.at(moment).with(settings));
    const FinishedTile& tile = newest_.tile;
    statistics_ += counted();
    take_larger_counts(newest_.statistics, statistics_);
    ++shots_;
    level_.resize(tile.radiance.size());
    cause_.resize(tile.radiance.size());
    widen_ranges(tile.radiance);
    for (std::size_t i = 0; i < tile.split_level.size(); ++i) {
      if (shots_ > 1 && tile.split_level[i] <= level_[i]) continue;
      level_[i] = tile.split_level[i];
      if (i < tile.cause.size()) cause_[i] = tile.cause[i];
    }
    rays_.resize(tile.rays.size());
    for (std::size_t i = 0; i < tile.rays.size(); ++i) rays_[i] += tile.rays[i];
    return {tile.radiance, std::exchange(newest_.tile.layers, {})};
  }

  // Adds a shot's colours, as displayed, to the ranges of the pixels' colours.
  void widen_ranges(const Colours& colours) {
    darkest_.resize(colours.size(), glm::dvec3(std::numeric_limits<double>::infinity()));
    brightest_.resize(colours.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i < colours.size(); ++i) {
      const glm::dvec3 shown =
          displayed_intensity(glm::dvec3(colours[i]), job_.settings.judged_tone);
      darkest_[i] = glm::min(darkest_[i], shown);
      brightest_[i] = glm::max(brightest_[i], shown);
    }
  }

  // Motion is the cause of pixels that it changes, whatever splits them at one moment.
  void note_motion() {
    if (newest_.tile.cause.empty()) return;
    const double change = std::max(sampling_noise * job_.settings.asos.eps, ErrorBudget::invisible);
    statistics_.split_pixels = 0;
    statistics_.pixels_by_cause = {};
    for (std::size_t i = 0; i < cause_.size(); ++i) {
      const glm::dvec3 range = brightest_[i] - darkest_[i];
      if (std::max({range.x, range.y, range.z}) > change) cause_[i] = SplitCause::motion;
      if (cause_[i] == SplitCause::none) continue;
      ++statistics_.split_pixels;
      ++statistics_.pixels_by_cause[static_cast<std::size_t>(cause_[i])];
    }
  }

  // Returns the newest shot's statistics, without the counts of pixels.
  [[nodiscard]] RenderStatistics counted() const {
    RenderStatistics all = newest_.statistics;
    all.split_pixels = all.missed_splits = all.uneven_pixels = all.saturated_pixels = 0;
    all.pixels_by_cause = {};
    return all;
  }

  void bisect(Moment from, Moment to) {
    if (job_.stop.stop_requested()) return;
    const int number = (from.number + to.number) / 2;
    const Shot centre = shot(number);
    const Moment middle{number, &centre};
    if (to.number - from.number > 2 && goes_on(from, middle, to)) {
      bisect(from, middle);
      bisect(middle, to);
      return;
    }
    const double weight = static_cast<double>(to.number - from.number) / (4.0 * steps_);
    for (std::size_t i = 0; i < sum_.size(); ++i)
      sum_[i] += weight * (glm::dvec3(from.shot->colours[i]) + 2.0 * glm::dvec3(centre.colours[i]) +
                           glm::dvec3(to.shot->colours[i]));
    layers_.add(from.shot->layers, weight);
    layers_.add(centre.layers, 2.0 * weight);
    layers_.add(to.shot->layers, weight);
  }

  [[nodiscard]] bool goes_on(Moment from, Moment middle, Moment to) const {
    const MovingPicture& motion = *job_.motion;
    const bool crossed = motion.crosses(job_.block, from.number, to.number);
    if (crossed && motion.way(from.number, to.number) > longest_way) return true;
    // A shadow may pass in between.
    if (!crossed && to.number - from.number == steps_) return true;
    const double weight = static_cast<double>(to.number - from.number) / steps_;
    // If both halves are integrated as trapezoids, the error is at most a quarter of the deviation.
    const double tolerance = 2.0 * job_.settings.asos.eps;
    for (std::size_t i = 0; i < middle.shot->colours.size(); ++i) {
      const glm::dvec3 ends =
          0.5 * (glm::dvec3(from.shot->colours[i]) + glm::dvec3(to.shot->colours[i]));
      const glm::dvec3 off = glm::abs(
          displayed_intensity(ends, job_.settings.judged_tone) -
          displayed_intensity(glm::dvec3(middle.shot->colours[i]), job_.settings.judged_tone));
      if (weight * std::max({off.x, off.y, off.z}) > tolerance) return true;
    }
    return false;
  }

  const BlockJob& job_;
  const MethodRow& row_;
  int steps_;
  int shots_ = 0;
  BlockResult newest_, result_;
  RenderStatistics statistics_;
  std::vector<std::uint8_t> level_;
  std::vector<SplitCause> cause_;
  std::vector<glm::dvec3> darkest_, brightest_;
  std::vector<float> rays_;
  std::vector<glm::dvec3> sum_;
  LayerMean layers_;
};

}  // namespace

BlockResult render_over_time(const BlockJob& job, const MethodRow& row) {
  return BlockOverTime(job, row).run();
}

}  // namespace asos
