#include "ui/split_check.h"

#include "renderer/comparison/method.h"
#include "tests/ui/panels_fixture.h"
#include "ui/equal_time.h"
#include "ui/error_map.h"
#include "ui/pass_mean.h"
#include "ui/split_forecast.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asos {
using namespace ui;
namespace {

using test::PanelsTest;

TEST(FindFaults, TellsMissedFromWastedFromNoise) {
  Film picture(5, 1), centres(5, 1), reference(5, 1);
  for (Film* film : {&picture, &centres, &reference}) film->radiance.assign(5, glm::vec3(0.5f));
  std::vector<float> uncertainty(5, 0.001f);
  // 0: correct without a split. 1: missed. 2: wrong, but within noise. 3: split needlessly. 4:
  // split for a reason.
  reference.radiance[1] = reference.radiance[2] = glm::vec3(0.5f, 0.5f, 0.8f);
  uncertainty[2] = 0.2f;
  picture.split_level[3] = 2;
  picture.cause[4] = SplitCause::shadow;
  centres.radiance[4] = glm::vec3(0.9f);
  const SplitFindings found = find_faults({picture, centres, reference, uncertainty}, 0.05);
  EXPECT_EQ(found.missed, (std::vector<PixelRun>{{1, 0, 1}}));
  EXPECT_EQ(found.wasted, (std::vector<PixelRun>{{3, 0, 1}}));
  EXPECT_EQ(found.split_pixels, 2u);
  EXPECT_NEAR(found.rmse, std::sqrt(2.0 * 0.09 / 15.0), 1e-6);
  EXPECT_TRUE(find_faults({picture, centres, reference, uncertainty}, 0.9).missed.empty())
      << "below the alarm";
}

TEST(FindFaults, NeighboursAreOneRun) {
  Film picture(4, 2), centres(4, 2), reference(4, 2);
  reference.radiance.assign(8, glm::vec3(1.0f));
  const SplitFindings found =
      find_faults({picture, centres, reference, std::vector<float>(8, 0.0f)}, 0.1);
  EXPECT_EQ(found.missed, (std::vector<PixelRun>{{0, 0, 4}, {0, 1, 4}}));
  EXPECT_EQ(found.missed_pixels, 8u);
}

class SplitCheckTest : public PanelsTest {
 protected:
  SplitCheckTest() : PanelsTest(1, {460, 400}) {}
  [[nodiscard]] UiState& state() { return rig.state(); }
  [[nodiscard]] Snapshot snapshot() {
    return {rig.scene().shared(), rig.camera().camera(), rig.render().settings(), false};
  }
};

// A study measures times: the check leaves it the processors, keeps its findings, and resumes
// later.
TEST_F(SplitCheckTest, WaitsWhileOtherWorkIsMeasured) {
  SplitCheck check;
  const auto update = [&](bool held) { check.update(rig.previewer(), true, 1.0 / 64.0, held); };
  ASSERT_TRUE(rig.frames_until([&] {
    update(false);
    return check.findings() != nullptr;
  }));
  const int passes = check.findings()->passes;
  ASSERT_TRUE(rig.frames_until([&] {
    update(true);
    return !check.busy();
  }));
  for (int i = 0; i < 20; ++i) update(true);
  EXPECT_FALSE(check.busy());
  ASSERT_NE(check.findings(), nullptr) << "what was found stays";
  EXPECT_GE(check.findings()->passes, passes);
  const bool whole = check.findings()->passes == SplitCheck::most_passes;
  EXPECT_TRUE(rig.frames_until([&] {
    update(false);
    return whole || check.busy();
  }));
  EXPECT_NE(check.findings(), nullptr);
}

TEST_F(SplitCheckTest, FindsNothingMissedWhereEverythingIsSplitAndAllWhereNothingIs) {
  SplitCheck check;
  const auto checked = [&] {
    return rig.frames_until([&] {
      check.update(rig.previewer(), true, 1.0 / 64.0);
      return check.findings() != nullptr;
    });
  };
  ASSERT_TRUE(checked());
  EXPECT_EQ(check.findings()->missed_pixels, 0u);
  EXPECT_GT(check.findings()->split_pixels, 0u);
  EXPECT_LT(check.findings()->rmse, 0.02);
  settings().asos.max_level = 0;
  settings().asos.leaf = LeafKind::point;
  EXPECT_TRUE(restarted());
  check.update(rig.previewer(), true, 1.0 / 64.0);
  EXPECT_EQ(check.findings(), nullptr) << "it was of another picture";
  ASSERT_TRUE(checked());
  EXPECT_GT(check.findings()->missed_pixels, 50u) << "the triangles' edges";
  for (const PixelRun& run : check.findings()->missed) {
    EXPECT_GE(run.x, 0);
    EXPECT_LE(run.x + run.count, rig.film().width);
  }
  check.update(rig.previewer(), false, 1.0 / 64.0);
  EXPECT_EQ(check.findings(), nullptr);
  EXPECT_TRUE(checked()) << "switched on again, it checks the same picture again";
}

// Once the reference had no unlit part and was clipped before the tone curve: unlit surfaces and
// those brighter than white had errors of 10 to 40 display steps.
TEST_F(SplitCheckTest, TheReferenceIsDisplayedAsThePictureIs) {
  for (const char* source : {"shining", "two triangles"}) {
    ASSERT_TRUE(rig.opens(source));
    SplitCheck check;
    ASSERT_TRUE(rig.frames_until([&] {
      check.update(rig.previewer(), true, 1.0 / 64.0);
      return check.findings() != nullptr;
    }));
    const Film& film = rig.film();
    for (const ToneCurve tone : {ToneCurve::none, ToneCurve::neutral, ToneCurve::agx}) {
      const DisplayTransform display{-0.5f, tone};
      double most = 0.0;
      int whole = 0;
      for (std::size_t i = 0; i < film.radiance.size(); ++i) {
        if (film.split_level[i] > 0 || film.cause[i] != SplitCause::none) continue;
        most = std::max(most, error_steps(film, *check.findings()->reference, i, display));
        ++whole;
      }
      EXPECT_GT(whole, 1000);
      EXPECT_LT(most, 0.5) << source << ", curve " << static_cast<int>(tone);
    }
    EXPECT_EQ(check.findings()->missed_pixels, 0u) << source;
  }
}

// A mean of the picture itself has no error in any display.
TEST(PassMean, OfOnePictureIsThatPicture) {
  Film picture(4, 1);
  picture.radiance = {glm::vec3(0.2f), glm::vec3(7.0f, 0.5f, 0.0f), glm::vec3(0.9f),
                      glm::vec3(2.0f)};
  picture.unlit.assign(4, glm::vec4(0.0f));
  picture.unlit[2] = glm::vec4(0.9f, 0.9f, 0.9f, 1.0f);
  picture.unlit[3] = glm::vec4(0.25f, 0.25f, 0.25f, 0.5f);
  PassMean mean;
  for (int i = 0; i < 3; ++i) mean.add(picture);
  for (std::size_t i = 0; i < 4; ++i) {
    for (const ToneCurve tone : {ToneCurve::none, ToneCurve::neutral, ToneCurve::agx})
      EXPECT_LT(error_steps(picture, mean.film(), i, {1.0f, tone}), 1e-3) << i;
    EXPECT_LT(mean.uncertainty()[i], 1e-6f);
  }
  EXPECT_EQ(error_summary(picture, mean.film(), {}).visible, 0.0);
}

TEST_F(SplitCheckTest, TheRowOfMaxCountsThePixelsThatItEnded) {
  rig.state().tab = PanelTab::antialias;
  const auto ended = [&] {
    EXPECT_TRUE(rig.settle());
    rig.frame();
    const Film& film = rig.film();
    const auto count = std::count(film.cause.begin(), film.cause.end(), SplitCause::depth_limit);
    const double percent =
        100.0 * static_cast<double>(count) / static_cast<double>(film.cause.size());
    EXPECT_EQ(rig.control("At MAX").words, fmt::format("{:.2g} % of pixels", percent));
    return percent;
  };
  EXPECT_EQ(ended(), 0.0) << "an edge cuts exactly";
  settings().asos.leaf = LeafKind::point;
  settings().asos.max_level = 1;
  settings().asos.eps = 0.0;
  EXPECT_TRUE(restarted());
  EXPECT_GT(ended(), 0.1);
}

TEST_F(SplitCheckTest, MissedPixelsAreMarkedInThePicture) {
  settings().asos.max_level = 0;
  settings().asos.leaf = LeafKind::point;
  state().display.tone = ToneCurve::none;  // the object has the maximum red
  EXPECT_TRUE(restarted());
  // Number of magenta pixels, and the brightest channel of pixels without a mark.
  struct Seen {
    int marks = 0;
    int brightest = 0;
  };
  const auto seen = [&] {
    Seen found;
    const std::vector<glm::u8vec3> pixels = rig.pixels();
    const PixelRect area = rig.content().picture_rect();
    for (int y = 0; y < area.height; ++y)
      for (int x = 0; x < area.width; ++x) {
        const glm::u8vec3 c = pixels[static_cast<std::size_t>(y * rig.size().x + x)];
        const bool magenta = c == glm::u8vec3(255, 0, 255), cyan = c == glm::u8vec3(0, 255, 255);
        found.marks += magenta;
        if (!magenta && !cyan)
          found.brightest = std::max({found.brightest, int{c.x}, int{c.y}, int{c.z}});
      }
    return found;
  };
  EXPECT_EQ(seen().marks, 0);
  EXPECT_GT(seen().brightest, 200);
  state().check.check = true;
  state().frames.with = CompareWith::reference;
  ASSERT_TRUE(rig.frames_until([&] { return seen().marks > 40; })) << "along the edges";
  EXPECT_LT(seen().brightest, 128) << "the picture is dimmed: no surface looks like a mark";
  EXPECT_FALSE(restarted()) << "looking for faults renders nothing again";
  state().check.mark_missed = false;
  rig.frame();
  EXPECT_EQ(seen().marks, 0);
}

// Once only methods in object space got a reference: the error of others waited for ever.
TEST_F(SplitCheckTest, OtherMethodsHaveAReferenceToo) {
  settings().method = Method::uniform;
  settings().sampling.spp = 1;
  EXPECT_TRUE(restarted());
  state().frames.with = CompareWith::reference;
  state().frames.comparison = Comparison::error;
  ASSERT_TRUE(rig.frames_until([&] { return state().frames.reference.samples == 256; }));
}

TEST_F(SplitCheckTest, AForecastComesNearToWhatIsRendered) {
  const Forecast told = forecast(snapshot(), 10.0);
  const Film& film = rig.film();
  double split = 0.0;
  for (std::size_t i = 0; i < film.radiance.size(); ++i)
    split += film.split_level[i] > 0 || film.cause[i] != SplitCause::none;
  split /= static_cast<double>(film.radiance.size());
  EXPECT_GT(told.pixels, 1000);
  EXPECT_GT(told.split_share, 0.0);
  EXPECT_NEAR(told.split_share, split, 0.3 * split);
  EXPECT_LT(told.split_error, 0.5 * split);
}

// CPU time is measured; with four workers the wall-clock time is a quarter of it.
TEST_F(SplitCheckTest, AForecastsWaitIsSharedByAllWorkers) {
  Snapshot view = snapshot();
  for (const int threads : {1, 4}) {
    view.settings.threads = threads;
    const Forecast told = forecast(view, 0.0);
    ASSERT_GT(told.processor_seconds, 0.0);
    const double whole =
        told.processor_seconds * view.settings.width * view.settings.height / told.pixels;
    EXPECT_DOUBLE_EQ(told.wait_seconds * threads, whole);
  }
}

TEST_F(SplitCheckTest, DraggingEpsForecastsBeforeTheRenderIsThere) {
  SplitForecast waiting;
  EXPECT_EQ(waiting.of(rig.previewer()), nullptr);
  waiting.ask(rig.previewer());
  ASSERT_TRUE(rig.frames_until([&] {
    waiting.update();
    return waiting.of(rig.previewer()) != nullptr;
  }));
  settings().asos.eps = 0.5;
  EXPECT_EQ(waiting.of(rig.previewer()), nullptr) << "of other settings";
}

TEST_F(SplitCheckTest, ARivalGetsTheTimeItIsGiven) {
  const auto never = [] { return false; };
  std::vector<std::string> told;
  const auto frame = render_in_time(snapshot(), Method::stochastic, 0.05, never,
                                    [&](const EqualTimeNews& news) { told.push_back(news.doing); });
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.front(), "1 spp") << "the first try";
  ASSERT_TRUE(frame.has_value());
  EXPECT_EQ(frame->film.width, rig.film().width);
  EXPECT_NE(frame->summary.find("Stochastic"), std::string::npos);
  EXPECT_GT(processor_seconds(frame->film), 0.0);
  const auto adaptive = render_in_time(snapshot(), Method::sobol_adaptive, 0.05, never);
  ASSERT_TRUE(adaptive.has_value());
  EXPECT_NE(adaptive->summary.find("Adaptive Sobol, EPS "), std::string::npos) << adaptive->summary;
  EXPECT_FALSE(render_in_time(snapshot(), Method::sobol_adaptive, 0.05, [] { return true; }));
  EXPECT_FALSE(render_in_time(snapshot(), Method::sobol, 0.05, [] { return true; }).has_value());
}

TEST_F(SplitCheckTest, TheSplitScreenShowsTheRivalAtTheRight) {
  state().equal_time.method = Method::sobol;
  rig.unfold("Compare");
  rig.click_each({"With/Method"});
  rig.click("Render and compare");
  ASSERT_TRUE(rig.frames_until([&] { return !state().frames.stored.empty(); }));
  EXPECT_EQ(state().frames.comparison, Comparison::wipe);
  EXPECT_NE(state().frames.stored[0].summary.find("Sobol"), std::string::npos);
  EXPECT_FALSE(restarted());
}

}  // namespace
}  // namespace asos
