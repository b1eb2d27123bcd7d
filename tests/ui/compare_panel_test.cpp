#include "renderer/film/split_map.h"
#include "renderer/study/measures.h"
#include "tests/ui/panels_fixture.h"
#include "ui/frames.h"
#include "ui/panels/snapshot_table.h"
#include "ui/resampled.h"
#include "ui/snapshot_name.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace asos {
using namespace ui;
namespace {

using test::PanelsTest;
using test::usual_display;

class ComparePanelTest : public PanelsTest {
 protected:
  ComparePanelTest() : PanelsTest(1, {660, 480}) { rig.click_each({"section/Compare"}); }
  Frames& frames() { return rig.state().frames; }
  /// Stores a snapshot, and renders another picture, without antialiasing.
  void store_and_change() {
    rig.click_each({"Keep snapshot"});
    ASSERT_EQ(frames().stored.size(), 1u);
    settings().asos.max_level = 0;
    settings().asos.leaf = LeafKind::point;
    EXPECT_TRUE(restarted());
    ASSERT_NE(rig.film().radiance, frames().stored[0].film.radiance);
  }
  template <typename Expected>
  void expect_area(const Expected& expected) {
    display().show_legend = false;
    rig.move_to({-10.0f, -10.0f});
    rig.frame();
    const Film& film = rig.film();
    const std::vector<glm::u8vec3> pixels = rig.pixels();
    int wrong = 0;
    for (int y = 0; y < film.height; ++y) {
      for (int x = 0; x < film.width; ++x)
        wrong +=
            pixels[static_cast<std::size_t>(y * rig.size().x + x)] != expected(x, film.index(x, y));
    }
    EXPECT_EQ(wrong, 0);
  }
  [[nodiscard]] glm::u8vec3 now(std::size_t i) {
    return display_bytes(rig.film(), i, usual_display);
  }
  [[nodiscard]] glm::u8vec3 then(std::size_t i) {
    return display_bytes(frames().stored[0].film, i, usual_display);
  }
};

TEST(SnapshotTable, IsCopiedAsCsv) {
  Frames frames;
  EXPECT_EQ(snapshot_csv(frames), "picture,compared with,rmse,psnr_db\n");
  for (const char* name : {"Sobol, 19 spp", "ASOS \"fine\"", "Beam"})
    frames.stored.push_back({name, "", {}});
  frames.chosen = 1;
  frames.rmse = 0.01;
  frames.stored_rmse = {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0};
  EXPECT_EQ(snapshot_csv(frames),
            "picture,compared with,rmse,psnr_db\n"
            "Current picture,\"ASOS \"\"fine\"\"\",0.01,40.00\n"
            "\"Sobol, 19 spp\",\"ASOS \"\"fine\"\"\",,\n"
            "Beam,\"ASOS \"\"fine\"\"\",0,inf\n");
}

TEST_F(ComparePanelTest, FlipShowsTheStoredFrame) {
  store_and_change();
  rig.click("Shown as/Flip");
  expect_area([&](int, std::size_t i) { return then(i); });
  rig.key(Key::x);
  expect_area([&](int, std::size_t i) { return now(i); });
  rig.key(Key::x);
  expect_area([&](int, std::size_t i) { return then(i); });
  rig.click("Show other");
  expect_area([&](int, std::size_t i) { return now(i); });
  rig.click("Shown as/Off");
  expect_area([&](int, std::size_t i) { return now(i); });
  EXPECT_FALSE(restarted());
}

TEST_F(ComparePanelTest, AWipeShowsBoth) {
  store_and_change();
  rig.click_each({"Shown as/Wipe"});
  const int width = rig.film().width;
  const auto beside = [&](int line) {
    rig.move_to({-10.0f, -10.0f});
    rig.frame();
    const std::vector<glm::u8vec3> pixels = rig.pixels();
    int wrong = 0;
    constexpr int labels = 40;  // that name the sides
    for (int y = labels; y < rig.film().height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (std::abs(x - line) <= 2) continue;  // the line itself
        const std::size_t i = rig.film().index(x, y);
        wrong +=
            pixels[static_cast<std::size_t>(y * rig.size().x + x)] != (x < line ? now(i) : then(i));
      }
    }
    return wrong;
  };
  EXPECT_EQ(beside(static_cast<int>(std::round(0.5f * static_cast<float>(width)))), 0);
  const Controls::Placed line = rig.control("Wipe line");
  const std::uint64_t revision = rig.camera().revision();
  rig.drag(line.centre(), {80.0f, line.centre().y});
  EXPECT_EQ(rig.camera().revision(), revision) << "no orbit";
  EXPECT_EQ(beside(80), 0);
  slide("Wipe", 0.3f, 0.75f);
  EXPECT_NEAR(frames().wipe, 0.75f, 0.02f);
}

TEST_F(ComparePanelTest, DifferencesHaveAnAbsoluteScale) {
  store_and_change();
  rig.click_each({"Shown as/Difference"});
  slide("Scale", 0.5f, 0.75f);
  const float scale = std::exp2(frames().scale_stops);
  EXPECT_NEAR(frames().scale_stops, -2.5f, 0.2f);
  int different = 0;
  expect_area([&](int, std::size_t i) {
    const float d = difference_of(rig.film(), frames().stored[0].film, i, usual_display);
    different += d > 0.0f;
    return heat_colour(d / scale);
  });
  EXPECT_GT(different, 50);
  display().show_legend = true;
  rig.frame();
  const auto& all = rig.controls();
  EXPECT_EQ(all.at("Compared").words, "Difference from: ASOS, EPS 1/256, MAX 2");
  EXPECT_EQ(all.at("Difference scale").words, "0 " + scale_words(frames().scale_stops - 1.0f) +
                                                  " " + scale_words(frames().scale_stops));
  rig.key(Key::x);
  rig.frame();
  EXPECT_EQ(all.at("Compared").words, "ASOS, EPS 1/256, MAX 2 (X: picture)");
}

TEST_F(ComparePanelTest, NineSnapshotsAreKept) {
  for (int i = 0; i < 10; ++i) rig.key(Key::s);
  ASSERT_EQ(frames().stored.size(), Frames::most);
  EXPECT_EQ(frames().stored.front().name, "ASOS, EPS 1/256, MAX 2");
  EXPECT_EQ(frames().stored.back().name, "ASOS, EPS 1/256, MAX 2 (9)");
  rig.click("Snapshot/3");
  EXPECT_EQ(frames().chosen, 2);
  rig.click("Delete snapshot");
  rig.click("Keep snapshot");
  ASSERT_EQ(frames().stored.size(), Frames::most);
  EXPECT_EQ(frames().stored.back().name, "ASOS, EPS 1/256, MAX 2 (3)") << "the name that was free";
  for (int i = 0; i < 10; ++i) rig.click("Delete snapshot");
  EXPECT_TRUE(frames().stored.empty());
}

TEST_F(ComparePanelTest, NumberKeysShowSnapshots) {
  store_and_change();
  rig.click("Keep snapshot");
  rig.key(Key::one);
  EXPECT_EQ(frames().chosen, 0);
  EXPECT_TRUE(frames().flipped);
  expect_area([&](int, std::size_t i) { return then(i); });
  rig.key(Key::two);
  EXPECT_EQ(frames().chosen, 1);
  EXPECT_TRUE(frames().flipped);
  rig.key(Key::two);
  EXPECT_FALSE(frames().flipped);
  expect_area([&](int, std::size_t i) { return now(i); });
  const std::uint64_t revision = rig.camera().revision();
  rig.key(Key::three);
  rig.frame();
  EXPECT_EQ(rig.state().message, "No snapshot 3 yet: press S to keep one");
  EXPECT_EQ(rig.camera().revision(), revision) << "no view of the camera";
}

TEST_F(ComparePanelTest, ErrorsStandBesideTheNames) {
  store_and_change();
  rig.click("Keep snapshot");
  for (int i = 0; i < 2; ++i) rig.frame();
  rig.click("Snapshot/1");
  for (int i = 0; i < 2; ++i) rig.frame();
  ASSERT_EQ(frames().stored_rmse.size(), 2u);
  const Film& film = rig.film();
  const double rmse = root_mean_square(film, frames().stored[0].film, true);
  EXPECT_GT(rmse, 0.0);
  EXPECT_DOUBLE_EQ(frames().rmse, rmse);
  EXPECT_DOUBLE_EQ(frames().stored_rmse[1], rmse) << "the same picture";
  EXPECT_EQ(frames().stored_rmse[0], 0.0);
  EXPECT_EQ(psnr_words(0.1), "20.0 dB");
  EXPECT_EQ(psnr_words(0.0), "identical");
}

// Without a reference a snapshot is only compared with the picture: it is not the truth.
TEST_F(ComparePanelTest, TheReferenceTellsWhichOneIsCloser) {
  store_and_change();
  for (int i = 0; i < 2; ++i) rig.frame();
  EXPECT_EQ(closer_words(frames()), "not known yet");
  EXPECT_EQ(rig.control("Errors against").words, "the chosen snapshot");
  rig.click("With/Reference");
  EXPECT_EQ(frames().comparison, Comparison::error) << "the reference is sampled to be shown";
  ASSERT_TRUE(rig.frames_until([&] { return frames().reference.samples == 256; }));
  rig.frame();
  EXPECT_TRUE(closer_words(frames()).starts_with("Snapshot 1, ")) << closer_words(frames());
  EXPECT_GT(frames().rmse, 1.5 * frames().stored_rmse[0]) << "it has no antialiasing";
  const Film& film = rig.film();
  EXPECT_DOUBLE_EQ(frames().rmse, root_mean_square(film, *frames().reference.film, true));
  EXPECT_NE(snapshot_csv(frames()).find("\"Reference, "), std::string::npos);
}

TEST(SnapshotTable, SaysHowManyTimesCloser) {
  Frames frames;
  frames.stored.resize(1);
  frames.reference = {std::make_shared<Film>(1, 1), 256, 1};
  frames.rmse = 0.001;
  frames.stored_rmse = {0.0031};
  EXPECT_EQ(closer_words(frames), "Current picture, 3.1 times");
  frames.rmse = 0.0062;
  EXPECT_EQ(closer_words(frames), "Snapshot 1, 2 times");
  frames.rmse = 0.0031;
  EXPECT_EQ(closer_words(frames), "equally close");
  frames.rmse = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(closer_words(frames), "not known yet");
}

TEST(SnapshotName, SaysMethodAndQuality) {
  RenderSettings settings;
  EXPECT_EQ(snapshot_name(settings, 8.7), "ASOS, EPS 1/256");
  settings.asos.max_level = 2;
  settings.asos.eps = 0.125;
  EXPECT_EQ(snapshot_name(settings, 8.7), "ASOS, EPS 1/8, MAX 2");
  settings.method = Method::sobol;
  settings.sampling.spp = 19;
  EXPECT_EQ(snapshot_name(settings, 8.7), "Sobol, 19 spp, 8.7 s");
  EXPECT_EQ(snapshot_name(settings, 93.4), "Sobol, 19 spp, 93 s");
  settings.method = Method::whitted;
  EXPECT_EQ(snapshot_name(settings, 0.52), "Whitted, 0.52 s");
}

TEST_F(ComparePanelTest, AFrameOfAnotherSizeIsResampledAndThatIsSaid) {
  store_and_change();
  EXPECT_FALSE(rig.controls().contains("Resampled"));
  rig.click("Shown as/Flip");
  rig.resize({720, 900});
  ASSERT_TRUE(rig.settle());
  const Film& film = rig.film();
  ASSERT_NE(film.height, frames().stored[0].film.height);
  const Film sized = resampled(frames().stored[0].film, {film.width, film.height});
  expect_area([&](int, std::size_t i) { return display_bytes(sized, i, usual_display); });
  EXPECT_TRUE(rig.controls().contains("Resampled"));
  rig.click("Shown as/Difference");
  const float scale = std::exp2(frames().scale_stops);
  expect_area([&](int, std::size_t i) {
    return heat_colour(difference_of(film, sized, i, usual_display) / scale);
  });
  // The error against the first picture, which differs only in antialiasing.
  EXPECT_GT(frames().rmse, 0.0);
  EXPECT_LT(frames().rmse, 0.1);
  rig.key(Key::x);
  rig.frame();
  EXPECT_NE(rig.state().message.find("resampled from"), std::string::npos);
}

TEST(Frames, ColoursGetBrighterWithTheDifference) {
  int before = -1;
  for (int i = 0; i <= 64; ++i) {
    const glm::u8vec3 c = heat_colour(static_cast<float>(i) / 64.0f);
    const int brightness = 2 * c.x + 5 * c.y + c.z;
    EXPECT_GT(brightness, before);
    before = brightness;
  }
  EXPECT_EQ(heat_colour(0.0f), glm::u8vec3(0));
  EXPECT_EQ(heat_colour(7.0f), glm::u8vec3(255));
  EXPECT_EQ(difference_of({1, 0, 0}, {1, 0, 2}, 0.0f), 1.0f) << "above white counts as white";
}

}  // namespace
}  // namespace asos
