#include "tests/ui/panels_fixture.h"
#include "ui/panels/card_place.h"
#include "ui/panels/pixel_place.h"
#include "ui/split_pixel.h"
#include "ui/tour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

// The end of the tour, its pixels, and the place of its card.

namespace asos::test::tour_end_test {
using namespace ui;
namespace {

class TourEndTest : public PanelsTest {
 protected:
  UiState& state() { return rig.state(); }
  void rest() {
    for (int i = 0; i < 40; ++i) rig.frame();
  }
  void undo() {
    rig.chord(Key::ctrl, Key::z);
    rig.frame();
  }
  // Goes to the card with the EPS slider, and drags it.
  void edit_eps() {
    rig.click("Tour");
    const char* slider = "Tolerance (EPS)";
    // The card moves when a pixel is found, so a click may miss its button.
    constexpr int tries = 20;
    for (int i = 0; i < tries && state().tour.card != Tour::Card::eps; ++i) {
      rig.frame();
      rig.click("Next");
      for (int k = 0; k < 3; ++k) rig.frame();
    }
    ASSERT_TRUE(rig.controls().contains(slider));
    const double before = settings().asos.eps;
    slide(slider, 0.6f, 0.05f);
    ASSERT_NE(settings().asos.eps, before);
    rest();
  }
};

TEST_F(TourEndTest, RestoresSettingsAndLeavesNothingToUndo) {
  const RenderSettings before = settings();
  edit_eps();
  rig.click("Close tour");
  rest();
  EXPECT_EQ(settings().asos, before.asos);
  EXPECT_FALSE(state().display.show_split_map);
  undo();
  EXPECT_EQ(state().message, "Nothing to undo");
  EXPECT_EQ(settings().asos, before.asos);
  EXPECT_FALSE(state().display.show_split_map);
}

TEST_F(TourEndTest, KeepsEditsAsOneStep) {
  const double eps = settings().asos.eps;
  const glm::dmat4 camera = rig.camera().camera().world_from_camera;
  edit_eps();
  rig.drag({100, 100}, {140, 110});
  rest();
  rig.wheel({100, 100}, 1.0f);
  rest();
  rig.click("Close tour");
  rest();
  EXPECT_EQ(settings().asos.eps, eps);
  EXPECT_NE(rig.camera().camera().world_from_camera, camera);
  undo();
  EXPECT_EQ(rig.camera().camera().world_from_camera, camera);
  EXPECT_EQ(settings().asos.eps, eps);
  undo();
  EXPECT_EQ(state().message, "Nothing to undo");
}

TEST_F(TourEndTest, KeepsEarlierSteps) {
  rig.click("Jitter unresolved cells");
  rest();
  edit_eps();
  rig.key(Key::escape);
  rest();
  EXPECT_TRUE(settings().asos.jitter);
  undo();
  EXPECT_FALSE(settings().asos.jitter);
}

TEST_F(TourEndTest, UndoWithinTheTourKeepsTheCardsMap) {
  edit_eps();
  const double edited = settings().asos.eps;
  undo();
  EXPECT_NE(settings().asos.eps, edited);
  EXPECT_TRUE(state().display.show_split_map) << "the card shows it";
}

TEST_F(TourEndTest, ReplaysOnlyOnceThereIsAPixel) {
  rig.refinement().set_paused(true);
  rig.camera().look_around(0.01, 0.0);
  rig.frame();
  rig.click_each({"Tour"});
  show_card(state(), rig.previewer(), static_cast<int>(Tour::Card::split), 0.0);
  for (int i = 0; i < 3; ++i) rig.frame();
  const auto shows = [&](const char* name) { return rig.controls().contains(name); };
  ASSERT_TRUE(shows("Next"));
  EXPECT_FALSE(state().tour.pixel) << "no pixel is final";
  EXPECT_FALSE(shows("Replay"));
  rig.refinement().set_paused(false);
  ASSERT_TRUE(rig.frames_until([&] { return shows("Replay"); }));
  // The search in the finished picture may choose another pixel.
  ASSERT_TRUE(rig.frames_until([&] { return state().tour.found.has_value(); }));
  ASSERT_TRUE(rig.settle());
  rig.click("Close inspector");
  EXPECT_FALSE(state().picked);
  rig.click("Replay");
  EXPECT_EQ(state().picked, state().tour.pixel);
  EXPECT_EQ(state().shown_level, 0);
}

TEST_F(TourEndTest, ReopensTheScene) {
  const auto opened = [&](const std::string& source) {
    return rig.frames_until([&] { return rig.scene()->geometry->source == source; });
  };
  rig.click("Tour");
  for (int i = 0; i < 3; ++i) rig.frame();
  rig.click("Show on the fence scene");
  ASSERT_TRUE(opened("builtin:fence"));
  ASSERT_TRUE(rig.settle());
  EXPECT_EQ(state().tour.card, Tour::Card::pyray);
  rig.click("Close tour");
  EXPECT_TRUE(opened("scene"));
}

TEST_F(TourEndTest, AsksBeforeTheFenceSceneIsOpened) {
  rig.click("Add light");
  rig.click("Tour");
  for (int i = 0; i < 3; ++i) rig.frame();
  rig.click("Show on the fence scene");
  for (int i = 0; i < 3; ++i) rig.frame();
  EXPECT_FALSE(rig.scene().loading().has_value());
  rig.click_each({"Cancel"});
  EXPECT_EQ(rig.scene()->geometry->source, "scene");
}

// Dark on the left, bright from x = 10 on, and a black and white checkerboard at the top.
Film with_edge() {
  Film film(20, 16);
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const float edge = x < 10 ? 0.05f : x == 10 ? 0.3f : 0.8f;
      film.radiance[film.index(x, y)] = glm::vec3(y < 4 ? static_cast<float>((x + y) % 2) : edge);
    }
  }
  return film;
}

TEST(ClearEdgePixel, IsBetweenTwoPlainColours) {
  const Film film = with_edge();
  EXPECT_EQ(clear_edge_pixel(film, 0.0f), glm::ivec2(10, 7));
  EXPECT_FALSE(clear_edge_pixel(Film(20, 16), 0.0f)) << "one colour";
  EXPECT_FALSE(clear_edge_pixel(Film{}, 0.0f));
}

// The card says that the pixel contains an edge, so it must not stay where a coarse picture had
// one.
TEST(ClearEdgePixel, IsKnownToHaveLostItsEdge) {
  Film film = with_edge();
  EXPECT_TRUE(on_clear_edge(film, {10, 7}, 0.0f));
  EXPECT_FALSE(on_clear_edge(film, {12, 7}, 0.0f)) << "bright, as its neighbours";
  EXPECT_FALSE(on_clear_edge(film, {1, 7}, 0.0f)) << "at the border";
  std::fill(film.radiance.begin(), film.radiance.end(), glm::vec3(0.5f));
  EXPECT_FALSE(on_clear_edge(film, {10, 7}, 0.0f));
}

TEST(ClearEdgePixel, MayHaveToBeSplitAndFinal) {
  Film film = with_edge();
  EXPECT_FALSE(clear_edge_pixel(film, 0.0f, ClearEdge::split)) << "no pixel is split";
  film.unfinished.assign(film.radiance.size(), 0);
  for (const glm::ivec2 pixel : {glm::ivec2(10, 12), glm::ivec2(10, 9), glm::ivec2(14, 7)}) {
    film.split_level[film.index(pixel.x, pixel.y)] = 2;
    film.cause[film.index(pixel.x, pixel.y)] = SplitCause::outline;
  }
  EXPECT_EQ(clear_edge_pixel(film, 0.0f, ClearEdge::split), glm::ivec2(10, 9));
  film.unfinished[film.index(10, 9)] = 1;
  EXPECT_EQ(clear_edge_pixel(film, 0.0f, ClearEdge::split), glm::ivec2(10, 12));
}

TEST(MostSplitPixel, IsFinal) {
  Film film(9, 5);
  film.unfinished.assign(film.radiance.size(), 0);
  film.split_level[film.index(4, 2)] = 3;
  film.split_level[film.index(0, 0)] = 1;
  EXPECT_EQ(most_split_pixel(film), glm::ivec2(4, 2));
  film.unfinished[film.index(4, 2)] = 1;
  EXPECT_EQ(most_split_pixel(film), glm::ivec2(0, 0)) << "the other one is predicted";
}

bool touch(const WindowRect& a, const WindowRect& b) {
  return a.lo.x < b.lo.x + b.size.x && b.lo.x < a.lo.x + a.size.x && a.lo.y < b.lo.y + b.size.y &&
         b.lo.y < a.lo.y + a.size.y;
}

TEST(CardPlace, TouchesNothingWhereThereIsRoom) {
  constexpr float em = 10.0f;
  const WindowRect room{{5, 5}, {650, 500}};
  const std::vector<WindowRect> taken{{{5, 5}, {320, 500}}, {{420, 60}, {20, 20}}};
  const CardPlace place = card_place(room, {160}, taken, em);
  for (const WindowRect& rect : taken)
    EXPECT_FALSE(touch({place.lo, {place.width, 160}}, rect)) << place.lo.x << ' ' << place.lo.y;
  const std::vector<WindowRect> wide{{{5, 5}, {450, 500}}};
  const CardPlace narrow = card_place(room, {160}, wide, em);
  EXPECT_LT(narrow.width, 250.0f) << "a narrower card fits";
  EXPECT_GE(narrow.lo.x, 455.0f);
  // Without enough room the card covers a part of a panel, but not the pixel.
  const WindowRect pixel{{20, 20}, {20, 20}}, panel{{5, 200}, {650, 305}};
  const std::vector<WindowRect> crowded{pixel, panel, {{250, 5}, {405, 180}}};
  const CardPlace cramped = card_place(room, {160}, crowded, em);
  EXPECT_FALSE(touch({cramped.lo, {cramped.width, 160}}, pixel)) << cramped.lo.x;
}

// A card whose text takes more lines when it is narrower. Its place must not depend on the width of
// the last frame, or it would jump forever.
TEST(CardPlace, RestsOnceItsWidthsWereDrawn) {
  constexpr float em = 28.0f;
  const WindowRect room{{14, 14}, {1252, 716}};
  for (float left = 300.0f; left < 1000.0f; left += 20.0f) {
    const std::vector<WindowRect> taken{{{14, 14}, {610, 716}}, {{left, 350}, {60, 60}}};
    CardHeights heights{};
    CardPlace place;
    bool rests = false;
    for (std::size_t frame = 0; frame < 2 * card_widths; ++frame) {
      const CardPlace next = card_place(room, heights, taken, em);
      rests = frame > 0 && next.lo == place.lo && next.width == place.width;
      place = next;
      heights[place.index] = 150.0f + 110000.0f / place.width;
    }
    EXPECT_TRUE(rests) << left;
    EXPECT_LE(place.lo.y + place.height, room.lo.y + room.size.y) << left;
  }
}

Controls::Placed placed(UiRig& rig, const std::string& name) {
  return rig.controls().at(name);
}

// Wherever the pixel is, the panel leaves room for the card: it shrinks rather than be covered.
TEST(PixelPlace, LeavesRoomForTheCard) {
  constexpr float em = 13.0f;
  for (const glm::vec2 size : {glm::vec2(500, 320), glm::vec2(640, 400), glm::vec2(1283, 600)}) {
    const WindowRect picture = WindowLayout::of(size, em, false).picture;
    for (const float lines : {150.0f, 175.0f, 200.0f}) {
      const CardHeights heights{lines, 1.1f * lines, 1.3f * lines, 1.5f * lines};
      for (int i = 0; i < 400; ++i) {
        const WindowRect pixel{
            picture.lo + picture.size * (glm::vec2(i % 20, i / 20) + 0.5f) / 20.0f, {4, 4}};
        SCOPED_TRACE(testing::Message() << size.x << " x " << size.y << ", card " << lines << ", "
                                        << pixel.lo.x << ' ' << pixel.lo.y);
        const PixelPlace usual = place_beside_pixel(pixel.lo + 2.0f, picture, size, em);
        const PixelPlace place = place_beside_card(usual, pixel, picture, heights, em);
        const WindowRect panel{place.lo, {place.width, place.most_height}};
        const std::vector<WindowRect> taken{panel, pixel};
        const CardPlace card = card_place(room_for_card(picture, em), heights, taken, em);
        EXPECT_TRUE(card.free);
        EXPECT_FALSE(touch(panel, pixel));
        EXPECT_GE(panel.size.x, 8.0f * em) << "wide enough to be shown";
        EXPECT_GE(panel.size.y, 6.0f * em) << "high enough to be shown";
      }
    }
  }
}

// Lists pixels near the centre and at two sides. The tour might choose any of them.
std::vector<glm::ivec2> spread_pixels(const Film& film) {
  std::vector<glm::ivec2> all;
  for (const glm::ivec2 tenth :
       {glm::ivec2(4, 5), glm::ivec2(5, 2), glm::ivec2(6, 8), glm::ivec2(1, 5), glm::ivec2(9, 3)})
    all.push_back(glm::ivec2(film.width, film.height) * tenth / 10);
  return all;
}

void expect_card_touches_none(UiRig& rig, int card) {
  const auto& all = rig.controls();
  ASSERT_TRUE(all.contains("Card")) << card;
  const Controls::Placed at = placed(rig, "Card");
  for (const char* other : {"Pixel panel", "Map legend"}) {
    if (!all.contains(other)) continue;
    const Controls::Placed over = placed(rig, other);
    EXPECT_FALSE(touch({at.lo, at.hi - at.lo}, {over.lo, over.hi - over.lo}))
        << card << " and " << other << ": " << at.lo.x << ' ' << at.lo.y << ' ' << at.hi.x << ' '
        << at.hi.y << ", " << over.lo.x << ' ' << over.lo.y << ' ' << over.hi.x << ' ' << over.hi.y;
  }
}

// The card covers no other panel at common window sizes, whichever pixel the tour's search finds.
TEST(TourCard, CoversNoOtherPanel) {
  struct Case {
    glm::ivec2 size;
    float scale;
  };
  for (const Case& c : {Case{{1000, 640}, 1.0f}, Case{{1000, 640}, 2.0f}, Case{{1280, 800}, 2.0f},
                        Case{{420, 760}, 1.0f}}) {
    SCOPED_TRACE(std::to_string(c.size.x) + " at " + std::to_string(c.scale));
    UiRig rig(LoadFunction{}, c.size, c.scale);
    rig.set_pixel_size(8);
    rig.settings().asos.max_level = 1;
    ASSERT_TRUE(rig.opens("builtin:fence") && rig.settle());
    rig.state().tour_asked = true;
    rig.frame();
    for (int card = 0; card < Tour::cards; ++card) {
      show_card(rig.state(), rig.previewer(), card, 0.0);
      ASSERT_TRUE(rig.settle());
      ASSERT_TRUE(rig.sleeps()) << "the search for a pixel has ended";
      expect_card_touches_none(rig, card);
      if (card != static_cast<int>(Tour::Card::split)) continue;
      for (const glm::ivec2 pixel : spread_pixels(rig.film())) {
        SCOPED_TRACE(std::to_string(pixel.x) + ' ' + std::to_string(pixel.y));
        rig.state().picked = pixel;
        rig.frame();
        ASSERT_TRUE(rig.sleeps()) << "the pixel's report has come";
        expect_card_touches_none(rig, card);
        const auto& all = rig.controls();
        ASSERT_TRUE(all.contains("Pixel panel") && all.contains("Subdivision"));
        EXPECT_LE(all.at("Subdivision").hi.y, all.at("Pixel panel").hi.y) << "all of the drawing";
        EXPECT_LE(all.at("Subdivision").hi.x, all.at("Pixel panel").hi.x);
      }
    }
  }
}

// The picked pixel may be anywhere in the picture.
TEST(TourCard, RestsForAnyPixel) {
  UiRig rig(LoadFunction{}, {1280, 800}, 2.0f);
  rig.set_pixel_size(8);
  rig.settings().asos.max_level = 1;
  ASSERT_TRUE(rig.opens("builtin:boxes") && rig.settle());
  rig.state().tour_asked = true;
  rig.frame();
  show_card(rig.state(), rig.previewer(), 1, 0.0);
  ASSERT_TRUE(rig.settle());
  const Film& film = rig.film();
  for (int y = 5; y < film.height; y += 20) {
    for (int x = 5; x < film.width; x += 20) {
      rig.state().picked = glm::ivec2(x, y);
      rig.frame();
      ASSERT_TRUE(rig.sleeps()) << "the pixel's report has come";
      const Controls::Placed at = placed(rig, "Card");
      for (int i = 0; i < 3; ++i) {
        rig.frame();
        EXPECT_EQ(placed(rig, "Card").lo, at.lo) << x << ' ' << y;
      }
      const WindowRect& picture = rig.content().layout().picture;
      EXPECT_LE(placed(rig, "Card").hi.y, picture.lo.y + picture.size.y) << x << ' ' << y;
    }
  }
}

}  // namespace
}  // namespace asos::test::tour_end_test
