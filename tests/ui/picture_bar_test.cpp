#include "renderer/study/ladders.h"
#include "tests/ui/panels_fixture.h"
#include "ui/error_map.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

// The bar under the picture, and the display of the picture of the previous EPS and MAX.

namespace asos {
using namespace ui;
namespace {

class PictureBarTest : public test::PanelsTest {
 protected:
  explicit PictureBarTest(glm::ivec2 size = {1300, 700}, int pixel_size = 3)
      : PanelsTest(pixel_size, size) {
    rig.state().tab = PanelTab::antialias;
    rig.state().look.show_bar = true;
    EXPECT_TRUE(rig.settle());
    for (int i = 0; i < 3; ++i) rig.frame();
  }
  [[nodiscard]] DisplayTransform usual() { return display().transform(); }
  [[nodiscard]] const std::map<std::string, Controls::Placed>& all() { return rig.controls(); }
};

TEST_F(PictureBarTest, ChoosesWhatThePictureShows) {
  rig.click("Layer/Level");
  EXPECT_TRUE(display().show_split_map);
  EXPECT_EQ(display().split_colours, SplitMapColours::level);
  rig.click("Layer/Cause");
  EXPECT_EQ(display().split_colours, SplitMapColours::cause);
  rig.click("Layer/Time");
  EXPECT_EQ(display().split_colours, SplitMapColours::time);
  Frames& frames = rig.state().frames;
  rig.click("Layer/Difference");
  EXPECT_EQ(frames.comparison, Comparison::none) << "there is no snapshot";
  rig.click("Snapshot");
  ASSERT_EQ(frames.stored.size(), 1u);
  rig.click("Layer/Difference");
  EXPECT_EQ(frames.comparison, Comparison::difference);
  rig.click("Layer/Picture");
  EXPECT_EQ(frames.comparison, Comparison::none);
  EXPECT_FALSE(display().show_split_map);
}

// The keys [ and ] and the surface keys show layers in place of the picture. The bar once marked
// "Picture" meanwhile.
TEST_F(PictureBarTest, MarksTheLayerThatIsShown) {
  const UiState& state = rig.state();
  const auto marked = [&] { return all().at("Layers in bar").words; };
  EXPECT_EQ(marked(), "View");
  EXPECT_EQ(all().at("Layer/Picture").words, "chosen");
  rig.key(Key::right_bracket);
  rig.frame();
  EXPECT_EQ(marked(), "Alpha");
  EXPECT_EQ(all().at("Layer/Picture").words, "");
  rig.key(Key::n);
  rig.frame();
  EXPECT_EQ(marked(), "Normal (N)");
  display().show_split_map = true;
  rig.frame();
  EXPECT_FALSE(all().contains("Why is this pixel like this?")) << "the hidden map's legend";
  rig.click("Layer/Level");
  EXPECT_FALSE(state.shows_layer());
  EXPECT_TRUE(display().show_split_map);
  rig.click_each({"Layers in bar", "Layers in bar/Depth"});
  EXPECT_EQ(display().layer, Layer::depth);
  EXPECT_EQ(marked(), "Depth");
  EXPECT_EQ(all().at("Layer/Level").words, "");
  rig.click_each({"Layers in bar", "Layers in bar/None"});
  EXPECT_EQ(marked(), "View");
  EXPECT_EQ(all().at("Layer/Level").words, "chosen");
}

// A layer hides the split map and snapshots, so their keys end it.
TEST_F(PictureBarTest, KeysOfThePictureEndALayer) {
  const UiState& state = rig.state();
  rig.key(Key::s);
  for (const Key key : {Key::m, Key::c, Key::x, Key::one}) {
    display().layer = Layer::depth;
    display().show_split_map = true;
    rig.state().frames.comparison = Comparison::flip;
    rig.state().frames.flipped = false;
    rig.key(key);
    rig.frame();
    EXPECT_FALSE(state.shows_layer());
    EXPECT_TRUE(display().show_split_map);
    const bool flips = key == Key::x || key == Key::one;
    EXPECT_EQ(state.frames.flipped, flips);
  }
}

// Once the level map stood under the error's legend until there was a reference.
TEST_F(PictureBarTest, WithoutAReferenceTheErrorLayerIsTheDimmedPicture) {
  rig.set_pixel_size(1);
  display().show_axes = false;
  settings().asos.eps = 1e-6;  // so that the picture is not finished soon
  ASSERT_TRUE(rig.opens("grating"));
  rig.click("Layer/Level");
  rig.click("Layer/Error");
  rig.move_to({-10.0f, -10.0f});
  for (int i = 0; i < 3; ++i) rig.frame();
  const std::string words = all().at("Error reference").words;
  if (words.starts_with("Reference: ")) GTEST_SKIP() << "the reference came at once";
  EXPECT_TRUE(words == "Waiting for the finished picture" || words == "Sampling the reference")
      << words;
  const std::vector<glm::u8vec3> pixels = rig.pixels();
  const PixelRect area = rig.content().picture_rect();
  int brightest = 0, coloured = 0;
  for (int y = 0; y < area.height / 2; ++y) {  // above the legend
    for (int x = 0; x < area.width; ++x) {
      const glm::u8vec3 c = pixels[static_cast<std::size_t>(y * rig.size().x + x)];
      brightest = std::max({brightest, int{c.x}, int{c.y}, int{c.z}});
      coloured += std::max({c.x, c.y, c.z}) - std::min({c.x, c.y, c.z}) > 8;
    }
  }
  EXPECT_GT(brightest, 10);
  EXPECT_LT(brightest, 128) << "the picture, dimmed";
  EXPECT_EQ(coloured, 0) << "the grating is grey; the colours of a map are not";
}

// A click on Error samples the reference. The layer has a scale in display steps, and stays and is
// updated while EPS changes.
TEST_F(PictureBarTest, TheErrorLayerSamplesItsReference) {
  ASSERT_TRUE(rig.opens("grating"));
  rig.click("Layer/Error");
  const Frames& frames = rig.state().frames;
  EXPECT_EQ(frames.comparison, Comparison::error);
  EXPECT_TRUE(all().at("Layer/Error").has_tooltip);
  rig.frame();
  ASSERT_TRUE(all().contains("Comparison legend"));
  EXPECT_NE(all().at("Error scale").words.find("1 step"), std::string::npos);
  ASSERT_TRUE(rig.frames_until([&] {
    return all().at("Error reference").words == "Reference: 256 samples per pixel";
  })) << all().at("Error reference").words;
  rig.frame();
  EXPECT_NE(all().at("Error summary").words.find("above 1 step"), std::string::npos);
  EXPECT_FALSE(rig.state().check.check) << "the panel's own check stays off";
  settings().asos.eps = 0.3;
  for (int i = 0; i < 3; ++i) rig.frame();
  EXPECT_EQ(all().at("Error reference").words, "Reference: 256 samples per pixel")
      << "the reference belongs to the view, not to an EPS";
  rig.camera().orbit(0.1, 0.0);
  for (int i = 0; i < 3; ++i) rig.frame();
  EXPECT_NE(all().at("Error reference").words, "Reference: 256 samples per pixel");
  rig.key(Key::m);
  EXPECT_EQ(frames.comparison, Comparison::none);
  EXPECT_TRUE(display().show_split_map);
  rig.click("Layer/Error");
  rig.click("Layer/Picture");
  EXPECT_EQ(frames.comparison, Comparison::none);
}

// Going back to finished settings once rendered them again.
TEST_F(PictureBarTest, FinishedSettingsAreShownAtOnce) {
  ASSERT_TRUE(rig.settle());
  for (int i = 0; i < 4; ++i) rig.frame();
  const PreviewRender& render = rig.render();
  const Film first = render.film();
  const std::uint64_t rays = render.statistics().eye_rays;
  const AsosSettings before = settings().asos;
  settings().asos.max_level = 0;
  settings().asos.leaf = LeafKind::point;
  ASSERT_TRUE(rig.settle());
  ASSERT_NE(render.film().radiance, first.radiance);
  settings().asos = before;
  const std::uint64_t restarts = render.restarts();
  rig.frame();
  EXPECT_TRUE(render.progress().finished) << "in the next frame";
  EXPECT_GT(render.restarts(), restarts) << "what follows the picture is told of it";
  EXPECT_EQ(render.film().radiance, first.radiance);
  EXPECT_EQ(render.film().split_level, first.split_level);
  EXPECT_EQ(render.statistics().eye_rays, rays);
  // Its map still follows EPS.
  settings().asos.eps = 0.4;
  rig.frame();
  EXPECT_FALSE(render.progress().finished);
  ASSERT_TRUE(rig.settle());
  settings().asos = before;
  rig.frame();
  EXPECT_TRUE(render.progress().finished);
  rig.render().start_again();
  rig.frame();
  EXPECT_TRUE(rig.settle());
  EXPECT_EQ(render.film().radiance, first.radiance);
}

// From 24x on, as in other viewers of pictures.
TEST_F(PictureBarTest, ZoomedPixelsShowTheirNumbers) {
  rig.set_pixel_size(1);
  ASSERT_TRUE(rig.settle());
  PictureView& view = rig.state().view;
  view.zoom_at({0.0f, 0.0f}, 1);
  rig.frame();
  EXPECT_FALSE(all().contains("Pixel numbers"));
  while (view.zoom() < 24) view.zoom_at({0.0f, 0.0f}, 1);
  rig.frame();
  ASSERT_TRUE(all().contains("Pixel numbers"));
  const Film& film = rig.film();
  const glm::ivec2 first(-view.offset() / view.scale());
  const glm::u8vec3 c = display_bytes(film, film.index(first.x, first.y), display().transform());
  EXPECT_EQ(all().at("Pixel numbers").words, fmt::format("{}\n{}\n{}", c.x, c.y, c.z));
  display().show_split_map = true;
  rig.frame();
  EXPECT_FALSE(all().contains("Pixel numbers")) << "the map's colours are no display values";
}

TEST(ErrorScale, IsLogarithmicInDisplaySteps) {
  EXPECT_EQ(ErrorScale::share(0.0), 0.0f);
  EXPECT_EQ(ErrorScale::share(0.25), 0.0f);
  EXPECT_NEAR(ErrorScale::share(4.0), 0.5f, 1e-6f);
  EXPECT_EQ(ErrorScale::share(64.0), 1.0f);
  EXPECT_EQ(ErrorScale::share(255.0), 1.0f);
  Film a(1, 1), b(1, 1);
  const DisplayTransform plain{0.0f, ToneCurve::none};
  a.radiance[0] = glm::vec3(1.0f);
  b.radiance[0] = glm::vec3(1.0f, 1.0f, 0.0f);
  EXPECT_NEAR(error_steps(a, b, 0, plain), 255.0, 1e-3);
  EXPECT_NEAR(error_steps(a, a, 0, plain), 0.0, 1e-6);
}

// Once there was no bar at 420x300.
TEST_F(PictureBarTest, SmallWindowsChooseLayerEpsAndMaxInOneRow) {
  rig.resize({420, 300});
  for (int i = 0; i < 4; ++i) rig.frame();
  EXPECT_FALSE(all().contains("Layer/Level")) << "a list";
  const auto choose = [&](const std::string& name) {
    rig.click("Layer");
    for (int i = 0; i < 3; ++i) rig.frame();  // until the list has its size and place
    const Controls::Placed list = rig.control("Layer/Picture");
    while (rig.control("Layer/" + name).hi.y > 290.0f) rig.wheel(list.centre(), -1.0f);
    rig.click("Layer/" + name);
    rig.frame();
  };
  choose("Cause");
  EXPECT_TRUE(display().show_split_map);
  EXPECT_EQ(display().split_colours, SplitMapColours::cause);
  choose("Layer: Depth");
  EXPECT_EQ(display().layer, Layer::depth);
  EXPECT_EQ(all().at("Layer").words, "Layer: Depth");
  const double eps = settings().asos.eps;
  slide("EPS in bar", 0.5f, 0.9f);
  EXPECT_GT(settings().asos.eps, eps);
  slide("MAX in bar", 0.2f, 1.0f);
  EXPECT_EQ(settings().asos.max_level, max_level_limit);
}

TEST_F(PictureBarTest, SlidersAndMethodSetTheRender) {
  const double eps = settings().asos.eps;
  slide("EPS in bar", 0.5f, 0.9f);
  EXPECT_GT(settings().asos.eps, eps);
  slide("MAX in bar", 0.2f, 1.0f);
  EXPECT_EQ(settings().asos.max_level, max_level_limit);
  settings().asos.max_level = 2;
  slide("Exposure in bar", 0.5f, 0.8f);
  EXPECT_GT(display().exposure_ev, 1.0f);
  rig.click("+");
  EXPECT_EQ(rig.state().view.zoom(), 2);
  rig.click("Zoom");
  EXPECT_EQ(rig.state().view.zoom(), 1);
  settings().method = Method::sobol;
  for (int i = 0; i < 3; ++i) rig.frame();
  EXPECT_FALSE(all().contains("EPS in bar")) << "Sobol has none";
}

// For every position of a dragged slider, the map is in the frame that processes the event, which
// is due within 100 ms: while renders start, pause and wait for their first picture.
TEST_F(PictureBarTest, TheMapFollowsEveryStepOfADragAtOnce) {
  ASSERT_TRUE(rig.opens("grating") && rig.settle());
  rig.click("Layer/Level");
  const PreviewRender& render = rig.render();
  for (const char* name : {"EPS in bar", "MAX in bar"}) {
    const Controls::Placed at = rig.control(name);
    const auto place = [&](float share) {
      return glm::vec2(glm::mix(at.lo.x, at.hi.x, share), at.centre().y);
    };
    rig.rest();
    rig.move_to(place(0.96f));
    rig.press(MouseButton::left);
    for (const float share : {0.85f, 0.7f, 0.55f, 0.4f, 0.3f, 0.16f}) {
      const std::uint64_t before = render.map_revision();
      DrawSchedule schedule;
      schedule.begin_frame(1.0);
      schedule.end_frame(1.0, rig.content().seconds_to_redraw());
      schedule.note_input();
      EXPECT_LE(schedule.due(), 1.0 + 1.0 / 60.0 + 1e-9) << "the next frame";
      rig.input().add(MouseMoved{place(share)});
      rig.frame();
      EXPECT_GT(render.map_revision(), before) << name << " at " << share;
    }
    rig.release(MouseButton::left);
  }
}

/// A small window in which single pixels can be tested.
class SeenPictureBarTest : public PictureBarTest {
 protected:
  SeenPictureBarTest() : PictureBarTest({740, 420}, 1) {}
};

// A value that stands across the end of its bar is hard to read.
TEST_F(SeenPictureBarTest, TheBarOfASliderLiesBelowItsValue) {
  rig.move_to({5, 5});
  for (int i = 0; i < 3; ++i) rig.frame();
  const std::vector<glm::u8vec3> pixels = rig.pixels();
  for (const char* name : {"EPS in bar", "MAX in bar"}) {
    const Controls::Placed at = rig.control(name);
    const auto is_bar = [&](float y) {
      const auto i =
          static_cast<std::size_t>(static_cast<int>(y) * 740 + static_cast<int>(at.lo.x + 6.0f));
      return (pixels[i].x << 16 | pixels[i].y << 8 | pixels[i].z) ==
             static_cast<int>(theme::rgb(theme::accent));
    };
    EXPECT_TRUE(is_bar(at.hi.y - 2.0f)) << name;
    for (float y = at.lo.y + 3.0f; y < at.hi.y - 5.0f; y += 1.0f) EXPECT_FALSE(is_bar(y)) << y;
  }
}

TEST_F(SeenPictureBarTest, OneKeyShowsThePictureOfTheEpsBefore) {
  ASSERT_TRUE(rig.settle());
  const UiState& state = rig.state();
  const PreviewRender& render = rig.render();
  EXPECT_EQ(render.finished_before(), nullptr);
  rig.key(Key::v);
  EXPECT_FALSE(state.show_before);
  const RenderSettings first = render.settings();
  const Film before = render.film();
  // A drag starts many renders. The picture finished before the drag is the one to show.
  for (const double eps : {0.1, 0.3, 0.5}) {
    settings().asos.eps = eps;
    rig.frame();
  }
  settings().asos.max_level = 0;
  ASSERT_TRUE(rig.settle());
  ASSERT_NE(render.finished_before(), nullptr);
  EXPECT_EQ(render.finished_before()->settings, first);
  EXPECT_EQ(render.finished_before()->film.split_level, before.split_level);
  const std::uint64_t restarts = render.restarts();
  display().show_split_map = true;
  display().show_legend = false;
  rig.frame();
  const std::vector<glm::u8vec3> now = rig.pixels();
  rig.key(Key::v);
  EXPECT_TRUE(state.show_before);
  EXPECT_EQ(state.message,
            fmt::format("Before: EPS {}, MAX {}", eps_text(first.asos.eps), first.asos.max_level))
      << "as the slider says it";
  rig.state().message.clear();
  rig.frame();
  EXPECT_NE(rig.pixels(), now);
  EXPECT_EQ(render.restarts(), restarts) << "nothing is rendered again";
  rig.click("Now");
  EXPECT_FALSE(state.show_before);
  // Another view has no previous picture.
  rig.key(Key::v);
  rig.camera().orbit(0.1, 0.0);
  ASSERT_TRUE(rig.settle());
  EXPECT_EQ(render.finished_before(), nullptr);
  EXPECT_FALSE(state.show_before);
}

// A method's name alone says little.
// MAX once had no visible sense: most pictures look the same at 3 and at 4.
TEST_F(PictureBarTest, TheSliderOfMaxTellsWhatItChanges) {
  PreviewRender& render = rig.render();
  settings().asos.leaf = LeafKind::point;
  settings().asos.max_level = 0;
  ASSERT_TRUE(restarted());
  const Film coarse = render.film();
  settings().asos.max_level = 3;
  ASSERT_TRUE(restarted());
  const MaxEffect effect = max_effect(render, usual());
  ASSERT_TRUE(effect.change);
  EXPECT_EQ(effect.change->from, 0);
  EXPECT_EQ(effect.change->to, 3);
  const Film& fine = render.film();
  float most = 0.0f;
  std::size_t changed = 0, ended = 0;
  for (std::size_t i = 0; i < fine.radiance.size(); ++i) {
    const float steps = 255.0f * difference_of(coarse, fine, i, usual());
    most = std::max(most, steps);
    changed += steps >= 1.0f;
    ended += fine.cause[i] == SplitCause::depth_limit;
  }
  ASSERT_GT(changed, 0u);
  EXPECT_EQ(effect.change->pixels, changed);
  EXPECT_EQ(effect.change->steps, most);
  EXPECT_EQ(effect.ended_pixels, ended);
  ASSERT_FALSE(effect.worst.empty());
  const glm::ivec2 worst = effect.worst.front();
  EXPECT_EQ(255.0f * difference_of(coarse, fine, fine.index(worst.x, worst.y), usual()), most);

  rig.move_to(all().at("MAX in bar").centre());
  for (int i = 0; i < 40; ++i) rig.frame();
  EXPECT_EQ(rig.content().controls().told().name, "MAX in bar");
  EXPECT_NE(rig.content().controls().told().text.find(max_words(effect, 3)), std::string::npos)
      << rig.content().controls().told().text;
  rig.move_to({20.0f, 20.0f});
  for (int i = 0; i < 4; ++i) rig.frame();
  EXPECT_TRUE(rig.state().max_turn.words.empty());
  rig.move_to(all().at("MAX in bar").centre());
  rig.press(MouseButton::left);  // which sets another MAX
  const Controls& controls = rig.content().controls();
  ASSERT_TRUE(rig.frames_until([&] { return !controls.told().text.empty(); }));
  EXPECT_EQ(controls.told().text.find("Maximum"), std::string::npos)
      << "while it is turned, the effect alone is told";
  rig.release(MouseButton::left);
}

TEST_F(PictureBarTest, ListsTheMethodsWithALineEach) {
  rig.click_each({"Method in bar"});
  rig.frame();
  ASSERT_TRUE(all().contains("Method in bar line/Sobol"));
  EXPECT_EQ(all().at("Method in bar line/Sobol").words,
            "Fixed number of Owen-scrambled Sobol samples per pixel.");
  const Controls::Placed entry = rig.control("Method in bar/Sobol");
  const Controls::Placed line = rig.control("Method in bar line/Sobol");
  EXPECT_NEAR(line.centre().y, entry.centre().y, 2.0f) << "on the same line";
  rig.click_each({"Method in bar/Sobol"});
  EXPECT_EQ(settings().method, Method::sobol);
}

TEST_F(PictureBarTest, LeavesRoomForThePicture) {
  for (const glm::ivec2 size :
       {glm::ivec2(420, 300), {420, 700}, {700, 500}, {1000, 640}, {1920, 1080}}) {
    SCOPED_TRACE(testing::PrintToString(size.x) + " x " + testing::PrintToString(size.y));
    rig.resize(size);
    for (int i = 0; i < 4; ++i) rig.frame();
    const WindowLayout& layout = rig.content().layout();
    EXPECT_GT(layout.bar.size.y, 0.0f);
    EXPECT_GE(layout.picture.size.y, 1.5f * layout.bar.size.y - 1.0f);
    for (const auto& [name, at] : all()) {
      if (!name.ends_with(" in bar") && !name.starts_with("Layer/")) continue;
      EXPECT_GE(at.lo.y, layout.bar.lo.y) << name;
      EXPECT_LE(at.hi.y, layout.bar.lo.y + layout.bar.size.y) << name;
      EXPECT_LE(at.hi.x, layout.bar.size.x) << name;
    }
  }
}

}  // namespace
}  // namespace asos
