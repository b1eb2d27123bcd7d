#include "renderer/session/step_queue.h"

#include "renderer/session/sample_rounds.h"
#include "renderer/session/tuning.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace asos {
namespace {

using namespace tuning;

double ratio_or(double a, double b, double otherwise) {
  return b > 0.0 ? a / b : otherwise;
}

/// Returns the squared error that a step removes per second; 0 if it removes none. Steps of blocks
/// that took no measurable time can have an infinite gain.
double gain_of(double error, double seconds) {
  return error > 0.0 ? error / seconds : 0.0;
}

/// Gains that are not negative in classes of a ratio of at most 9/8, by the leading bits of the
/// number.
std::size_t class_of(double gain) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(gain)) >> 20;
}

}  // namespace

void StepQueue::Ratio::add(double seconds, double relative) {
  measured = weight_of_before * measured + seconds;
  expected = weight_of_before * expected + relative;
}

StepQueue::StepQueue(const WorkPlan& plan, double eps)
    : plan_(&plan),
      floor_(fraction_of_eps * eps * fraction_of_eps * eps),
      blocks_(plan.blocks.size()),
      spread_(plan.spread_blocks()),
      blocks_left_(plan.blocks.size()) {}

StepQueue::Pixel& StepQueue::pixel(int x, int y) {
  const PixelRect& all = plan_->visible;
  return pixels_[static_cast<std::size_t>(y - all.y) * static_cast<std::size_t>(all.width) +
                 static_cast<std::size_t>(x - all.x)];
}

const StepQueue::Pixel& StepQueue::pixel(int x, int y) const {
  return const_cast<StepQueue*>(this)->pixel(x, y);
}

PixelRect StepQueue::visible(std::size_t block) const {
  return intersection(plan_->blocks[block].rect, plan_->visible);
}

void StepQueue::begin(const SampleRounds& samples) {
  begun_ = true;
  const PixelRect& all = plan_->visible;
  pixels_.resize(static_cast<std::size_t>(all.width) * static_cast<std::size_t>(all.height));
  for (std::size_t g = 0; g < plan_->groups.size(); ++g) {
    const PixelSamples& group = samples.pixels(g);
    const auto taken =
        static_cast<double>(group.taken()) * static_cast<double>(group.pixel_count());
    seconds_a_sample_.push_back(samples.seconds(g) / taken);
    spent_ += samples.seconds(g);
    const PixelRect part = intersection(plan_->groups[g].rect, all);
    for (int y = part.y; y < part.y + part.height; ++y) {
      for (int x = part.x; x < part.x + part.width; ++x) {
        const std::size_t i = group.index(x, y);
        pixel(x, y) = {group.moved(i) / 6.0f, 0.0f, static_cast<std::uint16_t>(group.taken(i))};
      }
    }
  }
  for (int y = all.y; y < all.y + all.height; ++y)
    for (int x = all.x; x < all.x + all.width; ++x) pixel(x, y).expected = expected_error(x, y);
  expect_seconds();
}

void StepQueue::expect_seconds() {
  double mean = 0.0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const PixelRect rect = visible(b);
    double roots = 0.0;
    for (int y = rect.y; y < rect.y + rect.height; ++y)
      for (int x = rect.x; x < rect.x + rect.width; ++x)
        roots += std::sqrt(std::sqrt(static_cast<double>(pixel(x, y).expected)));
    const WorkPlan::Block& of = plan_->blocks[b];
    blocks_[b].relative =
        of.rect.width * of.rect.height * seconds_a_sample_[of.group] * (1.0 + roots);
    mean += blocks_[b].relative / static_cast<double>(blocks_.size());
  }
  starts_.add(usual_start * mean, mean);  // as if one block had been measured
}

// Returns the expected squared error of a pixel from its own change and those of its neighbours,
// scaled to its number of samples.
float StepQueue::expected_error(int x, int y) const {
  const PixelRect& all = plan_->visible;
  const Pixel& own = pixel(x, y);
  float largest = own.moved;
  for (int v = std::max(all.y, y - 1); v <= std::min(all.y + all.height - 1, y + 1); ++v) {
    for (int u = std::max(all.x, x - 1); u <= std::min(all.x + all.width - 1, x + 1); ++u) {
      const Pixel& other = pixel(u, v);
      float there = other.moved;
      for (int n = other.taken; n < own.taken; n *= 4) there /= error_ratio;
      for (int n = own.taken; n < other.taken; n *= 4) there *= error_ratio;
      largest = std::max(largest, there);
    }
  }
  return weight_of_neighbours * largest + (1.0f - weight_of_neighbours) * own.moved;
}

double StepQueue::start_seconds(std::size_t block) const {
  return blocks_[block].relative * ratio_or(starts_.measured, starts_.expected, usual_start);
}

double StepQueue::relative_finish(std::size_t block, double squared_error) const {
  return seconds_a_sample_[plan_->blocks[block].group] * std::pow(squared_error, power_of_finish);
}

double StepQueue::finish_seconds(std::size_t block) const {
  return blocks_[block].relative_finish *
         ratio_or(finishes_.measured, finishes_.expected, usual_finish);
}

double StepQueue::sample_seconds(std::size_t block, const Pixel& of) const {
  return 3.0 * of.taken * seconds_a_sample_[plan_->blocks[block].group] *
         ratio_or(samples_.measured, samples_.expected, 1.0);
}

double StepQueue::error_of(std::size_t block) const {
  const PixelRect rect = visible(block);
  double sum = 0.0;
  for (int y = rect.y; y < rect.y + rect.height; ++y)
    for (int x = rect.x; x < rect.x + rect.width; ++x)
      sum += static_cast<double>(pixel(x, y).expected);
  return sum;
}

// Returns the time that the samples of a block's pixels may still take.
double StepQueue::most_seconds(std::size_t block) const {
  return fraction_of_block * start_seconds(block) - blocks_[block].sample_seconds;
}

template <typename See>
void StepQueue::each_pixel(std::size_t block, bool blocks, const See& see) const {
  const PixelRect rect = visible(block);
  const double floor = blocks ? floor_ : 0.0;
  const double most = blocks ? most_seconds(block) : std::numeric_limits<double>::infinity();
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      const Pixel& of = pixel(x, y);
      if (of.busy || static_cast<double>(of.expected) <= floor || of.taken >= most_samples)
        continue;
      const double seconds = sample_seconds(block, of);
      if (seconds > most) continue;
      see(of, x, y, gain_of(static_cast<double>(of.expected) * (1.0 - 1.0 / error_ratio), seconds),
          seconds);
    }
  }
}

// Returns the least class of gains to plan for: enough steps for a fraction of the time so far.
std::size_t StepQueue::least_class(bool blocks) {
  seconds_by_class_.fill(0.0);
  planned_ = true;
  const auto count = [&](double gain, double seconds) {
    seconds_by_class_[class_of(gain)] += seconds;
  };
  left_ = 0.0;
  // Seconds of second stages, if their errors are related to those before as the ones so far.
  const double finishes = ratio_or(opened_.measured, opened_.expected, 0.0) *
                          ratio_or(finishes_.measured, finishes_.expected, usual_finish);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Block& block = blocks_[b];
    if (block.state == State::open) {
      const double seconds = finish_seconds(b);
      left_ += seconds;
      count(gain_of(block.error, seconds), seconds);
    }
    if (block.state != State::waiting) continue;
    const double seconds = start_seconds(b), error = error_of(b), gain = gain_of(error, seconds);
    left_ += seconds + finishes * relative_finish(b, error);
    if (blocks) count(gain, seconds);
    double samples = 0.0;  // to expect before the block is rendered
    each_pixel(b, blocks, [&](const Pixel&, int, int, double gain_of_samples, double cost) {
      count(gain_of_samples, cost);
      if (gain_of_samples > gain) samples += cost;
    });
    left_ += std::min(samples, std::max(0.0, most_seconds(b)));
  }
  std::size_t least = classes - 1;
  double seconds = seconds_by_class_[least];
  while (least > 1 && seconds < fraction_of_plan * spent_) seconds += seconds_by_class_[--least];
  return least;
}

void StepQueue::plan_step(Step::Kind kind, std::size_t block, double gain) {
  Step step;
  step.kind = kind;
  step.block = block;
  step.gain = gain;
  step.seconds = kind == Step::Kind::start ? start_seconds(block) : finish_seconds(block);
  blocks_[block].state = State::taken;
  ready_.push_back(std::move(step));
}

// Plans the first blocks in spread order that have an error: they tell the time of all.
void StepQueue::measure_blocks() {
  for (const std::size_t b : spread_) {
    if (measured_ >= early_blocks) return;
    if (blocks_[b].state != State::waiting || !(error_of(b) > 0.0)) continue;
    if (start_seconds(b) > fraction_of_early_block * spent_) return;
    plan_step(Step::Kind::start, b, std::numeric_limits<double>::infinity());
    ++measured_;
    return;
  }
}

void StepQueue::plan(bool blocks) {
  if (begun_ && blocks) measure_blocks();
  const std::size_t least = begun_ ? least_class(blocks) : 0;
  std::vector<PlannedPixel> pixels;
  int samples = 0;
  for (std::size_t b = 0; begun_ && b < blocks_.size(); ++b) {
    const Block& block = blocks_[b];
    if (block.state == State::open) {
      const double gain = gain_of(block.error, finish_seconds(b));
      if (gain > 0.0 && class_of(gain) >= least) plan_step(Step::Kind::finish, b, gain);
    }
    if (block.state != State::waiting) continue;
    const double gain = gain_of(error_of(b), start_seconds(b));
    if (blocks && gain > 0.0 && class_of(gain) >= least) {
      plan_step(Step::Kind::start, b, gain);
      continue;
    }
    each_pixel(b, blocks, [&](const Pixel& of, int x, int y, double gain_of_samples, double) {
      if (class_of(gain_of_samples) < least) return;
      pixels.push_back({static_cast<std::uint32_t>(b), x, y});
      samples += 3 * of.taken;
    });
  }
  if (samples >= least_samples || ready_.empty()) plan_pixels(pixels, blocks);
  if (ready_.empty() && blocks) plan_in_spread_order();
  std::stable_sort(ready_.begin(), ready_.end(),
                   [](const Step& a, const Step& b) { return a.gain < b.gain; });
}

// Divides pixels, which come block by block, into steps.
void StepQueue::plan_pixels(std::span<const PlannedPixel> pixels, bool blocks) {
  Step step;
  const auto end = [&] {
    if (step.pixels.empty()) return;
    step.gain /= step.seconds;
    ready_.push_back(std::exchange(step, {}));
  };
  for (const PlannedPixel& p : pixels) {
    Pixel& of = pixel(p.x, p.y);
    const double seconds = sample_seconds(p.block, of);
    if (blocks && seconds > most_seconds(p.block)) continue;
    blocks_[p.block].sample_seconds += seconds;
    of.busy = true;
    step.pixels.push_back(p);
    step.seconds += seconds;
    step.gain += static_cast<double>(of.expected) * (1.0 - 1.0 / error_ratio);
    if (step.seconds >= longest_step) end();
  }
  end();
}

// Plans blocks without expected gain.
void StepQueue::plan_in_spread_order() {
  double seconds = 0.0;
  for (; next_spread_ < spread_.size(); ++next_spread_) {
    if (blocks_[spread_[next_spread_]].state != State::waiting) continue;
    if (!ready_.empty() && (!begun_ || seconds >= fraction_of_plan * spent_)) return;
    plan_step(Step::Kind::start, spread_[next_spread_], 0.0);
    seconds += ready_.back().seconds;
  }
  for (std::size_t b = 0; ready_.empty() && b < blocks_.size(); ++b)
    if (blocks_[b].state == State::open) plan_step(Step::Kind::finish, b, 0.0);
}

void StepQueue::prefer(const PixelRect& part) {
  preferred_.clear();
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    if (!intersection(visible(b), part).empty()) preferred_.push_back(b);
  forget_plan();
}

// Puts planned steps back, since other blocks come first.
void StepQueue::forget_plan() {
  for (const Step& step : ready_) {
    for (const PlannedPixel& p : step.pixels) {
      Pixel& of = pixel(p.x, p.y);
      of.busy = false;
      blocks_[p.block].sample_seconds -= sample_seconds(p.block, of);
    }
    if (step.kind == Step::Kind::start) blocks_[step.block].state = State::waiting;
    if (step.kind == Step::Kind::finish) blocks_[step.block].state = State::open;
  }
  ready_.clear();
  next_spread_ = 0;
}

// Takes a block of the preferred part. One that a thread works on may still have a second stage.
std::optional<Step> StepQueue::take_preferred() {
  for (std::size_t left = preferred_.size(); left > 0; --left) {
    const std::size_t b = preferred_.front();
    const State state = blocks_[b].state;
    preferred_.pop_front();
    if (state != State::done && state != State::open) preferred_.push_back(b);
    if (state != State::waiting && state != State::open) continue;
    plan_step(state == State::waiting ? Step::Kind::start : Step::Kind::finish, b, 0.0);
    Step step = std::move(ready_.back());
    ready_.pop_back();
    return step;
  }
  return std::nullopt;
}

std::optional<Step> StepQueue::take(bool blocks) {
  if (blocks)
    if (std::optional<Step> step = take_preferred()) return step;
  if (ready_.empty()) plan(blocks);
  if (ready_.empty()) return std::nullopt;
  Step step = std::move(ready_.back());
  ready_.pop_back();
  return step;
}

void StepQueue::done(const Step& step, double seconds, std::span<const Sampled> sampled) {
  spent_ += seconds;
  left_ -= step.seconds;
  if (step.kind == Step::Kind::samples) {
    for (const PlannedPixel& p : step.pixels)
      samples_.expected +=
          3.0 * pixel(p.x, p.y).taken * seconds_a_sample_[plan_->blocks[p.block].group];
    samples_.measured += seconds;
  }
  for (std::size_t i = 0; i < sampled.size(); ++i) {
    Pixel& of = pixel(step.pixels[i].x, step.pixels[i].y);
    of.taken = static_cast<std::uint16_t>(sampled[i].taken);
    of.moved = sampled[i].moved / 6.0f;
    of.busy = false;
  }
  for (std::size_t i = 0; i < sampled.size(); ++i) {
    const PlannedPixel& p = step.pixels[i];
    Pixel& of = pixel(p.x, p.y);
    of.expected = std::max(expected_error(p.x, p.y), least_of_before * of.expected);
  }
  if (step.kind == Step::Kind::samples) return;
  Block& block = blocks_[step.block];
  block.state = State::done;
  --blocks_left_;
  if (step.kind == Step::Kind::finish) {
    finishes_.add(seconds, block.relative_finish);
    return;
  }
  first_stages_ += seconds;
  if (begun_) opened_.add(0.0, relative_finish(step.block, error_of(step.block)));
  starts_.add(seconds, block.relative);
}

void StepQueue::open(std::size_t block, double squared_error) {
  blocks_[block].state = State::open;
  blocks_[block].error = squared_error;
  ++blocks_left_;
  if (!begun_) return;
  blocks_[block].relative_finish = relative_finish(block, squared_error);
  opened_.measured += blocks_[block].relative_finish;
}

std::optional<double> StepQueue::seconds_left() const {
  if (first_stages_ == 0.0) return std::nullopt;
  if (begun_ && planned_) return std::max(0.0, left_);
  // Blocks in spread order: the mean of all predicts the others.
  const auto done = static_cast<double>(blocks_.size() - blocks_left_);
  return first_stages_ / std::max(1.0, done) * static_cast<double>(blocks_left_);
}

}  // namespace asos
