#include "renderer/study/floor_bound.h"

#include <gtest/gtest.h>

namespace asos {
namespace {

StudyPoint timed_point(const std::string& method, const std::string& setting, double seconds,
                       double rmse) {
  return {.rung = {.method = method, .setting = setting, .curve = method},
          .costs = {{seconds, seconds, 1}},
          .measures = {.rmse = rmse}};
}

// The floor is 0.02. Both settings of ASOS are below it. Sobol's error is 0.1 / sqrt(t), so it
// reaches the floor in 25 s.
SceneStudy exact_asos() {
  SceneStudy study;
  study.points = {timed_point("asos", "MAX 2", 4, 0.01), timed_point("asos", "MAX 1", 2, 0.011),
                  timed_point("sobol", "4 spp", 4, 0.05), timed_point("sobol", "16 spp", 16, 0.025),
                  timed_point("sobol", "64 spp", 64, 0.0125)};
  study.noise = 0.01;
  analyse(study);
  return study;
}

TEST(FloorBound, IsTheRivalsTimeToTheFloorOverAsosQuickestSetting) {
  const SceneStudy study = exact_asos();
  EXPECT_TRUE(study.equal_error.empty());
  const auto bound = bound_at_floor(study, "sobol");
  ASSERT_TRUE(bound);
  EXPECT_EQ(bound->setting, "MAX 1");
  EXPECT_EQ(bound->asos_seconds, 2.0);
  EXPECT_NEAR(bound->rival_seconds, 25.0, 1e-9);
  EXPECT_NEAR(bound->factor, 12.5, 1e-9);
  EXPECT_EQ(bound->reading, Reading::measured);
}

TEST(FloorBound, IsTheRivalsLongestTimeWhereItDoesNotReachTheFloor) {
  SceneStudy study = exact_asos();
  study.points.pop_back();
  auto bound = bound_at_floor(study, "sobol");
  ASSERT_TRUE(bound);
  EXPECT_NEAR(bound->factor, 8.0, 1e-12) << "16 s, not extrapolated";
  EXPECT_EQ(bound->reading, Reading::unreached);
  study.points.pop_back();
  bound = bound_at_floor(study, "sobol");
  ASSERT_TRUE(bound);
  EXPECT_NEAR(bound->factor, 2.0, 1e-12) << "a single setting";
  EXPECT_EQ(bound->reading, Reading::unreached);
}

TEST(FloorBound, IsUnknownWhereTheRivalsQuickestSettingIsBelowTheFloor) {
  SceneStudy study = exact_asos();
  study.points.erase(study.points.begin() + 2, study.points.end());
  study.points.push_back(timed_point("sobol", "64 spp", 64, 0.0125));
  analyse(study);
  EXPECT_FALSE(bound_at_floor(study, "sobol")) << "a quicker one may be, too";
}

TEST(FloorBound, NeedsAsosBelowTheFloorAndAMeasuredRival) {
  SceneStudy study = exact_asos();
  EXPECT_FALSE(bound_at_floor(study, "uniform"));
  study.noise = 0.001;
  analyse(study);
  EXPECT_FALSE(bound_at_floor(study, "sobol")) << "all settings of ASOS are above the floor";
}

}  // namespace
}  // namespace asos
