#include "ui/refining_film.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asos {
namespace {

FinishedTile tile(PixelRect rect, glm::vec3 colour, bool coarse) {
  const auto pixels = static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height);
  FinishedTile tile;
  tile.rect = rect;
  tile.radiance.assign(pixels, colour);
  tile.split_level.assign(pixels, 0);
  tile.cause.assign(pixels, {});
  tile.coarse = coarse;
  return tile;
}

TEST(RefiningFilm, KeepsThePictureUntilTilesOfTheNextRenderArrive) {
  RefiningFilm film;
  film.begin(2, 1);
  film.put(tile({0, 0, 1, 1}, {1, 0, 0}, false));
  film.put(tile({1, 0, 1, 1}, {0, 1, 0}, false));
  ASSERT_EQ(film.take_changed().size(), 3u) << "all of it at first, and two tiles";
  EXPECT_TRUE(film.covered());

  film.begin(2, 1);
  EXPECT_FALSE(film.covered());
  EXPECT_TRUE(film.take_changed().empty());
  EXPECT_EQ(film.film().radiance[0], glm::vec3(1, 0, 0));

  film.begin(4, 2);
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

TEST(RefiningFilm, EstimatesTheErrorThatIsLeftFromWhatFinalPixelsCorrected) {
  RefiningFilm film;
  film.begin(4, 1);
  film.put(tile({0, 0, 4, 1}, glm::vec3(0.5f), true));
  EXPECT_TRUE(film.covered());
  EXPECT_FALSE(film.estimated_rmse().has_value());
  film.put(tile({0, 0, 1, 1}, glm::vec3(0.75f), false));
  // Three pixels of four are left, each as wrong as the first: by a quarter.
  EXPECT_NEAR(film.estimated_rmse().value_or(-1.0), std::sqrt(0.75) * 0.25, 1e-12);
  film.put(tile({1, 0, 3, 1}, glm::vec3(9.0f), false));
  EXPECT_EQ(film.estimated_rmse(), 0.0) << "it is finished";
}

}  // namespace
}  // namespace asos
