#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace asos {
using namespace ui;
namespace {

using test::PanelsTest;

class RefinementTest : public PanelsTest {
 protected:
  /// Starts another render.
  void change() {
    settings().asos.jitter = !settings().asos.jitter;
    rig.frame();
  }
  [[nodiscard]] bool rests(PauseReason rest) {
    return rig.frames_until([&] { return rig.refinement().rest() == rest; }) &&
           rig.frames_until([&] { return !rig.render().first_picture_pending(); });
  }
  [[nodiscard]] bool finished() {
    return rig.frames_until([&] {
      return rig.render().progress().finished && rig.refinement().rest() == PauseReason::none;
    });
  }
};

TEST_F(RefinementTest, SpacePausesAndGoesOn) {
  rig.key(Key::space);
  ASSERT_TRUE(rig.refinement().paused());
  display().exposure_ev = 1.0f;
  rig.frame();
  EXPECT_FALSE(restarted()) << "pausing and display changes restart nothing";
  change();
  ASSERT_TRUE(rests(PauseReason::paused));
  EXPECT_FALSE(rig.render().progress().finished);
  const double seconds = rig.render().progress().seconds;
  for (int i = 0; i < 60; ++i) rig.frame();
  EXPECT_EQ(rig.render().progress().seconds, seconds);
  EXPECT_FALSE(rig.content().seconds_to_redraw().has_value()) << "a paused window sleeps";
  const std::uint64_t restarts = rig.render().restarts();
  rig.key(Key::space);
  EXPECT_TRUE(finished());
  EXPECT_EQ(rig.render().restarts(), restarts) << "it goes on from where it was";
}

// A render that ended between two frames was once finished before its tiles were taken: checks of
// the picture then judged the picture before.
TEST_F(RefinementTest, IsFinishedOnceTheFilmHasAllTiles) {
  const PreviewRender& render = rig.render();
  change();
  while (render.final_share() < 1.0) std::this_thread::yield();
  EXPECT_FALSE(render.progress().finished) << "the film has the coarse picture, or the one before";
  EXPECT_TRUE(render.progress().running);
  ASSERT_TRUE(finished());
  const std::vector<std::uint8_t>& unfinished = rig.film().unfinished;
  EXPECT_EQ(std::count(unfinished.begin(), unfinished.end(), 0), std::ssize(unfinished));
}

TEST_F(RefinementTest, ATimeLimitHoldsUntilItIsRaised) {
  rig.refinement().limits().seconds = 1e-6;
  change();
  ASSERT_TRUE(rests(PauseReason::time));
  EXPECT_LT(rig.render().progress().fraction, 1.0);
  EXPECT_FALSE(rig.previewer().seconds_to_update(0.0).has_value());
  rig.refinement().limits().seconds = 1000.0;
  EXPECT_TRUE(finished());
}

TEST_F(RefinementTest, ZRefinesThePartUnderThePointerFirst) {
  PreviewRender& render = rig.render();
  rig.key(Key::z);
  EXPECT_TRUE(render.preferred().empty()) << "the pointer is nowhere";
  const WindowRect picture = rig.content().layout().picture;
  const glm::vec2 at = picture.lo + 0.5f * picture.size;
  rig.move_to(at);
  rig.key(Key::z);
  const Film& film = render.film();
  EXPECT_NEAR(render.preferred().x + render.preferred().width / 2, film.width / 2, 1);
  rig.frame();
  rig.click("Refined first: end");
  EXPECT_TRUE(render.preferred().empty());
  rig.unfold("Refinement");
  rig.click("Refine a part first");
  const std::uint64_t camera = rig.camera().revision();
  rig.drag(picture.lo + 0.25f * picture.size, picture.lo + 0.75f * picture.size);
  EXPECT_NEAR(render.preferred().width, 0.5 * film.width, 2.0);
  EXPECT_NEAR(render.preferred().y, 0.25 * film.height, 2.0);
  EXPECT_EQ(rig.camera().revision(), camera) << "the drag turned it";
  rig.drag(picture.lo + 0.25f * picture.size, picture.lo + 0.35f * picture.size);
  EXPECT_NE(rig.camera().revision(), camera) << "the next drag turns it";
  ASSERT_TRUE(finished());
  rig.key(Key::z);
  EXPECT_TRUE(render.preferred().empty());
}

TEST_F(RefinementTest, AtALimitItCanGoOn) {
  rig.refinement().limits().seconds = 1e-6;
  change();
  ASSERT_TRUE(rests(PauseReason::time));
  rig.click("section/Refinement");
  const std::uint64_t restarts = rig.render().restarts();
  int asked = 0;
  ASSERT_TRUE(rig.frames_until([&] {
    if (rig.refinement().rest() != PauseReason::time) return true;
    if (asked < 2) rig.click("Continue");
    if (asked == 2) rig.refinement().limits().seconds = 0.5;
    if (asked++ > 2) rig.key(Key::space);
    return false;
  }));
  EXPECT_FALSE(rig.refinement().paused());
  rig.refinement().limits().seconds = 0.0;
  EXPECT_TRUE(finished());
  EXPECT_EQ(rig.render().restarts(), restarts);
}

TEST_F(RefinementTest, RenderAgainIsNotPaused) {
  rig.click("section/Refinement");
  rig.click("Pause");
  change();
  ASSERT_TRUE(rests(PauseReason::paused));
  rig.click("Stop");
  ASSERT_TRUE(rests(PauseReason::stopped));
  rig.click("Restart");
  EXPECT_TRUE(finished());
  EXPECT_FALSE(rig.refinement().paused());
}

TEST_F(RefinementTest, AQualityIsEnough) {
  EXPECT_TRUE(rig.render().estimated_rmse().has_value());
  EXPECT_EQ(*rig.render().estimated_rmse(), 0.0) << "it is finished";
  rig.refinement().limits().rmse = 1.0;
  change();
  ASSERT_TRUE(rests(PauseReason::quality));
  EXPECT_LE(*rig.render().estimated_rmse(), 1.0);
  rig.refinement().limits().rmse = 0.0;
  EXPECT_TRUE(finished());
}

TEST_F(RefinementTest, StopEndsARenderAndAnotherBegins) {
  rig.click_each({"section/Refinement"});
  rig.click("Pause");
  EXPECT_TRUE(rig.refinement().paused());
  change();
  ASSERT_TRUE(rests(PauseReason::paused));
  rig.frame();
  rig.click("Stop");
  EXPECT_EQ(rig.refinement().rest(), PauseReason::stopped);
  EXPECT_FALSE(rig.render().progress().paused);
  rig.click_each({"Resume"});
  EXPECT_FALSE(rig.render().progress().finished) << "it has ended";
  rig.click("Restart");
  EXPECT_TRUE(finished());
}

TEST_F(RefinementTest, LimitsAreTypedAndStaySound) {
  rig.click_each({"section/Refinement"});
  for (const auto& [typed, expected] : {std::pair<std::string, double>{"2.5", 2.5},
                                        {"1e99", RefinementLimits::most_seconds},
                                        {"-4", 0.0}}) {
    rig.input().add(KeyChanged{Key::ctrl, true});
    rig.click("Time limit");
    rig.input().add(KeyChanged{Key::ctrl, false});
    rig.frame();
    rig.chord(Key::ctrl, Key::a);
    rig.type(typed);
    rig.key(Key::enter);
    EXPECT_EQ(rig.refinement().limits().seconds, expected) << typed;
  }
  EXPECT_FALSE(restarted());
}

}  // namespace
}  // namespace asos
