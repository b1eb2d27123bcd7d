#include "ui/theme.h"

#include "renderer/film/split_cause.h"
#include "tests/ui/panels_fixture.h"
#include "ui/panels/study_marks.h"
#include "ui/panels/study_plot.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace asos::test::theme_test {
using namespace ui;
namespace {

glm::dvec3 linear(std::uint32_t rgb) {
  glm::dvec3 c;
  for (int k = 0; k < 3; ++k) {
    const double v = ((rgb >> (16 - 8 * k)) & 255u) / 255.0;
    c[k] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  }
  return c;
}

/// WCAG 2.1: the contrast ratio of two colours.
double contrast(std::uint32_t a, std::uint32_t b) {
  const auto luminance = [](std::uint32_t rgb) {
    return glm::dot(linear(rgb), glm::dvec3(0.2126, 0.7152, 0.0722));
  };
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

// WCAG 2.1, success criteria 1.4.3 and 1.4.6.
TEST(Theme, TextIsReadOnEverythingItStandsOn) {
  using theme::Colour;
  for (const auto look : {theme::Look::dark, theme::Look::light}) {
    const auto on = [&](Colour text, Colour ground) {
      return contrast(theme::rgb(look, text), theme::rgb(look, ground));
    };
    for (const Colour ground : {Colour::panel, Colour::popup, Colour::field, Colour::field_hovered})
      EXPECT_GE(on(Colour::text, ground), 7.0) << static_cast<int>(ground);
    EXPECT_GE(on(Colour::text, Colour::accent), 4.5) << "chosen options, and bars of sliders";
    for (const Colour ground : {Colour::panel, Colour::popup})
      for (const Colour text : {Colour::dim_text, Colour::alarm, Colour::warning})
        EXPECT_GE(on(text, ground), 4.5) << static_cast<int>(text);
    EXPECT_GE(on(Colour::accent_bright, Colour::panel), 3.0) << "ticks, and the progress bar";
  }
}

/// A colour as seen without one kind of cones: Vienot, Brettel and Mollon (1999) for red and green,
/// linear sRGB.
glm::dvec3 without_red(glm::dvec3 c) {
  const double y = 0.11238 * c.x + 0.88762 * c.y;
  return {y, y, 0.00401 * c.x - 0.00401 * c.y + c.z};
}
glm::dvec3 without_green(glm::dvec3 c) {
  const double y = 0.29275 * c.x + 0.70725 * c.y;
  return {y, y, -0.02234 * c.x + 0.02234 * c.y + c.z};
}

/// Distance in CIE 1976 Lab.
double difference(glm::dvec3 a, glm::dvec3 b) {
  const auto lab = [](glm::dvec3 c) {
    const glm::dvec3 xyz(glm::dot(c, glm::dvec3(0.4124, 0.3576, 0.1805)) / 0.9505,
                         glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)),
                         glm::dot(c, glm::dvec3(0.0193, 0.1192, 0.9505)) / 1.089);
    glm::dvec3 f;
    for (int k = 0; k < 3; ++k)
      f[k] = xyz[k] > 0.008856 ? std::cbrt(xyz[k]) : 7.787 * xyz[k] + 16.0 / 116.0;
    return glm::dvec3(116.0 * f.y - 16.0, 500.0 * (f.x - f.y), 200.0 * (f.y - f.z));
  };
  return glm::distance(lab(glm::max(a, 0.0)), lab(glm::max(b, 0.0)));
}

TEST(Theme, PlotsHaveColoursThatTheColourBlindTellApart) {
  constexpr std::array methods{"asos",      "asos-published", "uniform", "stochastic",
                               "sobol",     "sobol-adaptive", "whitted", "mitchell",
                               "ray-bound", "average"};
  for (const char* method : methods) {
    const std::uint32_t rgb = method_colour(method);
    EXPECT_GE(contrast(rgb, theme::plot_ground), 3.0) << method;
    for (const char* other : methods) {
      if (std::string(method) >= other) continue;
      const glm::dvec3 a = linear(rgb), b = linear(method_colour(other));
      EXPECT_GE(difference(a, b), 12.0) << method << " and " << other;
      EXPECT_GE(difference(without_red(a), without_red(b)), 6.0) << method << " and " << other;
      EXPECT_GE(difference(without_green(a), without_green(b)), 6.0) << method << " and " << other;
    }
  }
}

class ThemeTest : public PanelsTest {
 protected:
  ThemeTest() : PanelsTest(1, {660, 600}) {}
  [[nodiscard]] float row_height() {
    const Controls::Placed at = rig.control("Exposure");
    return at.hi.y - at.lo.y;
  }
};

TEST_F(ThemeTest, DigitsAreAllOfOneWidth) {
  for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
    for (char digit = '0'; digit <= '9'; ++digit)
      EXPECT_EQ(font->GetCharAdvance(static_cast<ImWchar>(digit)), font->GetCharAdvance('0'))
          << digit;
}

TEST_F(ThemeTest, ThereAreTwoSizesOfText) {
  ASSERT_EQ(ImGui::GetIO().Fonts->Fonts.Size, 2);
  EXPECT_FLOAT_EQ(ImGui::GetIO().Fonts->Fonts[0]->FontSize, theme::text_pixels);
  EXPECT_FLOAT_EQ(ImGui::GetIO().Fonts->Fonts[1]->FontSize, theme::title_pixels);
}

// At scale 1 widgets are 24 units high, and the next one begins 28 units lower; all are at
// multiples of 4 from the first.
TEST_F(ThemeTest, WidgetsStandInARhythmOfFour) {
  EXPECT_FLOAT_EQ(row_height(), theme::row_pixels);
  const float first = rig.control("EPS").lo.y;
  for (const char* name :
       {"MAX", "Cell shading/Exact area", "Jitter unresolved cells", "Pixel filter"}) {
    const float down = rig.control(name).lo.y - rig.control("EPS").lo.y;
    EXPECT_FLOAT_EQ(std::remainder(down, 4.0f), 0.0f) << name << " " << down << " below " << first;
  }
  const WindowLayout& layout = rig.content().layout();
  EXPECT_FLOAT_EQ(std::remainder(layout.panel.size.x, 4.0f), 0.0f);
  EXPECT_FLOAT_EQ(std::remainder(layout.status.size.y, 4.0f), 0.0f);
}

TEST_F(ThemeTest, TextIsAsLargeAsOneLikes) {
  const float plain = row_height();
  rig.click("Text size/150 %");
  for (int i = 0; i < 3; ++i) rig.frame();
  EXPECT_NEAR(row_height() / plain, 1.5f, 0.03f);
  EXPECT_EQ(rig.content().stored_settings().look.scale, 1.5f);
  rig.content().apply(StoredSettings{});
  for (int i = 0; i < 3; ++i) rig.frame();
  EXPECT_FLOAT_EQ(row_height(), plain);
}

TEST_F(ThemeTest, LightAndDarkAreChosenAndRemembered) {
  rig.set_blind(false);
  const auto corner = [&] {
    rig.frame();
    return rig.pixels()[static_cast<std::size_t>(rig.size().x) - 2];
  };
  const auto bytes = [](theme::Look look) {
    const std::uint32_t rgb = theme::rgb(look, theme::panel);
    return glm::u8vec3((rgb >> 16) & 255u, (rgb >> 8) & 255u, rgb & 255u);
  };
  EXPECT_EQ(corner(), bytes(theme::Look::dark));
  const auto picture = rig.render().restarts();
  rig.click("Theme/Light");
  for (int i = 0; i < 2; ++i) rig.frame();
  EXPECT_EQ(corner(), bytes(theme::Look::light));
  EXPECT_EQ(rig.content().stored_settings().look.theme, theme::Look::light);
  EXPECT_EQ(rig.render().restarts(), picture);
  rig.click("Theme/Dark");
  for (int i = 0; i < 2; ++i) rig.frame();
  EXPECT_EQ(corner(), bytes(theme::Look::dark));
}

// Popups of the light look are light: texts, and the drawing above them.
TEST_F(ThemeTest, HelpIsDrawnInTheLookOfTheWindow) {
  const auto dark_share = [&] {
    const auto before = rig.pixels();
    rig.click("Help/Antialiasing");
    for (int i = 0; i < 3; ++i) rig.frame();
    const auto after = rig.pixels();
    double changed = 0.0, dark = 0.0;
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (after[i] == before[i]) continue;
      ++changed;
      dark += after[i].y < 96;
    }
    rig.key(Key::escape);
    EXPECT_GT(changed, 5000.0);
    return dark / changed;
  };
  rig.move_to({10.0f, 10.0f});
  EXPECT_GT(dark_share(), 0.8);
  rig.state().look.theme = theme::Look::light;
  for (int i = 0; i < 3; ++i) rig.frame();
  EXPECT_LT(dark_share(), 0.2);
}

}  // namespace
}  // namespace asos::test::theme_test
