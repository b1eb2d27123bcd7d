#pragma once

#include "renderer/session/work_plan.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace asos {

class SampleRounds;

/// A piece of work on a picture.
struct Step {
  enum class Kind {
    samples,  ///< takes pixels from n to 4n samples
    start,    ///< renders the first stage of a block by the method
    finish,   ///< finishes a started block
  };
  Kind kind = Kind::samples;
  std::vector<PlannedPixel> pixels;  ///< of Kind::samples
  std::size_t block = 0;             ///< of the other kinds
  double gain = 0.0;                 ///< expected, see StepQueue
  double seconds = 0.0;              ///< expected processor time
};

/// Orders the steps of a picture after its first samples. First come those with the largest gain:
/// the expected reduction of the squared error, summed over pixels, per second of processor time.
/// Errors are of linear radiance clipped to 0..1. Steps with equal gain, such as blocks without
/// expected error, come in an order that is spread over the picture.
///
/// - The expected squared error of a pixel with n samples is a sixth of the squared change since it
///   had n / 4. Its neighbours' maximum counts for 0.6, since pixels may agree by chance. It is at
///   least a twelfth of what was expected before.
/// - The expected time of a block grows with the time of its samples and with the sum of its
///   pixels' expected errors, each as the root of the absolute error. Finished blocks give the
///   factor.
///
/// Handles the order alone and renders nothing. One thread at a time.
class StepQueue {
 public:
  /// `eps`: pixels whose expected error is below a fraction of it take no more samples, since their
  /// blocks will be rendered.
  StepQueue(const WorkPlan& plan, double eps);

  /// Sets the expected errors by the samples after the last round. Without it, all blocks come in
  /// spread order.
  void begin(const SampleRounds& samples);
  [[nodiscard]] bool begun() const { return begun_; }

  /// Renders the blocks that touch this part of the picture before all others, once blocks can be
  /// rendered; empty: in the usual order.
  void prefer(const PixelRect& part);

  /// Takes the next step; none while it depends on steps that are taken and not done. `blocks`: the
  /// method's blocks can be rendered by now. Until then pixels take samples however small their
  /// error is.
  [[nodiscard]] std::optional<Step> take(bool blocks);
  /// The new number of samples of a pixel, and PixelSamples::moved.
  struct Sampled {
    int taken = 0;
    float moved = 0.0f;
  };
  /// Call when a step is done after this processor time. `sampled`: its pixels' samples.
  void done(const Step& step, double seconds, std::span<const Sampled> sampled = {});
  /// Call when the first stage of a block left an expected squared error.
  void open(std::size_t block, double squared_error);

  /// Returns whether all blocks are final.
  [[nodiscard]] bool finished() const { return blocks_left_ == 0; }
  /// Returns the expected processor time of all further steps; none before a block was measured.
  [[nodiscard]] std::optional<double> seconds_left() const;

 private:
  /// A pixel with its samples.
  struct Pixel {
    float moved = 0.0f;     // a sixth of its change
    float expected = 0.0f;  // squared error
    std::uint16_t taken = 0;
    bool busy = false;
  };
  enum class State : std::uint8_t { waiting, taken, open, done };
  struct Block {
    State state = State::waiting;
    double relative = 0.0;         // expected time of the first stage, up to a common factor
    double error = 0.0;            // expected squared error of an open block
    double sample_seconds = 0.0;   // of steps of its pixels
    double relative_finish = 0.0;  // expected time of the second stage, up to a common factor
  };
  struct Ratio {
    double measured = 0.0;
    double expected = 0.0;

    /// Adds the latest block: its time, and its relative time.
    void add(double seconds, double relative);
  };
  /// The costs of steps of similar gain.
  static constexpr std::size_t classes = 2048;

  [[nodiscard]] Pixel& pixel(int x, int y);
  [[nodiscard]] const Pixel& pixel(int x, int y) const;
  [[nodiscard]] float expected_error(int x, int y) const;
  [[nodiscard]] PixelRect visible(std::size_t block) const;
  [[nodiscard]] double start_seconds(std::size_t block) const;
  [[nodiscard]] double relative_finish(std::size_t block, double squared_error) const;
  [[nodiscard]] double finish_seconds(std::size_t block) const;
  [[nodiscard]] double sample_seconds(std::size_t block, const Pixel& pixel) const;
  [[nodiscard]] double error_of(std::size_t block) const;
  [[nodiscard]] double most_seconds(std::size_t block) const;
  /// Calls `see(pixel, x, y, gain, seconds)` for each pixel of a block that can take samples.
  template <typename See>
  void each_pixel(std::size_t block, bool blocks, const See& see) const;
  [[nodiscard]] std::optional<Step> take_preferred();
  void forget_plan();
  void plan(bool blocks);
  [[nodiscard]] std::size_t least_class(bool blocks);
  void plan_pixels(std::span<const PlannedPixel> pixels, bool blocks);
  void expect_seconds();
  void measure_blocks();
  void plan_in_spread_order();
  void plan_step(Step::Kind kind, std::size_t block, double gain);

  const WorkPlan* plan_;
  double floor_;  // squared error
  bool begun_ = false;
  std::vector<Pixel> pixels_;  // of the visible part
  std::vector<Block> blocks_;
  std::vector<double> seconds_a_sample_;  // by group
  std::vector<std::size_t> spread_;       // blocks in spread order
  std::size_t next_spread_ = 0;
  std::size_t blocks_left_;
  Ratio starts_;    // seconds of the latest first stages, and their relative times
  Ratio opened_;    // relative times of second stages by their errors, and by those before
  Ratio finishes_;  // seconds of second stages, and their relative times
  Ratio samples_;   // seconds of sample steps, and those at the pace of the rounds
  double first_stages_ = 0.0;  // seconds
  double spent_ = 0.0;         // seconds of all steps and rounds
  int measured_ = 0;           // blocks that were rendered early
  double left_ = 0.0;          // expected seconds
  bool planned_ = false;       // left_ is known
  std::array<double, classes> seconds_by_class_{};
  std::vector<Step> ready_;            // the last is the next
  std::deque<std::size_t> preferred_;  // blocks that may not be final yet
};

}  // namespace asos
