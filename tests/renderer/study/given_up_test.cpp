#include "renderer/study/given_up.h"

#include <gtest/gtest.h>

namespace asos {
namespace {

Job point(const char* setting, const char* curve, int repetition) {
  Job job;
  job.kind = JobKind::point;
  job.rung.method = "asos";
  job.rung.setting = setting;
  job.rung.curve = curve;
  job.repetition = repetition;
  return job;
}

TEST(GivenUp, WhatComesLaterOnTheCurveIsDearer) {
  GivenUp given_up;
  EXPECT_FALSE(given_up.holds(point("MAX 3", "EPS 0", 1)));
  given_up.add(point("MAX 3", "EPS 0", 1));
  EXPECT_TRUE(given_up.holds(point("MAX 4", "EPS 0", 1)));
  EXPECT_FALSE(given_up.holds(point("MAX 4 EPS 1/256", "EPS 1/256", 1)));
}

TEST(GivenUp, OtherRepetitionsOfASettingAreNotTried) {
  GivenUp given_up;
  given_up.add(point("MAX 3", "EPS 0", 1));
  EXPECT_TRUE(given_up.holds(point("MAX 3", "EPS 0", 2)));
  // A finished setting is repeated, although it is on the same curve.
  EXPECT_FALSE(given_up.holds(point("MAX 2", "EPS 0", 2)));
}

TEST(GivenUp, OnceCutShortLaterASettingEndsItself) {
  GivenUp given_up;
  given_up.add(point("MAX 3", "EPS 0", 2));
  EXPECT_TRUE(given_up.holds(point("MAX 3", "EPS 0", 3)));
  EXPECT_FALSE(given_up.holds(point("MAX 4", "EPS 0", 2)));
}

TEST(GivenUp, ReferencesAreNoPoints) {
  GivenUp given_up;
  given_up.add(point("MAX 3", "EPS 0", 1));
  Job reference = point("MAX 3", "EPS 0", 1);
  reference.kind = JobKind::reference;
  EXPECT_FALSE(given_up.holds(reference));
}

TEST(GivenUp, ARenderThatIsWatchedHidesNoPoint) {
  GivenUp given_up;
  Job watched = point("MAX 3", "EPS 0", 1);
  watched.kind = JobKind::progress;
  given_up.add(watched);
  EXPECT_FALSE(given_up.holds(point("MAX 3", "EPS 0", 1)));
  given_up.add(point("MAX 3", "EPS 0", 1));
  EXPECT_FALSE(given_up.holds(watched));
}

}  // namespace
}  // namespace asos
