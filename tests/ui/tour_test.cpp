#include "ui/tour.h"

#include "renderer/asos/pixel_trace.h"
#include "tests/ui/panels_fixture.h"
#include "ui/panels/pixel_place.h"
#include "ui/snapshot_view.h"
#include "ui/split_pixel.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

// The tour, the sections' help, and the explanation of a pixel.

namespace asos::test::tour_test {
using namespace ui;
namespace {

class TourTest : public PanelsTest {
 protected:
  UiState& state() { return rig.state(); }
  [[nodiscard]] bool has(const std::string& control) { return rig.controls().contains(control); }
  void begin() {
    rig.click_each({"Tour"});
    ASSERT_TRUE(has("Next"));
  }
  // The card moves when a pixel is found, so a click may miss its button.
  void next() {
    const auto before = state().tour.card;
    constexpr int tries = 20;
    for (int i = 0; i < tries && state().tour.card == before; ++i) {
      rig.click_each({"Next"});
      rig.frame();
    }
  }
};

TEST(MostSplitPixel, IsTheDeepestNearestToTheMiddle) {
  Film film(9, 5);
  EXPECT_FALSE(most_split_pixel(film));
  film.split_level[film.index(4, 2)] = 1;
  film.split_level[film.index(0, 0)] = 3;
  film.split_level[film.index(6, 3)] = 3;
  film.split_level[film.index(8, 4)] = 3;
  EXPECT_EQ(most_split_pixel(film), glm::ivec2(6, 3));
  film.cause[film.index(6, 3)] = SplitCause::shadow;
  film.cause[film.index(4, 2)] = SplitCause::outline;
  EXPECT_EQ(most_split_pixel(film), glm::ivec2(4, 2)) << "split by itself";
  film.cause[film.index(8, 4)] = SplitCause::depth_limit;
  EXPECT_EQ(most_split_pixel(film), glm::ivec2(8, 4)) << "split all the way";
  Film sampled(3, 1);
  sampled.cause[1] = SplitCause::shading;
  EXPECT_EQ(most_split_pixel(sampled), glm::ivec2(1, 0)) << "not divided, but not one sample";
  EXPECT_FALSE(most_split_pixel(Film{}));
}

// The pixel that the tour chooses in a scene's finished picture.
class TourOf {
 public:
  TourOf(const std::string& scene, int max_level) : rig(LoadFunction{}, {700, 300}) {
    rig.set_pixel_size(3);
    rig.settings().asos.max_level = max_level;
    rig.scene().open(scene);
    opened_ = rig.frames_until([&] { return rig.scene().get() != nullptr; }) && rig.settle();
    rig.state().tour_asked = true;
    rig.frame();
  }
  [[nodiscard]] bool found() {
    const auto begin = std::chrono::steady_clock::now();
    const bool found = opened_ && rig.frames_until([&] { return state().tour.found.has_value(); });
    took_ = std::chrono::steady_clock::now() - begin;
    return found;
  }
  /// Whether the time limit may have ended the search before it was complete.
  [[nodiscard]] bool cut_short() const { return took_ > 0.9 * SplitPixelSearch::longest; }
  const UiState& state() { return rig.state(); }
  const Film& film() { return rig.film(); }

  UiRig rig;

 private:
  bool opened_ = false;
  std::chrono::duration<double> took_{0.0};
};

// Few of the pixels that an edge crosses are split, because most are cut cleanly; some are split
// for their shading. If there is none, the card explains one that is cut.
TEST(TourOfAScene, WatchesAPixelThatIsSplit) {
  int split = 0;
  bool cut_short = false;
  for (const char* scene : {"builtin:office", "builtin:boxes"}) {
    SCOPED_TRACE(scene);
    TourOf tour(scene, 2);
    ASSERT_TRUE(tour.found());
    cut_short |= tour.cut_short();
    tour.rig.click("Next");
    tour.rig.frame();
    ASSERT_TRUE(tour.state().picked);
    EXPECT_EQ(tour.state().picked, tour.state().tour.found);
    const glm::ivec2 pixel = *tour.state().picked;
    const Snapshot picture = tour.rig.render().snapshot();
    const PixelTrace trace =
        trace_pixel(*picture.scene, view_of(picture), picture.settings, pixel.x, pixel.y);
    EXPECT_EQ(trace.cells.size() > 4, !tour.state().tour.none_split);
    const bool cut = std::any_of(trace.cells.begin(), trace.cells.end(),
                                 [](const TracedCell& cell) { return cell.samples.size() > 1; });
    EXPECT_TRUE(trace.cells.size() > 4 || cut) << pixel.x << ' ' << pixel.y;
    split += trace.cells.size() > 4;
  }
  EXPECT_TRUE(split > 0 || cut_short);
}

// The first card shows the neighbouring pixels: they have to differ visibly.
TEST(TourOfAScene, ShowsAPixelThatStandsOut) {
  TourOf tour("builtin:boxes", 4);
  ASSERT_TRUE(tour.found());
  const glm::ivec2 pixel = *tour.state().tour.found;
  int darkest = 255, brightest = 0;
  for (int y = pixel.y - 1; y <= pixel.y + 1; ++y) {
    for (int x = pixel.x - 1; x <= pixel.x + 1; ++x) {
      const glm::ivec2 at = glm::clamp(glm::ivec2(x, y), glm::ivec2(0),
                                       glm::ivec2(tour.film().width, tour.film().height) - 1);
      const int green = display_bytes(tour.film().radiance[tour.film().index(at.x, at.y)], 0.0f).y;
      darkest = std::min(darkest, green);
      brightest = std::max(brightest, green);
    }
  }
  EXPECT_GE(brightest - darkest, 60) << pixel.x << ' ' << pixel.y;
}

// Wherever the pixel is, its panel is inside the window and does not cover it.
TEST(PixelPlace, LeavesThePixelVisible) {
  constexpr float em = 13.0f;
  for (const glm::vec2 size : {glm::vec2(1283, 600), glm::vec2(420, 760), glm::vec2(600, 500),
                               glm::vec2(900, 420), glm::vec2(420, 400)}) {
    for (const bool panel : {true, false}) {
      const WindowRect picture = WindowLayout::of(size, em, panel).picture;
      for (int i = 0; i <= 400; ++i) {
        const glm::vec2 pixel = picture.lo + picture.size * glm::vec2(i % 20, i / 20) / 20.0f;
        const PixelPlace place = place_beside_pixel(pixel, picture, size, em);
        const glm::vec2 hi = place.lo + glm::vec2(place.width, place.most_height);
        SCOPED_TRACE(testing::Message()
                     << size.x << " x " << size.y << ", " << pixel.x << ' ' << pixel.y);
        EXPECT_GE(
            std::max({place.lo.x - pixel.x, pixel.x - hi.x, place.lo.y - pixel.y, pixel.y - hi.y}),
            em);
        EXPECT_GE(std::min(place.lo.x, place.lo.y), 0.0f);
        EXPECT_LE(hi.x, size.x);
        EXPECT_LE(hi.y, size.y);
        EXPECT_GE(place.most_height, 6.0f * em) << "there is room for some of it";
      }
    }
  }
}

// In a narrow window the pixel panel would otherwise cover the picture and the tour's card.
TEST(PixelPlace, LeavesThePictureWhereThereIsRoomBelowIt) {
  constexpr float em = 13.0f;
  const glm::vec2 size(420, 760);
  const WindowRect picture = WindowLayout::of(size, em, true).picture;
  for (float x = 0.0f; x <= 1.0f; x += 0.05f) {
    const glm::vec2 pixel = picture.lo + picture.size * glm::vec2(x, 0.5f);
    EXPECT_GE(place_beside_pixel(pixel, picture, size, em).lo.y, picture.lo.y + picture.size.y)
        << x;
  }
}

TEST_F(TourTest, NothingCoversTheWatchedPixelInANarrowWindow) {
  rig.resize({420, 760});
  rig.frame();
  ASSERT_TRUE(rig.settle());
  begin();
  for (int k = 0; k < 3; ++k) rig.frame();  // the card finds its size
  show_card(state(), rig.previewer(), 1, 0.0);
  ASSERT_TRUE(rig.frames_until([&] { return has("Subdivision"); }));
  ASSERT_TRUE(rig.sleeps());  // the search for a pixel has ended, and the card has its place
  const PictureArea area{
      {{0.0f, 0.0f},
       glm::vec2(rig.content().picture_rect().width, rig.content().picture_rect().height)},
      1.0f};
  const WindowRect at = shown_pixel(*state().picked, state().view, area);
  const glm::vec2 middle = at.lo + 0.5f * at.size;
  for (const char* name : {"Pixel panel", "Card"}) {
    ASSERT_TRUE(has(name));
    const Controls::Placed over = rig.controls().at(name);
    EXPECT_TRUE(middle.x < over.lo.x || middle.x > over.hi.x || middle.y < over.lo.y ||
                middle.y > over.hi.y)
        << name << " covers " << middle.x << ' ' << middle.y;
  }
  rig.click_each({"Next"});
  EXPECT_EQ(state().tour.card, Tour::Card::eps) << "its buttons are clicked, too";
}

TEST_F(TourTest, EachCardActsOnThePictureAndTheEndPutsItBack) {
  const std::uint64_t revision = rig.camera().revision();
  begin();
  EXPECT_TRUE(has("Loupe")) << "pixels of the picture, large";
  ASSERT_TRUE(state().tour.pixel);
  EXPECT_FALSE(has("Previous"));

  next();
  EXPECT_EQ(state().picked, state().tour.pixel);
  ASSERT_TRUE(rig.frames_until([&] { return has("Subdivision"); }));
  EXPECT_EQ(state().shown_level, 0) << "the whole pixel at first";
  std::vector<int> levels;
  for (int i = 0; i < 400 && state().shown_level; ++i) {
    if (levels.empty() || levels.back() != *state().shown_level)
      levels.push_back(*state().shown_level);
    rig.frame();
  }
  EXPECT_EQ(levels, (std::vector<int>{0, 1, 2})) << "down to MAX";
  EXPECT_FALSE(state().shown_level);
  rig.click("Replay");
  EXPECT_EQ(state().shown_level, 0);

  next();
  EXPECT_FALSE(state().picked);
  EXPECT_TRUE(state().display.show_split_map);
  const double eps = settings().asos.eps;
  slide("Tolerance (EPS)", 0.6f, 0.1f);
  EXPECT_NE(settings().asos.eps, eps);
  EXPECT_TRUE(restarted());

  next();
  rig.click("Map by/Cause");
  EXPECT_EQ(state().display.split_colours, SplitMapColours::cause);
  rig.click_each({"Previous"});
  EXPECT_TRUE(has("Tolerance (EPS)"));
  next();

  next();
  EXPECT_FALSE(state().display.show_split_map);
  EXPECT_FALSE(has("Next")) << "the last one";
  ASSERT_TRUE(rig.settle());
  rig.key(Key::s);
  ASSERT_EQ(state().frames.stored.size(), 1u) << "the user's own snapshot";
  rig.click("Compare now");
  ASSERT_TRUE(rig.frames_until([&] { return state().frames.comparison == Comparison::wipe; }));
  EXPECT_EQ(state().frames.stored.size(), 2u);
  rig.frame();
  rig.click_each({"Done"});
  EXPECT_FALSE(state().tour.card);
  ASSERT_EQ(state().frames.stored.size(), 1u)
      << "the rival's snapshot is gone, so quitting does not ask about it";
  EXPECT_TRUE(state().frames.stored[0].name.starts_with("ASOS, EPS"));
  EXPECT_EQ(state().frames.comparison, Comparison::none);
  EXPECT_FALSE(state().picked);
  EXPECT_EQ(state().display, DisplaySettings{});
  EXPECT_EQ(settings().asos.eps, eps) << "the slider's edit, too";
  EXPECT_EQ(rig.camera().revision(), revision);
}

TEST_F(TourTest, IsNotSeenTwiceUnlessItIsAskedFor) {
  EXPECT_FALSE(rig.content().stored_settings().tour_seen);
  begin();
  EXPECT_TRUE(rig.content().stored_settings().tour_seen);
  rig.key(Key::m);
  EXPECT_TRUE(state().display.show_split_map);
  EXPECT_FALSE(rig.content().stored_settings().display.show_split_map)
      << "a new window must not start with the map";
  rig.key(Key::escape);
  rig.frame();
  EXPECT_FALSE(state().tour.card);
  StoredSettings stored;
  stored.tour_seen = true;
  rig.content().apply(stored);
  rig.click_each({"Reset/Window"});
  EXPECT_TRUE(rig.content().stored_settings().tour_seen);
  begin();
}

TEST_F(TourTest, AnIdleWindowSleepsBesideACard) {
  begin();
  next();
  EXPECT_TRUE(rig.sleeps());
}

TEST_F(TourTest, TheWayOnStaysUnderThePointer) {
  begin();
  float first = 0.0f;
  for (int card = 0; card < Tour::cards; ++card) {
    for (int i = 0; i < 3; ++i) rig.frame();
    const bool last = card + 1 == Tour::cards;
    const Controls::Placed on = rig.control(last ? "Done" : "Next");
    // Relative to the card, which may be in another corner.
    const float left = on.lo.x - rig.control("Card").lo.x;
    if (card == 0) first = left;
    EXPECT_EQ(left, first) << card;
    if (!last) next();
  }
}

TEST_F(TourTest, FitsIntoAnyWindow) {
  begin();
  for (const glm::ivec2 size :
       {glm::ivec2(420, 600), glm::ivec2(200, 150), glm::ivec2(40, 40), glm::ivec2(1400, 900)}) {
    rig.resize(size);
    for (int i = 0; i < 3; ++i) rig.frame();
    if (!has("Close tour")) continue;
    const Controls::Placed end = rig.control("Close tour");
    EXPECT_LE(end.hi.x, static_cast<float>(size.x));
    EXPECT_LE(end.hi.y, static_cast<float>(size.y));
    EXPECT_GE(end.lo.x, 0.0f);
  }
}

TEST(TourInAWideWindow, NextStaysInItsPlace) {
  UiRig rig(LoadFunction{}, {1400, 900});
  rig.set_pixel_size(4);
  rig.settings().asos.max_level = 2;
  ASSERT_TRUE(rig.opens("builtin:boxes") && rig.settle());
  rig.state().tour_asked = true;
  glm::vec2 first(0.0f);
  for (int card = 0; card < Tour::cards; ++card) {
    ASSERT_TRUE(rig.settle());
    for (int i = 0; i < 10; ++i) rig.frame();
    const bool last = card + 1 == Tour::cards;
    const Controls::Placed next = rig.control(last ? "Done" : "Next");
    if (card == 0) first = next.lo;
    EXPECT_EQ(next.lo, first) << card;
    if (!last) rig.click("Next");
  }
}

// On a screen at 200 % the window has half as many units as pixels.
TEST(TourInANarrowWindow, EveryCardLiesWithinThePicture) {
  for (const float scale : {1.0f, 2.0f}) {
    UiRig rig(LoadFunction{}, {420, 760}, scale);
    rig.set_pixel_size(3);
    rig.settings().asos.max_level = 1;
    ASSERT_TRUE(rig.opens("builtin:boxes") && rig.settle());
    rig.state().tour_asked = true;
    for (int card = 0; card < Tour::cards; ++card) {
      for (int i = 0; i < 4; ++i) rig.frame();
      const Controls::Placed placed = rig.control("Card");
      const WindowRect& picture = rig.content().layout().picture;
      EXPECT_GE(placed.lo.x, picture.lo.x) << card << " at " << scale;
      EXPECT_GE(placed.lo.y, picture.lo.y) << card << " at " << scale;
      EXPECT_LE(placed.hi.x, picture.lo.x + picture.size.x) << card << " at " << scale;
      EXPECT_LE(placed.hi.y, picture.lo.y + picture.size.y) << card << " at " << scale;
      const Controls::Placed end = rig.control(card + 1 < Tour::cards ? "Close tour" : "Done");
      EXPECT_LE(end.hi.y, placed.hi.y) << card << " at " << scale << ": the difference is obvious";
      if (card + 1 < Tour::cards) rig.click("Next");
    }
  }
}

TEST_F(TourTest, EverySectionSaysWhatItIsFor) {
  ASSERT_TRUE(rig.opens("mirrors") && rig.settle());
  std::vector<std::string> sections;
  for (const auto& [name, placed] : rig.controls())
    if (name.starts_with("section/")) sections.push_back(name.substr(8));
  EXPECT_GE(sections.size(), 14u);
  for (const std::string& section : sections) {
    ASSERT_TRUE(has("Help/" + section)) << section << " has no help";
    rig.click("Help/" + section);
    for (int i = 0; i < 2; ++i) rig.frame();
    EXPECT_TRUE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        << section;
    rig.key(Key::escape);
    rig.frame();
  }
}

TEST_F(TourTest, TheMapsButtonExplainsAPixel) {
  EXPECT_FALSE(has("Why is this pixel like this?"));
  rig.key(Key::m);
  rig.frame();
  rig.frame();
  rig.click("Why is this pixel like this?");
  const Film& film = rig.film();
  ASSERT_TRUE(state().picked);
  EXPECT_EQ(state().picked, most_split_pixel(film));
  ASSERT_TRUE(rig.frames_until([&] { return has("Verdict"); }));
  EXPECT_TRUE(has("Why")) << "the cause, in words";
  // The explanation is above the numbers.
  EXPECT_LT(rig.control("Why").lo.y, rig.control("Linear").lo.y);
}

TEST_F(TourTest, TheStatusLineTellsThePixelUnderThePointer) {
  rig.move_to({100.0f, 100.0f});
  rig.frame();
  EXPECT_EQ(state().hovered, glm::ivec2(100, 100) / rig.pixel_size());
  EXPECT_TRUE(has("Pixel values"));
  rig.move_to({-1e5f, -1e5f});
  rig.frame();
  EXPECT_FALSE(has("Pixel values"));
}

}  // namespace
}  // namespace asos::test::tour_test
