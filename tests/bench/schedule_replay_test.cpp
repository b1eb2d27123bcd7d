#include "tests/bench/schedule_replay.h"

#include <gtest/gtest.h>

#include <cmath>

// Replays of made-up pictures of two blocks, 16 x 8 pixels, whose curves follow by hand.

namespace asos::bench {
namespace {

constexpr std::size_t count = 128;
constexpr std::size_t noisy = 20;  // in the left block

/// Pixel `noisy` has a squared error of 1, 1/8, 1/64 after 1, 4, 16 samples. All others are right
/// from the start. Exact pixels have no error. Each block takes 6.4 s, a sample 0.01 s.
MeasuredPicture one_noisy_pixel() {
  MeasuredPicture picture{.width = 16, .height = 8};
  double error = 1.0;
  for (const int samples : {1, 4, 16}) {
    MeasuredPicture::Round round{samples, std::vector<double>(count, 0.0), {}};
    round.squared_error[noisy] = error;
    if (samples > 1) {
      round.changed.assign(count, 0.0);
      round.changed[noisy] = 6.0 * error;
    }
    picture.rounds.push_back(round);
    error /= 8.0;
  }
  picture.seconds = 2.0;
  picture.sample_seconds.assign(count, 0.01);
  picture.exact_squared_error.assign(count, 0.0);
  picture.exact_seconds.assign(count, 0.1);
  return picture;
}

double rmse(double squared_error) {
  return std::sqrt(squared_error / count);
}

TEST(ScheduleReplay, TakesSamplesOfPixelsWithError) {
  Schedule schedule{.exact = Schedule::Exact::none};
  const auto curve = replayed(one_noisy_pixel(), schedule);
  EXPECT_DOUBLE_EQ(curve.front().seconds, 2.0);
  EXPECT_DOUBLE_EQ(curve.front().error, rmse(1.0 / 8.0));
  // The eight neighbours are expected to have an error, too.
  EXPECT_NEAR(curve.back().seconds, 2.0 + 9 * 12 * 0.01, 1e-9);
  EXPECT_DOUBLE_EQ(curve.back().error, rmse(1.0 / 64.0));
  // The noisy pixel comes first: it has all of the gain.
  EXPECT_NEAR(replayed_error_at(curve, 2.0 + 12 * 0.01), rmse(1.0 / 64.0), 1e-9);
}

TEST(ScheduleReplay, LimitsSamplesByTheTimeOfTheirBlock) {
  Schedule schedule{.exact = Schedule::Exact::none};
  schedule.most_samples = 0.05;  // 0.32 s of a block: two pixels
  const auto curve = replayed(one_noisy_pixel(), schedule);
  EXPECT_NEAR(curve.back().seconds, 2.0 + 2 * 12 * 0.01, 1e-9);
}

// The left block's expected time is 12.8 s * (1 + r) / (2 + r). r, the sum of its errors' roots, is
// 0.38^(1/4) + 8 * 0.23^(1/4) = 6.3.
TEST(ScheduleReplay, ExpectsMoreTimeOfABlockWithErrors) {
  Schedule schedule{.exact = Schedule::Exact::none, .times_known = false};
  schedule.most_samples = 0.05;  // 0.56 s of the left block: four pixels
  const auto curve = replayed(one_noisy_pixel(), schedule);
  EXPECT_NEAR(curve.back().seconds, 2.0 + 4 * 12 * 0.01, 1e-9);
}

TEST(ScheduleReplay, RendersTheBlockWithTheErrorFirst) {
  Schedule schedule{.samples = false};
  const auto curve = replayed(one_noisy_pixel(), schedule);
  EXPECT_NEAR(curve.back().seconds, 2.0 + 2 * 6.4, 1e-9);
  EXPECT_NEAR(replayed_error_at(curve, 2.0 + 6.4), 0.0, 1e-6);
  EXPECT_NEAR(replayed_error_at(curve, 2.0 + 3.2), rmse(1.0 / 16.0), 1e-9) << "half of the gain";
}

TEST(ScheduleReplay, RendersExactPixelsAfterASearchOfTheirBlock) {
  Schedule schedule{
      .samples = false, .exact = Schedule::Exact::pixels, .search = 0.1, .dearer = 2.0};
  const auto curve = replayed(one_noisy_pixel(), schedule);
  const double search = 0.64, pixel = 0.9 * 2.0 * 0.1;
  // First the pixel with its neighbours, or the pixel alone; then the rest of both blocks.
  EXPECT_LE(curve[1].seconds, 2.0 + search + 9 * pixel + 1e-9);
  EXPECT_NEAR(curve[1].error, 0.0, 1e-6);
  EXPECT_GE(curve.back().seconds, 2.0 + 3 * search + count * pixel - 1e-9);
  EXPECT_LE(curve.back().seconds, 2.0 + 4 * search + count * pixel + 1e-9);
}

TEST(ScheduleReplay, VisitsABlockAtMostSoManyTimes) {
  Schedule schedule{.samples = false, .exact = Schedule::Exact::pixels, .search = 0.1, .visits = 1};
  const auto curve = replayed(one_noisy_pixel(), schedule);
  EXPECT_NEAR(curve.back().seconds, 2.0 + 2 * 0.64 + count * 0.09, 1e-9);
}

// A cheap exact block comes before samples, an expensive one after them.
TEST(ScheduleReplay, ComparesExactWorkWithSamples) {
  MeasuredPicture cheap = one_noisy_pixel(), dear = one_noisy_pixel();
  cheap.exact_seconds.assign(count, 0.001);
  const auto before = replayed(cheap, {}), after = replayed(dear, {});
  EXPECT_NEAR(before.back().seconds, 2.0 + count * 0.001, 1e-9);
  EXPECT_NEAR(after.back().seconds, 2.0 + 9 * 12 * 0.01 + count * 0.1, 1e-9);
}

}  // namespace
}  // namespace asos::bench
