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
namespace {

using TimeWordsTest = test::PanelsTest;

// Seconds of the clock are those that are waited for; a processor's are always called so.
TEST(TimeWords, SayWhoseSecondsTheyAre) {
  EXPECT_EQ(wait_words(0.2), "1 s left");
  EXPECT_EQ(wait_words(12.0), "15 s left");
  EXPECT_EQ(wait_words(61.0), "2 min left");
  EXPECT_EQ(wait_words(5400.0), "1.5 h left");
  EXPECT_EQ(processor_words(4.25), "4.25 s CPU");
  EXPECT_EQ(duration_words(4.25), "4.2 s");
  EXPECT_EQ(duration_words(65.0), "1 min 05 s");
  EXPECT_EQ(duration_words(3725.0), "1 h 02 min");
  Forecast forecast;
  forecast.split_share = 0.25;
  forecast.split_error = 0.011;
  forecast.wait_seconds = 2.5;
  forecast.processor_seconds = 40.0;
  EXPECT_EQ(forecast_words(forecast), "about 25 % split, 3 s");
  forecast.split_share = 1.0;
  EXPECT_EQ(forecast_words(forecast), "about 100 % split, 3 s");
  forecast.split_share = 0.004;
  EXPECT_EQ(forecast_words(forecast), "about 0.4 % split, 3 s");
}

TEST(TimeWords, AProgressTellsWhatIsWaitedFor) {
  Progress progress;
  progress.fraction = 0.4;
  progress.seconds = 2.0;
  EXPECT_EQ(progress_words(progress, Rest::none, false), "Rendering 40 %   2.0 s");
  progress.seconds_left = 3.2;
  EXPECT_EQ(progress_words(progress, Rest::none, false), "Rendering 40 %   2.0 s   4 s left");
  EXPECT_EQ(progress_words(progress, Rest::none, true), "Finding edges   2.0 s");
  Reached reached;
  reached.pass = Reached::Pass::samples;
  reached.samples = 4;
  EXPECT_EQ(progress_words(progress, Rest::none, false, reached),
            "Rendering 40 %   4 samples per pixel   2.0 s   4 s left");
  reached.final_share = 0.125;
  EXPECT_EQ(pass_words(reached), "12 % of pixels final");
  EXPECT_EQ(pass_words({}), "");
  EXPECT_EQ(progress_words(progress, Rest::paused, true), "Paused at 40 %   2.0 s   4 s left");
  progress.fraction = 0.0042;
  EXPECT_EQ(progress_words(progress, Rest::none, false), "Rendering 0.4 %   2.0 s   4 s left");
  progress.finished = true;
  EXPECT_EQ(progress_words(progress, Rest::none, false), "Finished in 2.0 s");
}

// The window's rows are these words, of these seconds.
TEST_F(TimeWordsTest, TheWindowShowsThem) {
  rig.previewer().scene().open("point light");
  ASSERT_TRUE(
      rig.frames_until([&] { return rig.previewer().scene()->geometry->source == "point light"; }));
  ASSERT_TRUE(rig.settle());
  rig.click("section/Equal time");
  rig.frame();
  const auto& all = rig.content().controls().all();
  const PreviewRender& render = rig.previewer().render();
  EXPECT_EQ(all.at("Progress").words, "Finished in " + duration_words(render.progress().seconds));
  EXPECT_EQ(all.at("CPU time").words, processor_words(processor_seconds(render.film())));
  rig.click("Render and compare");
  const auto& stored = rig.content().state().frames.stored;
  ASSERT_TRUE(rig.frames_until([&] { return !stored.empty(); }));
  EXPECT_NE(stored[0].summary.find(" s CPU ("), std::string::npos) << stored[0].summary;
  slide("EPS", 0.3f, 0.4f);
  const glm::vec2 below = rig.control("Cell shading/Exact area").lo;
  ASSERT_TRUE(rig.frames_until([&] { return all.at("Estimate").words.ends_with(" s"); }))
      << all.at("Estimate").words;
  rig.frame();
  EXPECT_EQ(rig.control("Cell shading/Exact area").lo, below) << "what is told moves nothing";
}

}  // namespace
}  // namespace asos
