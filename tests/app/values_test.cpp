#include "renderer/settings/value_text.h"

#include <gtest/gtest.h>

#include <clocale>

namespace asos {
namespace {

TEST(Values, NumbersAreReadWhole) {
  EXPECT_EQ(parse_number("0.25", 0, 1).value(), 0.25);
  EXPECT_EQ(parse_number("+1e-3", 0, 1).value(), 1e-3);
  EXPECT_EQ(parse_number("-2.5", -10, 10).value(), -2.5);
  EXPECT_EQ(parse_number("1", 0, 1).value(), 1.0);
}

TEST(Values, NonsenseNumbersAreRefused) {
  for (const char* text : {"", " ", "nan", "-nan", "inf", "-inf", "1e999", "0,5", "0.5x", "x",
                           "--1", "+-1", "+", "0x1p-2", "1 "})
    EXPECT_FALSE(parse_number(text, -10, 10)) << text;
}

TEST(Values, RangesIncludeTheirEndsUnlessOpen) {
  EXPECT_TRUE(parse_number("180", 0, 180));
  EXPECT_FALSE(parse_number("180", 0, 180, true));
  EXPECT_FALSE(parse_number("0", 0, 180, true));
  const auto error = parse_number("181", 0, 180, true);
  ASSERT_FALSE(error);
  EXPECT_EQ(error.error().message(), "\"181\": has to be strictly between 0 and 180");
}

TEST(Values, NumbersDoNotDependOnTheLocale) {
  // A locale with a decimal comma, if one is installed, must not change the results.
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) std::setlocale(LC_ALL, name);
  EXPECT_EQ(parse_number("0.5", 0, 1).value(), 0.5);
  EXPECT_FALSE(parse_number("0,5", 0, 1));
  std::setlocale(LC_ALL, "C");
}

TEST(Values, WholeNumbers) {
  EXPECT_EQ(parse_whole("8", 0, 8).value(), 8);
  for (const char* text : {"9", "-1", "1.0", "", "99999999999999999999", "3k"})
    EXPECT_FALSE(parse_whole(text, 0, 8)) << text;
}

TEST(Values, Pixels) {
  EXPECT_EQ(parse_pixel("160,90").value(), glm::ivec2(160, 90));
  EXPECT_EQ(parse_pixel("0,0").value(), glm::ivec2(0, 0));
  for (const char* text : {"", "1", "1,2,3", "1x2", "1.5,2", "-1,0", "0,-1", "1,", "99999999999,1"})
    EXPECT_FALSE(parse_pixel(text)) << text;
}

TEST(Values, Sizes) {
  const auto size = parse_size("1280x720", 32768);
  ASSERT_TRUE(size);
  EXPECT_EQ(size->width, 1280);
  EXPECT_EQ(size->height, 720);
  for (const char* text : {"", "0x0", "0x5", "5x0", "-1x5", "1000000000x1000000000", "32769x1",
                           "12", "12x", "x12", "12x12x12", "12X12", "1e3x5", "99999999999x2"})
    EXPECT_FALSE(parse_size(text, 32768)) << text;
}

TEST(Values, Rectangles) {
  EXPECT_EQ(parse_rect("1,2,3,4", 100).value(), (PixelRect{1, 2, 3, 4}));
  for (const char* text : {"1,2,3", "1,2,3,4,5", "-1,0,5,5", "0,0,0,5", "0,0,5,0", "0,0,5,101",
                           "2147483647,0,2147483647,1", "1 ,2,3,4", ",,,"})
    EXPECT_FALSE(parse_rect(text, 100)) << text;
}

TEST(Values, LookAt) {
  const auto look = parse_look_at("4,2.5,-4,0,1e1,0");
  ASSERT_TRUE(look);
  EXPECT_EQ(look->eye, glm::dvec3(4, 2.5, -4));
  EXPECT_EQ(look->target, glm::dvec3(0, 10, 0));
  for (const char* text : {"1,2,3", "1,2,3,1,2,3", "nan,0,0,1,1,1", "inf,0,0,1,1,1",
                           "1e300,0,0,1,1,1", "1,2,3,4,5,6,7"})
    EXPECT_FALSE(parse_look_at(text)) << text;
}

TEST(Values, DefocusingRatios) {
  const auto dfr = parse_dfr("0.05,1,32");
  ASSERT_TRUE(dfr);
  for (const DfrCurve& curve : dfr->rgb) EXPECT_EQ(curve, (DfrCurve{0.05, 1.0, 32.0}));
  EXPECT_TRUE(parse_dfr("1,0,0"));
  for (const char* text : {"", "1,1", "1,1,1,1", "-0.1,1,1", "0,1.1,1", "0,1,-1", "nan,1,1",
                           "0,1,inf", "0,1,2e6", "0;1;2"})
    EXPECT_FALSE(parse_dfr(text)) << text;
}

TEST(Values, Skies) {
  const auto neutral = parse_sky("neutral");
  ASSERT_TRUE(neutral);
  EXPECT_FALSE(neutral->colours);
  EXPECT_TRUE(neutral->file.empty());
  EXPECT_EQ(parse_sky("a sky:1.hdr").value().file, "a sky:1.hdr");
  EXPECT_EQ(parse_sky("../s.exr").value().file, "../s.exr");
  const auto one = parse_sky("0.25,1,4");
  ASSERT_TRUE(one && one->colours);
  EXPECT_EQ(one->colours->zenith, glm::vec3(0.25f, 1, 4));
  EXPECT_EQ(one->colours->horizon, glm::vec3(0.25f, 1, 4));
  const auto two = parse_sky("0,0,1:1,1,0.5");
  ASSERT_TRUE(two && two->colours);
  EXPECT_EQ(two->colours->zenith, glm::vec3(0, 0, 1));
  EXPECT_EQ(two->colours->horizon, glm::vec3(1, 1, 0.5f));
  for (const char* text : {"", "blue", "1,1", "1,1,1,1", "1,1,1:", ":1,1,1", "1,1,1:1,1", "-1,0,0",
                           "nan,0,0", "inf,0,0", "1,1,1e7", "1,1,1:1,1,1:1,1,1", "sky.png"})
    EXPECT_FALSE(parse_sky(text)) << text;
}

TEST(Values, BackgroundsAreNamesOrColours) {
  EXPECT_EQ(parse_background("environment").value(), Background{});
  EXPECT_EQ(parse_background("blurred").value().kind, BackgroundKind::blurred);
  EXPECT_EQ(parse_background("transparent").value().kind, BackgroundKind::transparent);
  const Background gradient = parse_background("0,0.5,1:2,0,0").value();
  EXPECT_EQ(gradient.kind, BackgroundKind::colours);
  EXPECT_EQ(gradient.top, glm::vec3(0.0f, 0.5f, 1.0f));
  EXPECT_EQ(gradient.bottom, glm::vec3(2.0f, 0.0f, 0.0f));
  EXPECT_EQ(parse_background("1,1,1").value().bottom, glm::vec3(1.0f));
  for (const char* bad :
       {"", "colours", "1,2", "1,2,3:", "-1,0,0", "nan,0,0", "1,1,2e6", "1,1,1,1"})
    EXPECT_FALSE(parse_background(bad)) << bad;
}

}  // namespace
}  // namespace asos
