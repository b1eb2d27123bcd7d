#include "ui/panels/time_words.h"

#include "renderer/comparison/method.h"
#include "renderer/study/timed_render.h"
#include "tests/ui/panels_fixture.h"
#include "ui/equal_time.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asos {
using namespace ui;
namespace {

using TimeWordsTest = test::PanelsTest;

// Wall-clock seconds have no label; CPU seconds are always labelled.
TEST(TimeWords, SayWhoseSecondsTheyAre) {
  EXPECT_EQ(wait_words(0.2), "1 s left");
  EXPECT_EQ(wait_words(12.0), "15 s left");
  EXPECT_EQ(wait_words(57.0), "1 min left");
  EXPECT_EQ(wait_words(61.0), "1 min 10 s left");
  EXPECT_EQ(wait_words(299.0), "5 min left");
  EXPECT_EQ(wait_words(301.0), "6 min left");
  EXPECT_EQ(wait_words(5400.0), "1.5 h left");
  EXPECT_EQ(processor_words(4.25), "4.25 s");
  EXPECT_EQ(duration_words(4.25), "4.2 s");
  EXPECT_EQ(duration_words(65.0), "1 min 05 s");
  EXPECT_EQ(duration_words(3725.0), "1 h 02 min");
  EXPECT_EQ(estimate_words(0.25, {2.5, 1.0}), "about 25 % split, 3 s");
  EXPECT_EQ(estimate_words(1.0, {2.5, 1.0}), "about 100 % split, 3 s");
  EXPECT_EQ(estimate_words(0.004, {2.5, 1.0}), "about 0.4 % split, 3 s");
}

TEST(TimeWords, AProgressNamesItsPassAndWhatIsLeft) {
  ProgressFacts facts{.progress = {.seconds = 2.0}, .fraction = 0.4};
  EXPECT_EQ(progress_words(facts), "40 % done   2.0 s");
  facts.reached.pass = Reached::Pass::quarters;
  EXPECT_EQ(progress_words(facts), "40 % done   first samples   2.0 s");
  facts.reached.pass = Reached::Pass::samples;
  facts.reached.samples = 4;
  EXPECT_EQ(progress_words(facts), "40 % done   4 samples per pixel   2.0 s");
  facts.progress.seconds_left = 3.2;
  EXPECT_EQ(progress_words(facts), "40 % done   4 samples per pixel   2.0 s   4 s left");
  facts.without_edges = true;
  EXPECT_EQ(progress_words(facts), "40 % done   finding edges   2.0 s   4 s left");
  facts.rest = PauseReason::paused;
  EXPECT_EQ(progress_words(facts), "Paused at 40 %   4 samples per pixel   2.0 s   4 s left");
  facts = {};
  facts.fraction = 0.0042;
  facts.reached.final_share = 0.125;
  EXPECT_EQ(progress_words(facts), "0.4 % done   12 % final   0.0 s");
  facts.progress.finished = true;
  facts.progress.seconds = 2.0;
  EXPECT_EQ(progress_words(facts), "Finished in 2.0 s");
}

// Once the line said "1 s left" for 25 s at 42 %, and gave times before anything was measured.
TEST(TimeWords, TheTimeLeftIsMeasuredAndFitsThePercentage) {
  ProgressFacts facts{.progress = {.seconds = 20.0}};
  EXPECT_FALSE(seconds_left(facts)) << "nothing was measured";
  facts.fraction = 0.4;
  EXPECT_FALSE(seconds_left(facts));
  facts.progress.seconds_left = 1.0;
  EXPECT_DOUBLE_EQ(seconds_left(facts).value(), 30.0) << "20 s took 40 %";
  facts.progress.seconds_left = 50.0;
  EXPECT_DOUBLE_EQ(seconds_left(facts).value(), 50.0);
  facts.fraction = 0.0;
  EXPECT_FALSE(seconds_left(facts));
}

// The row "Estimate" once said 8 s while the status line said 40 s.
TEST(TimeEstimate, IsTheRendersOwnAsSoonAsItHasOne) {
  Progress progress{.running = true, .seconds = 3.0};
  Forecast forecast{.wait_seconds = 8.0};
  EXPECT_FALSE(time_estimate(progress, nullptr));
  ASSERT_TRUE(time_estimate(progress, &forecast));
  EXPECT_EQ(time_estimate(progress, &forecast)->all, 8.0);
  EXPECT_EQ(time_estimate(progress, &forecast)->left, 5.0);
  progress.seconds_left = 37.0;
  EXPECT_EQ(time_estimate(progress, &forecast)->all, 40.0);
  EXPECT_EQ(time_estimate(progress, &forecast)->left, 37.0);
  progress.finished = true;
  ASSERT_TRUE(time_estimate(progress, &forecast));
  EXPECT_EQ(time_estimate(progress, &forecast)->all, 3.0) << "the time that it took";
  EXPECT_EQ(time_estimate(progress, &forecast)->left, 0.0);
}

// A session's finished fraction stands still during the visible part of a slow render, and then
// jumps.
TEST(ShownProgress, NeitherRestsNorFallsUntilTheRenderIsFinished) {
  ShownProgress shown;
  Progress progress{.running = true};
  double now = 0.0, before = 0.0;
  shown.update(progress, std::nullopt, 1, now);
  EXPECT_EQ(shown.fraction(), 0.0);
  for (int step = 0; step < 400; ++step) {
    now += 0.25;
    progress.seconds = now;
    progress.fraction = step < 40 ? 0.0 : step < 200 ? 0.002 * (step - 40) : 0.32;
    shown.update(progress, step < 200 ? std::nullopt : std::optional(TimeEstimate{120.0, 60.0}), 1,
                 now);
    EXPECT_GT(shown.fraction(), before) << "step " << step;
    EXPECT_GE(shown.fraction(), progress.fraction);
    EXPECT_LT(shown.fraction(), progress.fraction + 0.5 * (1.0 - progress.fraction));
    before = shown.fraction();
  }
  progress.running = false;
  progress.paused = true;
  shown.update(progress, std::nullopt, 1, now + 10.0);
  EXPECT_EQ(shown.fraction(), before) << "no progress during a pause";
  progress.finished = true;
  shown.update(progress, std::nullopt, 1, now + 11.0);
  EXPECT_EQ(shown.fraction(), 1.0);
  progress = {};
  progress.running = true;
  shown.update(progress, std::nullopt, 2, now + 12.0);
  EXPECT_EQ(shown.fraction(), 0.0) << "another render";
}

// The window's rows contain these texts, for these times.
TEST_F(TimeWordsTest, TheWindowShowsThem) {
  ASSERT_TRUE(rig.opens("point light") && rig.settle());
  rig.unfold("Compare");
  rig.click_each({"With/Method"});
  const auto& all = rig.controls();
  const PreviewRender& render = rig.render();
  EXPECT_EQ(all.at("Progress").words, "Finished in " + duration_words(render.progress().seconds));
  EXPECT_EQ(all.at("CPU time").words, processor_words(processor_seconds(render.film())));
  rig.click("Render and compare");
  const auto& stored = rig.state().frames.stored;
  ASSERT_TRUE(rig.frames_until([&] { return !stored.empty(); }));
  EXPECT_NE(stored[0].summary.find(" s CPU ("), std::string::npos) << stored[0].summary;
  slide("EPS", 0.3f, 0.4f);
  const glm::vec2 below = rig.control("Cell shading/Exact area").lo;
  ASSERT_TRUE(rig.frames_until([&] { return all.at("Estimate").words.ends_with(" s"); }))
      << all.at("Estimate").words;
  rig.frame();
  EXPECT_EQ(rig.control("Cell shading/Exact area").lo, below)
      << "different texts must not move the layout";
}

}  // namespace
}  // namespace asos
