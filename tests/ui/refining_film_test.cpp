#include "ui/refining_film.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asos {
using namespace ui;
namespace {

FinishedTile tile(PixelRect rect, glm::vec3 colour, bool coarse) {
  const auto pixels = static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height);
  FinishedTile tile{.rect = rect};
  tile.radiance.assign(pixels, colour);
  tile.split_level.assign(pixels, 0);
  tile.cause.assign(pixels, {});
  tile.coarse = coarse;
  return tile;
}

RenderSettings of_size(int width, int height, double eps = 1.0 / 256.0) {
  return {.width = width, .height = height, .asos = {.max_level = 4, .eps = eps}};
}

/// The final tile of two pixels: one that is unevenly shaded, with an error of 8 times the default
/// EPS, and one that is not.
FinishedTile shaded_and_clear() {
  FinishedTile both = tile({0, 0, 2, 1}, glm::vec3(0.5f), false);
  both.split_level = {2, 0};
  both.cause = {SplitCause::shading, SplitCause::none};
  both.outlook.resize(2);
  both.outlook[0].error = 1.0f / 32.0f;
  return both;
}

TEST(RefiningFilm, KeepsThePictureUntilTilesOfTheNextRenderArrive) {
  RefiningFilm film;
  film.begin(of_size(2, 1), false);
  film.put(tile({0, 0, 1, 1}, {1, 0, 0}, false));
  film.put(tile({1, 0, 1, 1}, {0, 1, 0}, false));
  ASSERT_EQ(film.take_changed().size(), 3u) << "all of it at first, and two tiles";
  EXPECT_TRUE(film.covered());

  film.begin(of_size(2, 1), false);
  EXPECT_FALSE(film.covered());
  EXPECT_TRUE(film.take_changed().empty());
  EXPECT_EQ(film.film().radiance[0], glm::vec3(1, 0, 0));

  film.begin(of_size(4, 2), false);
  const std::vector<PixelRect> changed = film.take_changed();
  ASSERT_EQ(changed.size(), 1u);
  EXPECT_EQ(changed[0].width, 4);
  EXPECT_EQ(changed[0].height, 2);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 4; ++x) {
      EXPECT_EQ(film.film().radiance[film.film().index(x, y)],
                x < 2 ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0))
          << x << " " << y;
    }
  }
}

// A drag of EPS once put squares of 8 pixels over a picture that had a sample in each pixel.
TEST(RefiningFilm, SquaresOfOneColourLeaveACoveredViewAlone) {
  const PixelRect all{0, 0, 2, 1};
  const auto shown = [](const RefiningFilm& film) { return film.film().radiance[0].x; };
  RefiningFilm film;
  film.begin(of_size(2, 1), false);
  film.put(tile(all, glm::vec3(0.25f), true));
  film.put(tile(all, glm::vec3(0.5f), true));
  EXPECT_EQ(shown(film), 0.5f) << "the first picture gets finer squares";
  film.begin(of_size(2, 1, 0.5), true);
  film.put(tile(all, glm::vec3(0.25f), true));
  EXPECT_EQ(shown(film), 0.5f);
  EXPECT_TRUE(film.covered());
  FinishedTile samples = tile(all, glm::vec3(0.75f), true);
  samples.seconds.assign(2, 0.001f);
  film.put(samples);
  EXPECT_EQ(shown(film), 0.75f);
  film.begin(of_size(2, 1, 0.25), true);
  film.begin(of_size(2, 1, 0.125), true);
  film.put(tile(all, glm::vec3(0.25f), true));
  EXPECT_EQ(shown(film), 0.75f);
  film.begin(of_size(2, 1), false);
  film.put(tile(all, glm::vec3(0.25f), true));
  EXPECT_EQ(shown(film), 0.25f) << "of another view";
}

TEST(RefiningFilm, EstimatesTheErrorThatIsLeftFromWhatFinalPixelsCorrected) {
  RefiningFilm film;
  film.begin(of_size(4, 1), false);
  film.put(tile({0, 0, 4, 1}, glm::vec3(0.5f), true));
  EXPECT_TRUE(film.covered());
  EXPECT_FALSE(film.estimated_rmse().has_value());
  film.put(tile({0, 0, 1, 1}, glm::vec3(0.75f), false));
  // Three of four pixels are left, each assumed to have the first one's error: a quarter.
  EXPECT_NEAR(film.estimated_rmse().value_or(-1.0), std::sqrt(0.75) * 0.25, 1e-12);
  film.put(tile({1, 0, 3, 1}, glm::vec3(9.0f), false));
  EXPECT_EQ(film.estimated_rmse(), 0.0) << "it is finished";
}

TEST(RefiningFilm, PredictsTheMapOfAnotherEps) {
  using Levels = std::vector<std::uint8_t>;
  RefiningFilm film;
  film.begin(of_size(2, 1), false);
  film.put(shaded_and_clear());
  EXPECT_EQ(film.film().split_level, (Levels{2, 0}));
  const std::uint64_t revision = film.map_revision();
  film.predict(of_size(2, 1, 1.0 / 16.0));
  EXPECT_EQ(film.film().split_level, (Levels{0, 0}));
  EXPECT_EQ(film.film().cause[0], SplitCause::none);
  EXPECT_GT(film.map_revision(), revision);
  film.predict(of_size(2, 1, 1.0 / 1024.0));
  EXPECT_EQ(film.film().split_level, (Levels{2, 0})) << "samples are no level";
  const int fine = film.film().samples[0];
  EXPECT_GT(fine, 1);
  EXPECT_EQ(film.film().samples[1], 0);
  film.predict(of_size(2, 1, 1.0 / 400.0));
  EXPECT_LT(film.film().samples[0], fine) << "a larger EPS takes fewer";
  EXPECT_EQ(film.film().cause[0], SplitCause::shading);
  film.predict(of_size(2, 1));
  EXPECT_EQ(film.film().split_level, (Levels{2, 0})) << "as it was rendered";
}

// The scene Fox: 3.7 % of the pixels were split at MAX 4, and 3.6 % predicted for MAX 5.
TEST(RefiningFilm, PredictsNoLessForFinerSettings) {
  RefiningFilm film;
  film.begin(of_size(2, 1), false);
  FinishedTile lucky = shaded_and_clear();
  lucky.outlook[0].error = 0.0f;  // its samples happened to agree
  film.put(lucky);
  RenderSettings deeper = of_size(2, 1);
  deeper.asos.max_level = 5;
  film.predict(deeper);
  EXPECT_EQ(film.film().split_level[0], 2);
  EXPECT_EQ(film.film().cause[0], SplitCause::shading);
  film.predict(of_size(2, 1, 1.0 / 300.0));
  EXPECT_EQ(film.film().split_level[0], 2);
  film.predict(of_size(2, 1, 1.0 / 200.0));
  EXPECT_EQ(film.film().split_level[0], 0) << "a coarser EPS may need no split";
}

TEST(RefiningFilm, NeverShowsLessOfTheMapThanIsKnown) {
  RefiningFilm film;
  film.begin(of_size(2, 1), false);
  EXPECT_EQ(film.film().unfinished, std::vector<std::uint8_t>(2, 1));
  film.put(shaded_and_clear());
  EXPECT_EQ(film.film().unfinished, std::vector<std::uint8_t>(2, 0));
  film.begin(of_size(2, 1, 1.0 / 1024.0), true);
  EXPECT_EQ(film.film().unfinished, std::vector<std::uint8_t>(2, 1));
  film.put(tile({0, 0, 2, 1}, glm::vec3(0.5f), true));
  EXPECT_EQ(film.film().split_level[0], 2) << "coarse tiles have no levels";
  EXPECT_GT(film.film().samples[0], 1);
  EXPECT_EQ(film.split_share(), 0.5);
  FinishedTile last = tile({0, 0, 1, 1}, glm::vec3(0.5f), false);
  last.split_level = {4};
  last.cause = {SplitCause::shading};
  last.outlook.resize(1);
  film.put(last);
  EXPECT_EQ(film.film().split_level[0], 4) << "the true level";
  EXPECT_EQ(film.film().unfinished, (std::vector<std::uint8_t>{0, 1}));
  // Data from another view do not count.
  film.begin(of_size(2, 1, 1.0 / 1024.0), false);
  film.put(tile({0, 0, 2, 1}, glm::vec3(0.5f), true));
  EXPECT_EQ(film.split_share(), 0.0);
}

// Dragging EPS or MAX used to show blocks of 8 x 8 pixels in place of a finished picture.
TEST(RefiningFilm, KeepsFinalPixelsOfTheViewUntilFinerOnesArrive) {
  const glm::vec3 old(0.25f), coarse(0.5f), last(0.75f);
  RefiningFilm film;
  film.begin(of_size(2, 1), false);
  film.put(tile({0, 0, 1, 1}, old, false));
  film.begin(of_size(2, 1, 1.0 / 8.0), true);
  (void)film.take_changed();
  for (const int samples : {0, 1, 16}) film.put(tile({0, 0, 2, 1}, coarse, true), samples);
  EXPECT_EQ(film.film().radiance, (std::vector<glm::vec3>{old, coarse})) << "MAX 4: 256 cells";
  EXPECT_TRUE(film.covered());
  film.put(tile({0, 0, 2, 1}, last, false));
  EXPECT_EQ(film.film().radiance, (std::vector<glm::vec3>{last, last}));
  // Another view does not keep them.
  film.begin(of_size(2, 1, 1.0 / 8.0), false);
  film.put(tile({0, 0, 2, 1}, coarse, true));
  EXPECT_EQ(film.film().radiance, (std::vector<glm::vec3>{coarse, coarse}));
}

// Pixels of MAX 0 have one cell, so rounds of samples are finer. Blocks and quarters are not.
TEST(RefiningFilm, ShowsSamplesThatAreFinerThanTheLastPicture) {
  const glm::vec3 old(0.25f), coarse(0.5f);
  RenderSettings whole = of_size(1, 1);
  whole.asos.max_level = 0;
  RefiningFilm film;
  film.begin(whole, false);
  film.put(tile({0, 0, 1, 1}, old, false));
  film.begin(of_size(1, 1), true);
  for (const int samples : {0, 1}) film.put(tile({0, 0, 1, 1}, coarse, true), samples);
  EXPECT_EQ(film.film().radiance[0], old);
  film.put(tile({0, 0, 1, 1}, coarse, true), 2);
  EXPECT_EQ(film.film().radiance[0], coarse);
  // The next step of the drag starts with blocks again.
  film.begin(of_size(1, 1, 1.0 / 300.0), true);
  film.put(tile({0, 0, 1, 1}, old, true), 0);
  EXPECT_EQ(film.film().radiance[0], coarse);
}

// Each step of a long drag starts another render.
TEST(RefiningFilm, ALongDragForgetsNothing) {
  RefiningFilm film;
  film.begin(of_size(2, 1), false);
  film.put(shaded_and_clear());
  for (int step = 1; step <= 500; ++step) {
    film.begin(of_size(2, 1, 1.0 / (256.0 + step)), true);
    film.put(tile({0, 0, 2, 1}, glm::vec3(0.5f), true));
  }
  EXPECT_EQ(film.split_share(), 0.5);
  film.begin(of_size(2, 1), true);
  EXPECT_EQ(film.film().split_level[0], 2) << "as it was rendered";
}

}  // namespace
}  // namespace asos
