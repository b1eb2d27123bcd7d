#include "ui/window_layout.h"

#include "ui/theme.h"

#include <gtest/gtest.h>

namespace asos {
using namespace ui;
namespace {

float area(const WindowRect& rect) {
  return rect.size.x * rect.size.y;
}

TEST(WindowLayout, CoversEveryWindow) {
  for (const glm::vec2 window : {glm::vec2(1600, 900), glm::vec2(420, 700), glm::vec2(1, 1),
                                 glm::vec2(3, 2), glm::vec2(483, 20), glm::vec2(20, 900)}) {
    for (const bool show_panel : {true, false}) {
      const WindowLayout layout = WindowLayout::of(window, 15.0f, show_panel);
      EXPECT_NEAR(area(layout.picture) + area(layout.status) + area(layout.panel),
                  window.x * window.y, 1e-2f)
          << window.x << " x " << window.y;
      for (const WindowRect& rect : {layout.picture, layout.status, layout.panel})
        EXPECT_GE(std::min(rect.size.x, rect.size.y), 0.0f);
    }
  }
}

TEST(WindowLayout, LowWindowsHaveNoPanel) {
  const float em = theme::text_pixels;
  for (const float width : {400.0f, 900.0f}) {
    EXPECT_EQ(area(WindowLayout::of({width, 399.0f}, em, true).panel), 0.0f);
    EXPECT_GT(area(WindowLayout::of({width, 400.0f}, em, true).panel), 0.0f);
  }
}

TEST(WindowLayout, AnimationsHaveATimelineAboveTheBar) {
  const float em = theme::text_pixels;
  const WindowLayout with = WindowLayout::of({1200.0f, 800.0f}, em, true, true, true);
  const WindowLayout without = WindowLayout::of({1200.0f, 800.0f}, em, true, true, false);
  EXPECT_GT(area(with.timeline), 0.0f);
  EXPECT_EQ(area(without.timeline), 0.0f);
  EXPECT_EQ(with.bar.lo.y, with.timeline.lo.y + with.timeline.size.y);
  EXPECT_NEAR(area(with.picture) + area(with.timeline) + area(with.bar) + area(with.status) +
                  area(with.panel),
              1200.0f * 800.0f, 1e-2f);
}

// Small windows have no room for two rows: they once had no bar at all.
TEST(WindowLayout, SmallWindowsHaveABarOfOneRow) {
  constexpr float em = 15.0f;
  const auto bar_em = [&](glm::vec2 window, bool show_panel) {
    const WindowLayout layout = WindowLayout::of(window, em, show_panel, true);
    EXPECT_NEAR(area(layout.picture) + area(layout.status) + area(layout.panel) + area(layout.bar),
                window.x * window.y, 1e-2f);
    EXPECT_GE(layout.picture.size.y, 1.4f * layout.bar.size.y) << "the picture has the most";
    return layout.bar.size.y / em;
  };
  EXPECT_NEAR(bar_em({1280, 720}, true), theme::bar_height_em, 0.1f);
  EXPECT_NEAR(bar_em({420, 420}, true), theme::compact_bar_height_em, 0.1f) << "above the panel";
  EXPECT_NEAR(bar_em({420, 300}, true), theme::bar_height_em, 0.1f) << "there is no panel";
  EXPECT_NEAR(bar_em({660, 1000}, true), theme::compact_bar_height_em, 0.1f) << "narrow";
  EXPECT_EQ(bar_em({200, 700}, false), 0.0f);
  EXPECT_NEAR(bar_em({420, 160}, true), theme::compact_bar_height_em, 0.1f);
  EXPECT_EQ(bar_em({420, 100}, true), 0.0f);
}

// Below this width, names of methods and rows of numbers are cut off.
TEST(WindowLayout, ThePanelIsNeverNarrowerThanItsTexts) {
  constexpr float em = 15.0f;
  for (float width = theme::panel_width_em * em; width < 2000.0f; width += 7.0f) {
    const WindowLayout layout = WindowLayout::of({width, 800.0f}, em, true);
    EXPECT_GE(layout.panel.size.x + 1.0f, theme::panel_width_em * em) << width;
    EXPECT_GT(area(layout.picture), 0.2f * width * 800.0f) << width;
  }
}

// At 200 % the window has half as many units as pixels: text at twice the size would be cut off.
TEST(FittingTextScale, LeavesThePanelTheRoomThatItsTextsNeed) {
  const float panel = theme::panel_width_em * theme::text_pixels;
  for (float width = panel; width < 2000.0f; width += 7.0f) {
    for (const float asked : {0.75f, 1.0f, 1.5f, 2.0f, 3.0f}) {
      const float scale = fitting_text_scale(asked, width);
      EXPECT_LE(scale, asked);
      EXPECT_LE(scale * panel, width) << width << " at " << asked;
      EXPECT_TRUE(scale == asked || (scale + 0.125f) * panel > width) << width << " at " << asked;
    }
  }
  EXPECT_EQ(fitting_text_scale(2.0f, 1280.0f), 2.0f);
  EXPECT_EQ(fitting_text_scale(2.0f, 100.0f), 1.0f);
}

}  // namespace
}  // namespace asos
