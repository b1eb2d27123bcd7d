#include "renderer/film/layer_colours.h"

#include "renderer/film/split_map.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

namespace asos {
namespace {

Film film_with(LayerSet layers) {
  Film film(2, 1);
  film.layers = blank_planes(layers, 2);
  return film;
}

TEST(LayerColours, ScaleIsTheRangeOfFiniteValues) {
  Film film = film_with({Layer::depth});
  film.layers[0].values = {3.0f, std::numeric_limits<float>::infinity()};
  film.rays = {10.0f, 40.0f};
  EXPECT_EQ(layer_scale(film, Layer::depth).lo.x, 3.0f);
  EXPECT_EQ(layer_scale(film, Layer::depth).hi.x, 3.0f);
  const LayerScale rays = layer_scale(film, Layer::rays);
  EXPECT_FLOAT_EQ(rays.at(25.0f), 0.5f);
  EXPECT_EQ(layer_colour(film, Layer::rays, 1, rays, {}), heat_colour(1.0f));
  EXPECT_EQ(layer_colour(film, Layer::depth, 1, {}, {}), glm::u8vec3(0)) << "the background";
}

TEST(LayerColours, AFewFarPixelsDoNotSquashTheScaleOfDepth) {
  Film film(100, 1);
  film.layers = blank_planes({Layer::depth}, 100);
  for (std::size_t i = 0; i < 100; ++i)
    film.layers[0].values[i] = i < 97 ? 1.0f + static_cast<float>(i) / 100.0f : 1000.0f;
  film.rays.assign(100, 1.0f);
  film.rays[7] = 1000.0f;
  EXPECT_LT(layer_scale(film, Layer::depth).hi.x, 2.0f);
  EXPECT_EQ(layer_scale(film, Layer::rays).hi.x, 1000.0f) << "only lengths have a far tail";
}

TEST(LayerColours, NormalsAndIdsHaveTheirOwn) {
  Film film = film_with({Layer::normal, Layer::object});
  film.layers[0].values = {0.0f, 0.0f, 1.0f, -1.0f, 0.0f, 0.0f};
  film.layers[1].ids[0] = {{7, 0.5f}, {no_id, 0.5f}};
  const LayerScale scale = layer_scale(film, Layer::normal);
  EXPECT_EQ(layer_colour(film, Layer::normal, 0, scale, {}), glm::u8vec3(128, 128, 255));
  EXPECT_EQ(layer_colour(film, Layer::normal, 1, scale, {}), glm::u8vec3(0, 128, 128));
  const glm::vec3 half = 0.5f * glm::vec3(id_colour(7));
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(layer_colour(film, Layer::object, 0, {}, {})[c], half[c], 1.0f);
  EXPECT_NE(id_colour(7), id_colour(8));
}

TEST(LayerColours, WordsHaveUnitsAndNames) {
  Film film = film_with({Layer::position, Layer::depth, Layer::object});
  film.layers[1].values[0] = 3.25f;
  film.layers[0].values = {1.0f, -2.0f, 0.5f, 0.0f, 0.0f, 0.0f};
  film.layers[2].ids[0] = {{1, 0.75f}, {0, 0.125f}, {no_id, 0.125f}};
  EXPECT_EQ(layer_words(film, Layer::depth, 0), "3.25 m");
  EXPECT_EQ(layer_words(film, Layer::position, 0), "1, -2, 0.5 m");
  const auto name = [](std::uint32_t id) { return std::string(id == 1 ? "chair" : ""); };
  EXPECT_EQ(layer_words(film, Layer::object, 0, name),
            "chair 75 %, object 1 12.5 %, background 12.5 %");
  EXPECT_EQ(layer_words(film, Layer::cause, 0), title_of(SplitCause::none));
  EXPECT_EQ(layer_words(film, Layer::alpha, 0), "") << "the film has none";
}

}  // namespace
}  // namespace asos
