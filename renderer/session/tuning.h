#pragma once

#include <chrono>
#include <cstddef>

/// The constants of a progressive render that were chosen by measurement. `docs/log/rounds.md` has
/// the measurements, under the heading named at each group. `bench anytime` repeats them.
namespace asos::tuning {

// Rounds of samples (SampleRounds): "Samples first, then blocks by gain".

/// Samples per pixel before single steps.
inline constexpr int samples_before_steps = 4;
/// Most samples of a pixel by steps.
inline constexpr int most_samples = 1 << 10;
/// Guessed time of all blocks relative to one sample per pixel; the median of 43 scenes.
inline constexpr double blocks_over_sample = 64.0;

// Single pixels (StepQueue): "Pixel by pixel".

/// Squared error of n samples over that of 4n.
inline constexpr float error_ratio = 8.0f;
/// Weight of the neighbours' maximum in a pixel's expected error.
inline constexpr float weight_of_neighbours = 0.6f;
/// Least expected error after a step, as a fraction of the one before.
inline constexpr float least_of_before = 1.0f / 12.0f;
/// Pixels with an expected error below this fraction of EPS wait for their block.
inline constexpr double fraction_of_eps = 0.5;
/// Most time of a block's single pixels, as a fraction of the block's. They end with the block: the
/// picture is finished that much later.
inline constexpr double fraction_of_block = 0.2;

// Times of blocks (StepQueue): "Expected times of blocks".

/// Time of a first stage relative to the expected one, before one was measured. The median of 12
/// scenes is 9; less keeps pictures of cheap blocks short.
inline constexpr double usual_start = 4.0;
/// Number of blocks that are rendered early to measure them.
inline constexpr int early_blocks = 4;
/// Most time of each of these, as a fraction of the time so far.
inline constexpr double fraction_of_early_block = 0.03;
/// Time of a second stage, in samples, for a squared error of 1, before one was measured.
inline constexpr double usual_finish = 4e5;
/// Power of the squared error in the time of a second stage.
inline constexpr double power_of_finish = 2.0 / 3.0;
/// Weight of a finished block relative to the next one, since times fall along with gains.
inline constexpr double weight_of_before = 0.98;

// Steps (StepQueue, RenderSteps): "Kept samples, and times of blocks".

/// Time that is planned at once, as a fraction of the time so far: short enough that the order
/// stays right, and long enough to fill packets of rays.
inline constexpr double fraction_of_plan = 0.1;
/// Longest step of samples, in seconds. A change of the camera waits for it.
inline constexpr double longest_step = 0.005;
/// Fewest samples of a step; fewer would leave packets of rays empty.
inline constexpr int least_samples = 256;
/// Most memory of started blocks, in bytes per pixel of the picture. Further blocks are finished at
/// once.
inline constexpr std::size_t bytes_a_pixel = 400;

// Estimated end (RunClock): "Samples first, then blocks by gain".

/// Time between two measurements of the pace.
inline constexpr std::chrono::milliseconds pace_step{100};
/// Time over which the pace is a mean.
inline constexpr std::chrono::seconds pace_window{10};
/// Least time before a pace is known.
inline constexpr std::chrono::milliseconds least_pace{250};

}  // namespace asos::tuning
