#include "ui/draw_schedule.h"

#include <gtest/gtest.h>

namespace asos {
using namespace ui;
namespace {

// Draws the frame that is due at `now`.
void draw(DrawSchedule& schedule, double now, std::optional<double> wish = std::nullopt) {
  ASSERT_GE(now, schedule.due());
  schedule.begin_frame(now);
  schedule.end_frame(now, wish);
}

TEST(DrawSchedule, SleepsWhileNothingHappens) {
  DrawSchedule schedule;
  EXPECT_LE(schedule.due(), 0.0) << "the first frame";
  draw(schedule, 0.0);
  EXPECT_EQ(schedule.due(), DrawSchedule::never);
}

TEST(DrawSchedule, InputIsFollowedAtOnceAndSettles) {
  DrawSchedule schedule;
  draw(schedule, 0.0);
  schedule.note_input();
  EXPECT_NEAR(schedule.due(), 1.0 / 60.0, 1e-9);
  draw(schedule, 5.0);
  EXPECT_NEAR(schedule.due(), 5.05, 1e-9) << "a new layout needs a second frame";
  draw(schedule, 5.05);
  EXPECT_EQ(schedule.due(), DrawSchedule::never);
}

TEST(DrawSchedule, TilesAreShownSeldomUnlessTheyAreWaitedFor) {
  DrawSchedule schedule;
  draw(schedule, 1.0);
  schedule.note_woken(false);
  EXPECT_NEAR(schedule.due(), 1.05, 1e-9);
  schedule.note_woken(true);
  EXPECT_NEAR(schedule.due(), 1.0 + 1.0 / 60.0, 1e-9);
}

// With software OpenGL frames are slow. In a row they would take the time of the workers, and input
// would wait for them.
TEST(DrawSchedule, TilesTakeAThirdOfTheTimeAtMost) {
  DrawSchedule schedule;
  schedule.begin_frame(1.0);
  schedule.end_frame(1.04, std::nullopt);
  schedule.note_woken(false);
  EXPECT_NEAR(schedule.due(), 1.12, 1e-9);
  schedule.note_input();
  EXPECT_NEAR(schedule.due(), 1.0 + 1.0 / 60.0, 1e-9) << "input is drawn at once";
  schedule.begin_frame(1.12);
  schedule.end_frame(1.13, std::nullopt);
  schedule.note_woken(false);
  EXPECT_NEAR(schedule.due(), 1.17, 1e-9) << "fast frames are drawn 20 times a second";
}

// A job that is polled every tenth of a second may end in between. Then no frame is requested any
// more, but the end has to be shown.
TEST(DrawSchedule, DrawsRequestedFrameEvenIfItsReasonIsGone) {
  DrawSchedule schedule;
  draw(schedule, 0.0, 0.1);
  EXPECT_NEAR(schedule.due(), 0.1, 1e-9);
  draw(schedule, 0.1, std::nullopt);
  EXPECT_EQ(schedule.due(), DrawSchedule::never);
  schedule.note_input();
  draw(schedule, 3.0, 0.5);
  EXPECT_NEAR(schedule.due(), 3.05, 1e-9) << "the earliest counts";
}

}  // namespace
}  // namespace asos
