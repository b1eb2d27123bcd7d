#include "ui/window_content.h"

#include "renderer/film/split_map.h"
#include "tests/ui/test_scenes.h"
#include "tests/ui/ui_rig.h"
#include "ui/panels/grid_overlay.h"
#include "ui/theme.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <ostream>
#include <thread>

namespace asos {
using namespace ui;
namespace {

using test::two_triangles;
using test::UiRig;
using test::usual_display;

Result<Scene> load(const std::string& source) {
  if (source == "red") return two_triangles({0.8f, 0.1f, 0.1f}, source);
  if (source == "green") return two_triangles({0.1f, 0.8f, 0.1f}, source);
  return unexpected(Error{source, "there is no such file"});
}

class WindowContentTest : public testing::Test {
 protected:
  void open(const std::string& source) { ASSERT_TRUE(rig.opens(source) && rig.settle()); }

  /// Compares the picture's area with `expected` of film pixels, one to one.
  template <typename Expected>
  void expect_area(const Expected& expected) {
    const PixelRect area = rig.content().picture_rect();
    const Film& film = rig.film();
    ASSERT_EQ(film.width, area.width);
    ASSERT_EQ(film.height, area.height);
    const std::vector<glm::u8vec3> pixels = rig.pixels();
    int wrong = 0;
    for (int y = 0; y < film.height; ++y) {
      for (int x = 0; x < film.width; ++x) {
        const glm::u8vec3 want = expected(film, film.index(x, y));
        const glm::u8vec3 got = pixels[static_cast<std::size_t>(y * rig.size().x + x)];
        if (want == got) continue;
        if (++wrong <= 3) {
          ADD_FAILURE() << "pixel " << x << ' ' << y << ": " << +got.x << ' ' << +got.y << ' '
                        << +got.z << " instead of " << +want.x << ' ' << +want.y << ' ' << +want.z;
        }
      }
    }
    EXPECT_EQ(wrong, 0);
  }

  UiRig rig{load};
};

TEST_F(WindowContentTest, ShowsTheFilmPixelForPixel) {
  open("red");
  expect_area(
      [](const Film& film, std::size_t i) { return display_bytes(film, i, usual_display); });
}

// (0.8, 0.1, 0.1) is displayed unchanged, for any curve and exposure.
TEST_F(WindowContentTest, ShowsUnlitSurfacesAsTheyAre) {
  open("red");
  DisplaySettings& display = rig.state().display;
  const Film& film = rig.film();
  const std::size_t centre = film.index(film.width / 2, film.height / 2);
  const auto at = static_cast<std::size_t>(film.height / 2 * rig.size().x + film.width / 2);
  EXPECT_EQ(film.unlit.at(centre).w, 1.0f);
  for (const NamedTone& tone : tone_names) {
    for (const float ev : {0.0f, 1.5f}) {
      display.tone = tone.value;
      display.exposure_ev = ev;
      ASSERT_TRUE(rig.settle());
      rig.frame();
      EXPECT_EQ(rig.pixels()[at], display_bytes(glm::vec3(0.8f, 0.1f, 0.1f), 0.0f)) << tone.name;
    }
  }
}

TEST_F(WindowContentTest, ExposureChangesPixelsButRestartsNothing) {
  open("red");
  const std::uint64_t restarts = rig.render().restarts();
  const std::vector<glm::u8vec3> before = rig.pixels();
  rig.state().display.exposure_ev = -1.5f;
  rig.frame();
  EXPECT_NE(rig.pixels(), before);
  expect_area([](const Film& film, std::size_t i) {
    return display_bytes(film, i, {-1.5f, usual_display.tone});
  });
  EXPECT_EQ(rig.render().restarts(), restarts);
}

TEST_F(WindowContentTest, TheGridIsDrawnOverThePictureAndRestartsNothing) {
  open("red");
  const std::uint64_t restarts = rig.render().restarts();
  const std::vector<glm::u8vec3> before = rig.pixels();
  rig.state().display.show_grid = true;
  rig.frame();
  const std::vector<glm::u8vec3> with = rig.pixels();
  std::size_t changed = 0;
  for (std::size_t i = 0; i < with.size(); ++i) changed += with[i] != before[i];
  EXPECT_GT(changed, with.size() / 200);
  EXPECT_LT(changed, with.size() / 2);
  rig.state().display.show_grid = false;
  rig.frame();
  EXPECT_EQ(rig.pixels(), before);
  EXPECT_EQ(rig.render().restarts(), restarts);
}

TEST(GridStep, IsRoundAndFitsTheScene) {
  for (const double radius : {1e-9, 0.3, 1.0, 4.9, 5.1, 777.0, 1e12}) {
    const double step = grid_step(radius);
    EXPECT_GE(step, 0.2 * radius * (1.0 - 1e-9));
    EXPECT_LE(step, 0.5 * radius * (1.0 + 1e-9));
    const double digits = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
    EXPECT_TRUE(std::abs(digits - 1.0) < 1e-6 || std::abs(digits - 2.0) < 1e-6 ||
                std::abs(digits - 5.0) < 1e-6)
        << digits;
  }
  EXPECT_EQ(grid_step(0.0), 0.0);
  EXPECT_EQ(grid_step(NAN), 0.0);
}

// Transparent areas show a checkerboard, in the window only.
TEST_F(WindowContentTest, ATransparentBackgroundIsChequered) {
  open("red");
  rig.settings().background.kind = BackgroundKind::transparent;
  ASSERT_TRUE(rig.settle());
  const Film& film = rig.film();
  ASSERT_EQ(film.coverage.size(), film.radiance.size());
  EXPECT_EQ(film.coverage[film.index(1, 1)], 0.0f);
  EXPECT_EQ(film.coverage[film.index(film.width / 2, film.height / 2)], 1.0f);
  expect_area([](const Film& shown, std::size_t i) {
    const auto width = static_cast<std::size_t>(shown.width);
    const float square = (i % width / 8 + i / width / 8) % 2 == 0 ? 0.4f : 0.25f;
    const glm::vec3 before = shown.radiance[i] + (1.0f - shown.coverage[i]) * square;
    return display_bytes(tone_mapped(before, shown.unlit[i], usual_display), 0.0f);
  });
}

// Each curve changes the displayed bytes; the exposure applies before the curve. The method takes
// the same samples for all curves.
TEST_F(WindowContentTest, ToneCurvesChangePixelsButRestartNothing) {
  rig.settings().method = Method::sobol;
  open("red");
  DisplaySettings& display = rig.state().display;
  const Film& film = rig.film();
  const std::uint64_t restarts = rig.render().restarts();
  for (const float ev : {0.0f, 1.0f}) {
    for (const NamedTone& tone : tone_names) {
      display.exposure_ev = ev;
      display.tone = tone.value;
      rig.frame();
      const std::vector<glm::u8vec3> pixels = rig.pixels();
      for (const glm::ivec2 at : {glm::ivec2(5, 5), glm::ivec2(film.width, film.height) / 2})
        EXPECT_EQ(pixels[static_cast<std::size_t>(at.y * rig.size().x + at.x)],
                  display_bytes(film, film.index(at.x, at.y), display.transform()))
            << tone.name << " " << ev;
    }
  }
  EXPECT_EQ(rig.render().restarts(), restarts);
}

// EPS limits the error after the tone curve and ignores the exposure, so only a new curve restarts
// the render.
TEST_F(WindowContentTest, AMethodThatJudgesWhatShowsRendersEachCurveAnew) {
  open("red");
  DisplaySettings& display = rig.state().display;
  for (const Method method : {Method::asos, Method::sobol_adaptive}) {
    rig.settings().method = method;
    ASSERT_TRUE(rig.settle());
    for (const ToneCurve curve : {ToneCurve::agx, ToneCurve::none, ToneCurve::neutral}) {
      const std::uint64_t restarts = rig.render().restarts();
      display.tone = curve;
      ASSERT_TRUE(rig.settle());
      EXPECT_EQ(rig.render().restarts(), restarts + 1);
      EXPECT_EQ(rig.render().settings().judged_tone, curve);
      display.exposure_ev = 1.0f - display.exposure_ev;
      ASSERT_TRUE(rig.settle());
      EXPECT_EQ(rig.render().restarts(), restarts + 1);
    }
  }
}

TEST_F(WindowContentTest, TheSplitMapHidesThePictureAtFullDimming) {
  open("red");
  const std::uint64_t restarts = rig.render().restarts();
  rig.state().display.show_split_map = true;
  rig.state().display.show_legend = false;
  rig.state().display.split_dimming = 1.0f;
  rig.frame();
  int split = 0;
  expect_area([&](const Film& film, std::size_t i) {
    split += film.cause[i] != SplitCause::none;
    return SplitMapKey{}.colour(SplitMapKey{}.value(film, i));
  });
  EXPECT_GT(split, 0) << "the scene has to have split pixels for this to say anything";
  EXPECT_EQ(rig.render().restarts(), restarts);
}

TEST_F(WindowContentTest, TheSplitMapDimsOnlyWhatIsNotSplit) {
  open("red");
  rig.state().display.show_split_map = true;
  rig.state().display.show_legend = false;
  rig.state().display.split_dimming = 0.25f;
  rig.frame();
  const PixelRect area = rig.content().picture_rect();
  const Film& film = rig.film();
  const std::vector<glm::u8vec3> pixels = rig.pixels();
  int split = 0;
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) {
      const std::size_t i = film.index(x, y);
      const glm::vec3 got(pixels[static_cast<std::size_t>(y * rig.size().x + x)]);
      if (film.cause[i] != SplitCause::none) {
        ++split;
        ASSERT_EQ(got, glm::vec3(SplitMapKey{}.colour(SplitMapKey{}.value(film, i))))
            << x << ' ' << y;
      } else {
        // Blending rounds its weight and its result to bytes.
        const glm::vec3 want = 0.75f * glm::vec3(display_bytes(film, i, usual_display));
        ASSERT_LE(glm::length(want - got), 2.0f) << x << ' ' << y;
      }
    }
  }
  EXPECT_GT(split, 0);
}

TEST_F(WindowContentTest, ZoomedPixelsAreSquares) {
  open("red");
  const glm::vec2 pointer(200.0f, 150.0f);
  rig.input().add(KeyChanged{Key::ctrl, true});
  for (int i = 0; i < 5; ++i) rig.wheel(pointer, 1.0f);
  rig.input().add(KeyChanged{Key::ctrl, false});
  rig.frame();
  const PictureView& view = rig.state().view;
  ASSERT_EQ(view.zoom(), 8);
  const PixelRect area = rig.content().picture_rect();
  const Film& film = rig.film();
  const std::vector<glm::u8vec3> pixels = rig.pixels();
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) {
      const glm::vec2 at =
          view.picture_from_area({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
      const std::size_t i = film.index(static_cast<int>(at.x), static_cast<int>(at.y));
      ASSERT_EQ(pixels[static_cast<std::size_t>(y * rig.size().x + x)],
                display_bytes(film, i, usual_display))
          << x << ' ' << y;
    }
  }
  EXPECT_EQ(rig.render().restarts(), 1u) << "zoom is display only";
}

TEST_F(WindowContentTest, ResizingToNothingAndBackKeepsThePicture) {
  open("red");
  rig.resize({0, 0});
  for (int i = 0; i < 20; ++i) rig.frame();
  rig.resize({640, 400});
  ASSERT_TRUE(rig.settle());
  EXPECT_EQ(rig.render().restarts(), 1u);
  expect_area(
      [](const Film& film, std::size_t i) { return display_bytes(film, i, usual_display); });
}

TEST_F(WindowContentTest, TinyWindowsAreDrawn) {
  open("red");
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(40, 3), glm::ivec2(3, 200)}) {
    rig.resize(size);
    for (int i = 0; i < 30; ++i) rig.frame();
    const PixelRect area = rig.content().picture_rect();
    EXPECT_LE(area.width, size.x);
    EXPECT_LE(area.height, size.y);
  }
  rig.resize({700, 420});
  ASSERT_TRUE(rig.settle());
  expect_area(
      [](const Film& film, std::size_t i) { return display_bytes(film, i, usual_display); });
}

TEST_F(WindowContentTest, TheRenderFollowsTheWindowsSize) {
  open("red");
  rig.resize({900, 500});
  ASSERT_TRUE(rig.settle());
  EXPECT_EQ(rig.render().restarts(), 2u);
  expect_area(
      [](const Film& film, std::size_t i) { return display_bytes(film, i, usual_display); });
}

TEST_F(WindowContentTest, AnErrorIsShownAndTheOldSceneStays) {
  open("red");
  const std::vector<glm::u8vec3> before = rig.pixels();
  rig.scene().open("/no/such.glb");
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene().error().has_value(); }));
  rig.frame();
  rig.frame();
  EXPECT_NE(rig.pixels(), before) << "the message covers part of the picture";
  EXPECT_EQ(rig.scene()->geometry->source, "red");

  static std::string copied;
  copied.clear();
  ImGui::GetIO().SetClipboardTextFn = [](void*, const char* text) { copied = text; };
  rig.click("Copy");
  EXPECT_EQ(copied, "/no/such.glb: there is no such file");
  rig.click("Close");
  EXPECT_FALSE(rig.scene().error().has_value());
  rig.move_to({-10.0f, -10.0f});
  rig.frame();
  EXPECT_EQ(rig.pixels(), before);
}

TEST_F(WindowContentTest, AnIdleWindowAsksForNoFrames) {
  open("red");
  for (int i = 0; i < 5; ++i) rig.frame();
  EXPECT_FALSE(rig.content().seconds_to_redraw().has_value());
  rig.input().add(MouseMoved{{100.0f, 100.0f}});
  EXPECT_EQ(rig.content().seconds_to_redraw(), 0.0);
  for (int i = 0; i < 5; ++i) rig.frame();
  EXPECT_FALSE(rig.content().seconds_to_redraw().has_value());
}

TEST_F(WindowContentTest, WithoutASceneThereIsAnInvitation) {
  for (int i = 0; i < 3; ++i) rig.frame();
  const std::uint32_t rgb = theme::rgb(theme::Look::dark, theme::ground);
  const glm::u8vec3 ground((rgb >> 16) & 255u, (rgb >> 8) & 255u, rgb & 255u);
  const std::vector<glm::u8vec3> pixels = rig.pixels();
  EXPECT_EQ(pixels[5 * 640 + 5], ground);
  const PixelRect area = rig.content().picture_rect();
  int bright = 0;
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) {
      bright += pixels[static_cast<std::size_t>(y * 640 + x)].y > 150 ? 1 : 0;
    }
  }
  EXPECT_GT(bright, 50) << "text";
}

TEST(WindowContentScale, TextFollowsTheScreensScale) {
  UiRig plain(load, {1000, 700});
  plain.frame();
  plain.frame();
  const auto height_plain = plain.control("Open...").hi.y - plain.control("Open...").lo.y;
  UiRig fine(load, {1000, 700}, 2.0f);
  fine.frame();
  fine.frame();
  const auto height_fine = fine.control("Open...").hi.y - fine.control("Open...").lo.y;
  EXPECT_NEAR(height_fine / height_plain, 2.0, 0.05);
}

TEST(WindowContentReplace, AnotherSceneWhileOneLoads) {
  std::atomic<bool> released = false;
  std::atomic<bool> begun = false;
  UiRig rig([&](const std::string& source) -> Result<Scene> {
    if (source == "slow") {
      begun = true;
      while (!released) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return two_triangles(source == "slow" ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0), source);
  });
  rig.scene().open("slow");
  ASSERT_TRUE(rig.frames_until([&] { return begun.load(); }));
  for (int i = 0; i < 3; ++i) rig.frame();
  rig.scene().open("fast");
  for (int i = 0; i < 3; ++i) rig.frame();
  released = true;
  ASSERT_TRUE(rig.settle());
  EXPECT_EQ(rig.scene()->geometry->source, "fast");
  const PixelRect area = rig.content().picture_rect();
  const auto middle = static_cast<std::size_t>(area.height / 2 * 640 + area.width / 2);
  EXPECT_EQ(rig.pixels()[middle], glm::u8vec3(0, 255, 0)) << "unlit, as it is";
}

}  // namespace
}  // namespace asos
