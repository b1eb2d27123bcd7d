#include "ui/resampled.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asos {
using namespace ui;
namespace {

/// A linear ramp: red grows to the right and green downwards, by 1 / height per pixel.
Film ramp(int width, int height) {
  Film film(width, height);
  const glm::vec2 size(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      film.radiance[film.index(x, y)] =
          glm::vec3((glm::vec2(x, y) + 0.5f - 0.5f * size) / size.y, 1.0f);
  return film;
}

TEST(Resampled, IsTheSameAtItsOwnSize) {
  const Film film = ramp(7, 5);
  EXPECT_EQ(resampled(film, {7, 5}).radiance, film.radiance);
}

// The mean of a linear function over a square is its value at the centre.
TEST(Resampled, KeepsAPlaneWhenItShrinks) {
  for (const glm::ivec2 size : {glm::ivec2(30, 20), glm::ivec2(8, 8), glm::ivec2(20, 10)}) {
    const Film film = ramp(80, 40);
    const Film small = resampled(film, size);
    const Film expected = ramp(size.x, size.y);
    ASSERT_EQ(small.width, size.x);
    for (std::size_t i = 0; i < small.radiance.size(); ++i)
      for (int k = 0; k < 3; ++k)
        ASSERT_NEAR(small.radiance[i][k], expected.radiance[i][k], 1e-5f) << i << " " << k;
  }
}

TEST(Resampled, KeepsTheMeanWhenItGrows) {
  const Film film = ramp(6, 4);
  const Film large = resampled(film, {18, 12});
  glm::dvec3 sum(0.0);
  for (const glm::vec3 c : large.radiance) sum += glm::dvec3(c);
  sum /= 18.0 * 12.0;
  EXPECT_NEAR(sum.x, 0.0, 1e-6);
  EXPECT_NEAR(sum.z, 1.0, 1e-6);
  EXPECT_EQ(large.radiance[large.index(0, 0)], film.radiance[0]);
  EXPECT_EQ(large.radiance[large.index(2, 2)], film.radiance[0]);
  EXPECT_EQ(large.radiance[large.index(3, 2)], film.radiance[1]);
}

// The vertical field of view stays: a wider picture has equal black areas at both sides.
TEST(Resampled, IsBlackBeyondTheSides) {
  const Film wide = resampled(ramp(8, 8), {24, 12});
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 24; ++x)
      EXPECT_EQ(wide.radiance[wide.index(x, y)].z, x >= 6 && x < 18 ? 1.0f : 0.0f) << x;
  EXPECT_EQ(resampled_area(ramp(8, 8), {24, 12}), (PixelRect{6, 0, 12, 12}));
  EXPECT_EQ(resampled_area(ramp(16, 8), {6, 12}), (PixelRect{0, 0, 6, 12}));
}

TEST(Resampled, AveragesTheUnlitPart) {
  Film film = ramp(4, 2);
  EXPECT_TRUE(resampled(film, {2, 1}).unlit.empty());
  film.unlit.assign(8, glm::vec4(0.0f));
  film.unlit[film.index(0, 1)] = {0.4f, 0.2f, 0.0f, 1.0f};
  const Film small = resampled(film, {2, 1});
  EXPECT_NEAR(small.unlit.at(0).x, 0.1f, 1e-6f);
  EXPECT_NEAR(small.unlit.at(0).w, 0.25f, 1e-6f);
  EXPECT_EQ(small.unlit.at(1), glm::vec4(0.0f));
}

TEST(Resampled, EmptyPicturesStayEmpty) {
  EXPECT_TRUE(resampled(Film{}, {0, 0}).radiance.empty());
  const Film black = resampled(Film{}, {3, 2});
  EXPECT_EQ(black.radiance, std::vector<glm::vec3>(6, glm::vec3(0.0f)));
}

}  // namespace
}  // namespace asos
