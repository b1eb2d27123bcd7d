#include "renderer/film/film.h"
#include "renderer/film/image_io.h"
#include "renderer/film/tone.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>

// Display of pixels that are partly unlit.

namespace asos {
namespace {

/// The linear value of a texture's byte.
float linear(int byte) {
  const double encoded = byte / 255.0;
  return static_cast<float>(encoded <= 0.04045 ? encoded / 12.92
                                               : std::pow((encoded + 0.055) / 1.055, 2.4));
}

TEST(UnlitPixels, ShowTheirBytesByEveryCurveAndExposure) {
  for (const NamedTone& tone : tone_names) {
    for (const float ev : {-3.0f, 0.0f, 2.0f}) {
      Film film(256, 1);
      for (int byte = 0; byte < 256; ++byte)
        film.radiance[static_cast<std::size_t>(byte)] =
            glm::vec3(linear(byte), linear(255 - byte), linear(0));
      for (const glm::vec3& colour : film.radiance) film.unlit.emplace_back(colour, 1.0f);
      for (int byte = 0; byte < 256; ++byte)
        ASSERT_EQ(display_bytes(film, static_cast<std::size_t>(byte), {ev, tone.value}),
                  glm::u8vec3(byte, 255 - byte, 0))
            << tone.name << " " << ev;
    }
  }
}

// A quarter of the pixel is unlit: three quarters of the displayed lit colour plus that quarter.
TEST(UnlitPixels, MixWithLitSurfacesAsTheseAreShown) {
  const glm::vec3 lit(3.0f, 0.4f, 0.1f), unlit(1.0f, 0.5f, 0.0f);
  const glm::vec4 part(0.25f * unlit, 0.25f);
  for (const NamedTone& tone : tone_names) {
    const DisplayTransform display(0.5f, tone.value);
    const glm::vec3 expected = 0.75f * tone_mapped(lit, display) + 0.25f * unlit;
    const glm::vec3 shown = tone_mapped(0.75f * lit + 0.25f * unlit, part, display);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown[c], expected[c], 1e-5f) << tone.name;
  }
}

TEST(UnlitPixels, LeaveLitPixelsTheirBits) {
  const glm::vec3 lit(3.0f, 0.4f, 0.1f);
  for (const NamedTone& tone : tone_names)
    EXPECT_EQ(tone_mapped(lit, glm::vec4(0.0f), {0.5f, tone.value}),
              tone_mapped(lit, {0.5f, tone.value}));
}

TEST(UnlitPixels, TravelWithTiles) {
  Film film(4, 1);
  FinishedTile tile;
  tile.rect = {1, 0, 2, 1};
  tile.radiance.assign(2, glm::vec3(1.0f));
  tile.split_level.assign(2, 0);
  tile.cause.assign(2, SplitCause::none);
  film.put(tile);
  EXPECT_TRUE(film.unlit.empty()) << "no surface is unlit";
  tile.unlit.assign(2, glm::vec4(0.5f));
  film.put(tile);
  const glm::vec4 none(0.0f), half(0.5f);
  EXPECT_EQ(film.unlit, (std::vector<glm::vec4>{none, half, half, none}));
  FinishedTile part = tile;
  part.rect = {2, 0, 2, 1};
  part.unlit.assign(2, none);
  copy_pixels(tile, part);
  EXPECT_EQ(part.unlit, (std::vector<glm::vec4>{half, none}));
  tile.unlit.clear();
  film.put(tile);
  EXPECT_EQ(film.unlit, std::vector<glm::vec4>(4, none));
}

// Half of the second pixel is transparent, half of the rest unlit.
TEST(UnlitPixels, PngShowsThemAndExrHoldsTheSum) {
  const test::TemporaryFolder folder;
  Film film(2, 1);
  film.radiance = {glm::vec3(linear(200), 1.0f, 0.0f), glm::vec3(0.25f + 0.5f, 0.25f, 0.0f)};
  film.unlit = {glm::vec4(film.radiance[0], 1.0f), glm::vec4(0.25f, 0.25f, 0.0f, 0.25f)};
  const DisplayTransform display(0.0f, ToneCurve::neutral);
  ASSERT_TRUE(write_png(folder.file("a.png"), film, display, {}));
  const RgbImage png = read_png(folder.file("a.png")).value();
  EXPECT_EQ(png.rgb[0], 200);
  EXPECT_EQ(png.rgb[1], 255);
  EXPECT_EQ(png.rgb[2], 0);
  ASSERT_TRUE(write_exr(folder.file("a.exr"), film, {}));
  EXPECT_EQ(read_exr(folder.file("a.exr")).value().film.radiance, film.radiance);
  film.coverage = {1.0f, 0.5f};
  ASSERT_TRUE(write_png(folder.file("b.png"), film, display, {}));
  const glm::vec3 lit = tone_mapped(glm::vec3(2.0f, 0.0f, 0.0f), display);
  const glm::u8vec3 expected = display_bytes(0.5f * lit + glm::vec3(0.5f, 0.5f, 0.0f), 0.0f);
  const RgbImage clear = read_png(folder.file("b.png")).value();
  EXPECT_EQ(clear.rgb[3], expected.x);
  EXPECT_EQ(clear.rgb[4], expected.y);
  EXPECT_EQ(clear.rgb[5], expected.z);
}

}  // namespace
}  // namespace asos
