#include "renderer/study/analysis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

StudyPoint point(const std::string& method, const std::string& setting, double seconds,
                 double rmse) {
  return {
      .rung = {.method = method, .setting = setting, .curve = method},
      .costs = {{seconds, 0.9 * seconds, 1}, {seconds, seconds, 1}, {seconds, 1.3 * seconds, 1}},
      .measures = {.rmse = rmse}};
}

// Sobol: error 0.1 / sqrt(t). ASOS: 0.01 in 2 s, where Sobol takes 100 s; 0.002 in 20 s, where
// Sobol would take 2500 s but was measured only up to 400 s.
SceneStudy power_laws() {
  SceneStudy study{.scene = "made up"};
  study.points = {point("asos", "MAX 1", 2, 0.01),      point("asos", "MAX 2", 20, 0.002),
                  point("sobol", "1 spp", 1, 0.1),      point("sobol", "4 spp", 4, 0.05),
                  point("sobol", "64 spp", 64, 0.0125), point("sobol", "400 spp", 400, 0.005)};
  analyse(study);
  return study;
}

TEST(StudyPoint, TakesTheMedianAndHalfTheRange) {
  const StudyPoint p = point("asos", "", 2.0, 0.1);
  EXPECT_EQ(p.seconds(), 2.0);
  EXPECT_NEAR(p.spread(), 0.2, 1e-12);
}

TEST(Analyse, FindsTheSpeedupAtEqualError) {
  const SceneStudy study = power_laws();
  ASSERT_EQ(study.equal_error.size(), 2u);
  EXPECT_EQ(study.equal_error[0].method, "sobol");
  EXPECT_EQ(study.equal_error[0].setting, "MAX 1");
  EXPECT_NEAR(study.equal_error[0].speedup, 50.0, 1e-9);
  EXPECT_EQ(study.equal_error[0].reading, Reading::measured);
  EXPECT_NEAR(study.equal_error[1].speedup, 125.0, 1e-6);
  EXPECT_EQ(study.equal_error[1].reading, Reading::extrapolated);
}

TEST(Analyse, ComparesAnyPointWithARival) {
  SceneStudy study = power_laws();
  // Not ASOS itself, but treated like other methods: sobol takes 16 s to an error of 0.025.
  study.points.push_back(point("asos-published", "MAX 1", 4, 0.025));
  analyse(study);
  const auto row = at_equal_error(study, study.points.back(), "sobol");
  ASSERT_TRUE(row);
  EXPECT_NEAR(row->speedup, 4.0, 1e-9);
  EXPECT_FALSE(at_equal_error(study, study.points.back(), "uniform")) << "not measured";
  study.noise = 0.02;
  analyse(study);
  EXPECT_FALSE(at_equal_error(study, study.points.back(), "sobol")) << "below the noise floor";
}

TEST(Analyse, FindsTheErrorInEqualTime) {
  const SceneStudy study = power_laws();
  ASSERT_EQ(study.equal_time.size(), 2u);
  EXPECT_NEAR(study.equal_time[0].rival_rmse, 0.1 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(study.equal_time[0].ratio, 10.0 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(study.equal_time[1].ratio, 50.0 / std::sqrt(20.0), 1e-9);
}

TEST(Analyse, FindsTheSlopes) {
  const SceneStudy study = power_laws();
  ASSERT_EQ(study.slopes.size(), 2u);
  EXPECT_NEAR(study.slopes[0].slope, -std::log10(5.0), 1e-9);
  EXPECT_NEAR(study.slopes[1].slope, -0.5, 1e-9);
  EXPECT_EQ(study.slopes[1].points, 4);
}

TEST(Analyse, PointsUnderTheFloorAreNotQuoted) {
  SceneStudy study = power_laws();
  study.noise = 0.0015;  // floor 0.003
  analyse(study);
  EXPECT_TRUE(study.points[1].under_floor);
  EXPECT_FALSE(study.points[0].under_floor);
  ASSERT_EQ(study.equal_error.size(), 1u);
  EXPECT_EQ(study.equal_error[0].setting, "MAX 1");
  EXPECT_EQ(study.equal_time.size(), 1u);
  ASSERT_EQ(study.slopes.size(), 1u) << "one point has no slope";
  EXPECT_EQ(study.slopes[0].curve, "sobol");
}

// The error of ASOS that remains at any run time, without the reference's noise.
TEST(Analyse, FindsAsosOwnBias) {
  SceneStudy study;
  study.points = {point("asos", "MAX 1", 1, 0.05), point("asos", "MAX 2", 2, 0.01),
                  point("asos", "MAX 3", 4, 0.0051), point("asos", "MAX 4", 16, 0.005),
                  point("sobol", "4 spp", 16, 0.001)};
  study.noise = 0.001;
  analyse(study);
  ASSERT_TRUE(study.bias);
  EXPECT_NEAR(study.bias->at_most, std::sqrt(24e-6), 1e-12);
  EXPECT_EQ(study.bias->setting, "MAX 4");
  EXPECT_TRUE(study.bias->levels_off) << "four times the time took 2 % of it";
  study.points[3].measures.rmse = 0.0025;
  analyse(study);
  EXPECT_FALSE(study.bias->levels_off) << "half of it is removed";
  study.noise = 0.002;
  analyse(study);
  EXPECT_FALSE(study.bias) << "the best is under the floor of 0.004";
}

// Compares ASOS's picture at the times at which Sobol settings are finished.
TEST(Analyse, ComparesUnfinishedAsosWithFinishedSobol) {
  SceneStudy study = power_laws();
  EXPECT_TRUE(study.at_moments.empty()) << "no render was watched";
  for (StudyPoint& p : study.points)
    p.rung.settings.sampling.spp = p.rung.setting == "400 spp" ? 400 : 1;
  study.while_rendering = {{"sobol", "400 spp", true, {{0.5, 0.001}}},
                           {"asos", "MAX 2", true, {{2.0, 0.1}, {10.0, 0.04}, {50.0, 0.003}}}};
  analyse(study);
  // After 1 s there is no picture, after 4 s the one of 2 s, after 64 s the one of 50 s.
  ASSERT_EQ(study.at_moments.size(), 2u) << "only up to 64 samples";
  EXPECT_EQ(study.at_moments[0].setting, "4 spp");
  EXPECT_EQ(study.at_moments[0].seconds, 4.0);
  EXPECT_NEAR(study.at_moments[0].ratio, 0.1 / 0.05, 1e-12);
  EXPECT_NEAR(study.at_moments[1].ratio, 0.003 / 0.0125, 1e-12);
  EXPECT_FALSE(study.at_moments[1].under_floor);
  study.noise = 0.002;  // and the floor 0.004
  analyse(study);
  ASSERT_EQ(study.at_moments.size(), 2u);
  EXPECT_FALSE(study.at_moments[0].under_floor);
  EXPECT_TRUE(study.at_moments[1].under_floor);
}

TEST(Analyse, ReportsLosses) {
  SceneStudy study{.points = {point("asos", "MAX 1", 2, 0.2), point("sobol", "1 spp", 1, 0.1),
                              point("sobol", "4 spp", 4, 0.05)}};
  analyse(study);
  ASSERT_EQ(study.equal_error.size(), 1u);
  EXPECT_EQ(study.equal_error[0].reading, Reading::cheapest);
  EXPECT_NEAR(study.equal_error[0].speedup, 0.5, 1e-12);
  const auto all = verdicts(study.equal_error);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].losses, 1);
  EXPECT_EQ(all[0].wins, 0);
}

TEST(Analyse, ComparesARivalAtItsBest) {
  SceneStudy study = power_laws();
  // A setting that is slower and worse than others of its method changes nothing.
  study.points.push_back(point("sobol", "clumsy", 300, 0.09));
  const double before = power_laws().equal_error[0].speedup;
  analyse(study);
  EXPECT_NEAR(study.equal_error[0].speedup, before, 1e-9);
  EXPECT_FALSE(study.points.back().best);
  EXPECT_TRUE(study.points.front().best);
}

// A method whose errors stop falling: no time would suffice, and its longest time is a lower bound.
TEST(Analyse, GivesALowerBoundForUnreachedErrors) {
  SceneStudy study{.points = {point("asos", "MAX 2", 2, 0.001), point("average", "a", 1, 0.1),
                              point("average", "b", 3, 0.0999)}};
  analyse(study);
  ASSERT_EQ(study.equal_error.size(), 1u);
  EXPECT_EQ(study.equal_error[0].reading, Reading::unreached);
  EXPECT_NEAR(study.equal_error[0].speedup, 1.5, 1e-12);
  study.points.pop_back();  // a single setting gives a lower bound, too
  analyse(study);
  ASSERT_EQ(study.equal_error.size(), 1u);
  EXPECT_EQ(study.equal_error[0].reading, Reading::unreached);
  EXPECT_NEAR(study.equal_error[0].speedup, 0.5, 1e-12);
  const auto all = verdicts(study.equal_error);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].losses + all[0].wins + all[0].evens, 0);
  EXPECT_EQ(all[0].beyond(), 1);
}

// Only a method whose last doublings hardly improve is reported as levelling off.
TEST(Analyse, DistinguishesLevellingOffFromShortMeasurements) {
  SceneStudy study{.points = {point("asos", "MAX 2", 2, 1e-4), point("average", "a", 1, 0.1),
                              point("average", "b", 2, 0.099), point("average", "c", 4, 0.098)}};
  analyse(study);
  ASSERT_EQ(study.equal_error.size(), 1u);
  EXPECT_EQ(study.equal_error[0].reading, Reading::levelled);
  EXPECT_EQ(verdicts(study.equal_error)[0].levelled, 1);
  // Random samples: half of the error for four times the time.
  study.points = {point("asos", "MAX 2", 2, 1e-4), point("random", "a", 1, 0.1),
                  point("random", "b", 2, 0.0707), point("random", "c", 4, 0.05)};
  analyse(study);
  EXPECT_EQ(study.equal_error[0].reading, Reading::unreached);
  EXPECT_EQ(verdicts(study.equal_error)[0].unreached, 1);
  // A measured error is not extrapolated, so levelling off does not matter.
  study.points = {point("asos", "MAX 1", 1, 0.0995), point("average", "a", 1, 0.1),
                  point("average", "b", 2, 0.099), point("average", "c", 4, 0.098)};
  analyse(study);
  EXPECT_EQ(study.equal_error[0].reading, Reading::measured);
}

TEST(Analyse, CountsSettingsBelowTheNoiseFloor) {
  SceneStudy study{.noise = 0.01};
  study.points = {point("asos", "a", 1, 0.1), point("asos", "b", 2, 0.03),
                  point("asos", "c", 3, 0.021), point("asos", "d", 4, 0.019),
                  point("sobol", "e", 5, 0.001)};
  analyse(study);
  EXPECT_EQ(incomparable(study).settings, 4);
  EXPECT_EQ(incomparable(study).under_floor, 1);
  EXPECT_FALSE(incomparable(study).too_many());
  study.noise = 0.011;
  analyse(study);
  EXPECT_EQ(incomparable(study).under_floor, 2);
  EXPECT_TRUE(incomparable(study).too_many());
}

TEST(Verdicts, CountByRivalAndLeaveExtrapolationOut) {
  const auto all = verdicts(power_laws().equal_error);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].wins, 1);
  EXPECT_EQ(all[0].beyond(), 1);
  EXPECT_EQ(all[0].extrapolated, 1);
  EXPECT_GT(all[0].beyond_median, 50.0);
  EXPECT_NEAR(all[0].median, 50.0, 1e-9);
}

}  // namespace
}  // namespace asos
