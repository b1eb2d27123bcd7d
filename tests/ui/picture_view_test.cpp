#include "ui/picture_view.h"

#include <gtest/gtest.h>

namespace asos {
using namespace ui;
namespace {

PictureView view_of(glm::ivec2 area, glm::ivec2 picture) {
  PictureView view;
  view.set_sizes(area, picture);
  return view;
}

TEST(PictureView, APictureOfTheAreasSizeFillsItOneToOne) {
  const PictureView view = view_of({640, 360}, {640, 360});
  EXPECT_EQ(view.scale(), 1.0f);
  EXPECT_EQ(view.offset(), glm::vec2(0.0f));
}

TEST(PictureView, APictureOfAnotherShapeIsFittedIntoTheMiddle) {
  const PictureView view = view_of({640, 360}, {160, 180});
  EXPECT_EQ(view.scale(), 2.0f);
  EXPECT_EQ(view.offset(), glm::vec2(160.0f, 0.0f));
}

TEST(PictureView, ZoomKeepsThePointUnderThePointer) {
  PictureView view = view_of({640, 360}, {640, 360});
  const glm::vec2 pointer(400.0f, 100.0f);
  for (int i = 0; i < 6; ++i) {
    const glm::vec2 before = view.picture_from_area(pointer);
    view.zoom_at(pointer, 1);
    // Offsets are whole pixels, so the point may move by half a screen pixel.
    EXPECT_LE(glm::distance(view.picture_from_area(pointer), before), 0.75f / view.scale());
  }
  EXPECT_EQ(view.zoom(), 12);
}

TEST(PictureView, ZoomEndsAtBothEndsOfTheLadder) {
  PictureView view = view_of({640, 360}, {640, 360});
  view.zoom_at({10.0f, 10.0f}, 1000);
  EXPECT_EQ(view.zoom(), 64);
  view.zoom_at({10.0f, 10.0f}, -1000);
  EXPECT_EQ(view.zoom(), 1);
  EXPECT_EQ(view.offset(), glm::vec2(0.0f));
}

TEST(PictureView, PanStopsWhereThePictureEnds) {
  PictureView view = view_of({640, 360}, {640, 360});
  view.pan({50.0f, 50.0f});
  EXPECT_EQ(view.offset(), glm::vec2(0.0f));
  view.zoom_at({0.0f, 0.0f}, 1);
  view.pan({-100.0f, -1e6f});
  EXPECT_EQ(view.offset(), glm::vec2(-100.0f, -360.0f));
  view.reset();
  EXPECT_EQ(view.zoom(), 1);
  EXPECT_EQ(view.offset(), glm::vec2(0.0f));
}

TEST(PictureView, NothingIsVisibleWithoutArea) {
  for (const glm::ivec2 area : {glm::ivec2(0, 0), glm::ivec2(640, 0), glm::ivec2(-3, 5)}) {
    PictureView view = view_of(area, {640, 360});
    EXPECT_EQ(view.scale(), 0.0f);
    view.zoom_at({3.0f, 4.0f}, 2);
    view.pan({1.0f, 1.0f});
    EXPECT_EQ(view.picture_from_area({5.0f, 5.0f}), glm::vec2(0.0f));
    view.set_sizes({640, 360}, {640, 360});
    view.reset();
    EXPECT_EQ(view.offset(), glm::vec2(0.0f));
  }
}

}  // namespace
}  // namespace asos
