#include "renderer/film/film.h"
#include "renderer/film/layer_mean.h"
#include "renderer/film/layer_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace asos {
namespace {

TEST(Layers, AreNamedOnceWithUnitAndChannels) {
  std::set<std::string> names;
  for (const LayerRow& row : layer_table()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_NE(row.unit[0], '\0') << row.name;
    EXPECT_EQ(row.channel_count() == 0, row.holds_ids()) << row.name;
  }
}

TEST(Layers, ListIsRead) {
  EXPECT_EQ(*parse_layers("depth,normal"), (LayerSet{Layer::depth, Layer::normal}));
  EXPECT_EQ(*parse_layers("all"), LayerSet::all());
  EXPECT_EQ(*parse_layers(text_of(LayerSet::all())), LayerSet::all());
  EXPECT_EQ(*parse_layers("all,depth"), LayerSet::all());
  EXPECT_EQ(*parse_layers("depth,all"), LayerSet::all());
  EXPECT_EQ(*parse_layers("geometric-normal"), LayerSet{Layer::geometric_normal});
  EXPECT_EQ(*parse_layers("geometric_normal"), LayerSet{Layer::geometric_normal});
  for (const char* bad : {"", "depth,", "deep", "all,deep", ",all", "Depth"}) {
    const auto read = parse_layers(bad);
    ASSERT_FALSE(read) << bad;
    EXPECT_NE(read.error().reason.find("geometric_normal"), std::string::npos);
  }
}

// Two renderings: a far card over half of the pixel, and a near one that covers it.
TEST(LayerMean, MixesByWeightAndKeepsTheNearest) {
  const LayerSet asked{Layer::alpha, Layer::depth, Layer::object};
  const LayerSet needed = LayerMean::needed(asked);
  EXPECT_TRUE(needed.has(Layer::distance)) << "decides which is nearest";
  EXPECT_EQ(LayerMean::needed({Layer::alpha}), LayerSet{Layer::alpha});
  LayerSample far, near;
  far.object = 2, far.alpha = 1.0f, far.depth = 7.0f, far.distance = 7.5f;
  near.object = 4, near.alpha = 1.0f, near.depth = 3.0f, near.distance = 3.5f;
  LayerSum half, whole;
  half.add(far, 0.5);
  half.add(LayerSample{}, 0.5);
  whole.add(near, 1.0);
  LayerMean mean;
  mean.add(planes_of(std::vector{half}, needed), 0.25);
  mean.add(planes_of(std::vector{whole}, needed), 0.5);
  mean.add(planes_of(std::vector{half}, needed), 0.25);
  const auto planes = mean.planes(asked);
  EXPECT_EQ(planes.size(), 3u);
  EXPECT_NEAR(find_plane(planes, Layer::alpha)->at(0)[0], 0.75f, 1e-7f);
  EXPECT_EQ(find_plane(planes, Layer::depth)->at(0)[0], 3.0f);
  const IdShares& ids = find_plane(planes, Layer::object)->ids[0];
  ASSERT_EQ(ids.size(), 3u);
  EXPECT_EQ(ids[0], (IdShare{4, 0.5f}));
  EXPECT_EQ(ids[1], (IdShare{2, 0.25f}));
  EXPECT_EQ(ids[2], (IdShare{no_id, 0.25f}));
}

TEST(Layers, SumIsAreaWeighted) {
  LayerSample near, far;
  near.object = 3, near.material = 1, near.alpha = 1.0f, near.distance = 2.0f, near.depth = 1.5f;
  near.albedo = {1.0f, 0.0f, 0.5f};
  far = near;
  far.object = 5, far.distance = 9.0f, far.depth = 8.0f, far.albedo = glm::vec3(0.0f, 1.0f, 0.5f);
  LayerSum part;
  part.add(far, 1.0);
  part.add(LayerSample{}, 3.0);  // the background
  LayerSum pixel;
  pixel.add(near, 0.2);
  pixel.add(part, 0.8);
  const auto planes = planes_of(std::vector{pixel}, LayerSet::all());
  EXPECT_NEAR(find_plane(planes, Layer::alpha)->at(0)[0], 0.4f, 1e-7f);
  EXPECT_NEAR(find_plane(planes, Layer::albedo)->at(0)[2], 0.2f, 1e-7f);
  EXPECT_EQ(find_plane(planes, Layer::depth)->at(0)[0], 1.5f);
  EXPECT_EQ(find_plane(planes, Layer::distance)->at(0)[0], 2.0f);
  const IdShares& objects = find_plane(planes, Layer::object)->ids[0];
  ASSERT_EQ(objects.size(), 3u);
  EXPECT_EQ(objects[0].id, no_id);
  EXPECT_NEAR(objects[0].share, 0.6f, 1e-7f);
  EXPECT_EQ(objects[1].id, 3u) << "equal shares by id";
  const IdShares& materials = find_plane(planes, Layer::material)->ids[0];
  ASSERT_EQ(materials.size(), 2u);
  EXPECT_NEAR(materials[1].share, 0.4f, 1e-7f);
  EXPECT_EQ(find_plane(planes, Layer::beauty), nullptr) << "the film has it";
}

TEST(Layers, FilmTakesThemFromTiles) {
  Film film(4, 2);
  FinishedTile tile;
  tile.rect = {2, -1, 4, 2};  // partly outside
  tile.radiance.resize(8);
  tile.split_level.resize(8);
  tile.cause.resize(8);
  tile.layers = blank_planes({Layer::depth, Layer::uv, Layer::object}, 8);
  for (std::size_t i = 0; i < 8; ++i) {
    tile.layers[0].values[i] = static_cast<float>(i);
    tile.layers[1].values[2 * i + 1] = 10.0f + static_cast<float>(i);
    tile.layers[2].ids[i] = {{static_cast<std::uint32_t>(i), 1.0f}};
  }
  film.put(tile);
  ASSERT_EQ(film.layers.size(), 3u);
  EXPECT_EQ(film.layers[0].at(film.index(2, 0))[0], 4.0f);
  EXPECT_EQ(film.layers[1].at(film.index(3, 0))[1], 15.0f);
  EXPECT_EQ(film.layers[2].ids[film.index(3, 0)][0].id, 5u);
  EXPECT_TRUE(std::isinf(film.layers[0].at(film.index(0, 1))[0])) << "not rendered: infinitely far";
  EXPECT_EQ(film.layers[2].ids[0][0].id, no_id);
}

}  // namespace
}  // namespace asos
