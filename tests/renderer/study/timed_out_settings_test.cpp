#include "renderer/study/timed_out_settings.h"

#include <gtest/gtest.h>

namespace asos {
namespace {

Job point(const char* setting, const char* curve, int repetition) {
  return {.kind = JobKind::point,
          .rung = {.method = "asos", .setting = setting, .curve = curve},
          .repetition = repetition};
}

TEST(TimedOutSettings, WhatComesLaterOnTheCurveIsDearer) {
  TimedOutSettings timed_out;
  EXPECT_FALSE(timed_out.holds(point("MAX 3", "EPS 0", 1)));
  timed_out.add(point("MAX 3", "EPS 0", 1));
  EXPECT_TRUE(timed_out.holds(point("MAX 4", "EPS 0", 1)));
  EXPECT_FALSE(timed_out.holds(point("MAX 4 EPS 1/256", "EPS 1/256", 1)));
}

TEST(TimedOutSettings, OtherRepetitionsOfASettingAreNotTried) {
  TimedOutSettings timed_out;
  timed_out.add(point("MAX 3", "EPS 0", 1));
  EXPECT_TRUE(timed_out.holds(point("MAX 3", "EPS 0", 2)));
  // A finished setting is repeated, although it is on the same curve.
  EXPECT_FALSE(timed_out.holds(point("MAX 2", "EPS 0", 2)));
}

TEST(TimedOutSettings, OnceCutShortLaterASettingEndsItself) {
  TimedOutSettings timed_out;
  timed_out.add(point("MAX 3", "EPS 0", 2));
  EXPECT_TRUE(timed_out.holds(point("MAX 3", "EPS 0", 3)));
  EXPECT_FALSE(timed_out.holds(point("MAX 4", "EPS 0", 2)));
}

TEST(TimedOutSettings, ReferencesAreNoPoints) {
  TimedOutSettings timed_out;
  timed_out.add(point("MAX 3", "EPS 0", 1));
  Job reference = point("MAX 3", "EPS 0", 1);
  reference.kind = JobKind::reference;
  EXPECT_FALSE(timed_out.holds(reference));
}

TEST(TimedOutSettings, ARenderThatIsWatchedHidesNoPoint) {
  TimedOutSettings timed_out;
  Job watched = point("MAX 3", "EPS 0", 1);
  watched.kind = JobKind::progress;
  timed_out.add(watched);
  EXPECT_FALSE(timed_out.holds(point("MAX 3", "EPS 0", 1)));
  timed_out.add(point("MAX 3", "EPS 0", 1));
  EXPECT_FALSE(timed_out.holds(watched));
}

}  // namespace
}  // namespace asos
