// The passes of samples that pictures begin with, and the blocks that follow them.

#include "renderer/comparison/method.h"
#include "renderer/session/render_session.h"
#include "tests/renderer/session/fence_picture.h"
#include "tests/support/expect_same.h"
#include "tests/support/render_picture.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <thread>
#include <tuple>

namespace asos::test::rounds_test {
namespace {

using namespace fence_picture;

struct Shown {
  std::vector<FinishedTile> tiles;
  RenderStatistics statistics;
  Reached reached;
};

Shown shown_of(const Snapshot& snapshot) {
  RenderSession session;
  session.restart(snapshot);
  session.wait();
  return {session.take_finished(), session.statistics(), session.reached()};
}

Film film_of(const std::vector<FinishedTile>& tiles) {
  Film film(width, height);
  for (const FinishedTile& tile : tiles) film.put(tile);
  return film;
}

TEST(Rounds, EndAsADirectRenderDoes) {
  for (const Method method : {Method::asos, Method::sobol, Method::uniform, Method::stochastic,
                              Method::whitted, Method::mitchell}) {
    for (const int threads : {1, 3}) {
      if (sanitized && threads == 1) continue;  // it would take minutes
      Snapshot snapshot = fence(threads, method);
      snapshot.settings.sampling.spp = 9;
      snapshot.settings.asos.max_level = 2;
      const Shown shown = shown_of(snapshot);
      const RenderResult direct = render_to_end(snapshot);
      const Film film = film_of(shown.tiles);
      EXPECT_EQ(film.radiance, direct.film.radiance) << row_of(method).name;
      EXPECT_EQ(film.split_level, direct.film.split_level);
      EXPECT_EQ(film.rays, direct.film.rays);
      expect_same(shown.statistics, direct.statistics);
      EXPECT_EQ(shown.reached.pass, Reached::Pass::final_pixels);
      EXPECT_EQ(shown.reached.final_share, 1.0);
    }
  }
}

TEST(Rounds, EndAsADirectRenderDoesBehindATransparentBackground) {
  for (const Method method : {Method::asos, Method::sobol}) {
    Snapshot snapshot = fence(2, method);
    snapshot.settings.background.kind = BackgroundKind::transparent;
    snapshot.settings.asos.max_level = 1;
    const Film film = film_of(shown_of(snapshot).tiles);
    const Film direct = render_to_end(snapshot).film;
    EXPECT_EQ(film.radiance, direct.radiance);
    ASSERT_EQ(film.coverage.size(), direct.coverage.size());
    EXPECT_EQ(film.coverage, direct.coverage);
    EXPECT_LT(*std::min_element(film.coverage.begin(), film.coverage.end()), 1.0f);
  }
}

// Whatever pass is the last, its pixels have layers. Only final ones have an estimate of the error.
TEST(Rounds, HaveLayersFromTheFirstPassOn) {
  Snapshot snapshot = fence(2);
  snapshot.settings.layers = {Layer::object, Layer::alpha, Layer::error};
  std::size_t coarse = 0;
  Film film(width, height);
  for (const FinishedTile& tile : shown_of(snapshot).tiles) {
    film.put(tile);
    ASSERT_EQ(tile.layers.size(), 3u);
    const LayerPlane& objects = *find_plane(tile.layers, Layer::object);
    const LayerPlane& errors = *find_plane(tile.layers, Layer::error);
    for (std::size_t i = 0; i < tile.radiance.size(); ++i) {
      float sum = 0.0f;
      for (const IdShare& share : objects.ids[i]) sum += share.share;
      EXPECT_NEAR(sum, 1.0f, 1e-5f);
      EXPECT_GT(errors.values[i], 0.0f);
      coarse += std::isinf(errors.values[i]);
    }
  }
  EXPECT_GE(coarse, std::size_t{width} * height);
  const Film direct = render_to_end(snapshot).film;
  for (const Layer layer : {Layer::object, Layer::alpha, Layer::error}) {
    EXPECT_EQ(find_plane(film.layers, layer)->values, find_plane(direct.layers, layer)->values);
    EXPECT_EQ(find_plane(film.layers, layer)->ids, find_plane(direct.layers, layer)->ids);
  }
}

// The first pass of most methods is one Sobol sample per pixel; some methods have their own
// samples.
TEST(Rounds, BeginWithOneSampleAPixel) {
  const Snapshot snapshot = fence(1);
  Film shown(width, height);
  std::size_t pixels = 0;
  for (const FinishedTile& tile : shown_of(snapshot).tiles) {
    if (pixels == 3u * width * height) break;
    shown.put(tile);
    EXPECT_TRUE(tile.coarse);
    pixels += tile.radiance.size();
  }
  Snapshot sobol = snapshot;
  sobol.settings.method = Method::sobol;
  sobol.settings.sampling.spp = 1;
  EXPECT_EQ(shown.radiance, render_to_end(sobol).film.radiance);
}

// For each group one worker shows all pictures in order: blocks, their quarters, 1, 2, 4 samples
// and so on. With several workers, a late one may skip a picture or take more passes. The pictures
// of several workers are then a subsequence of one worker's, possibly followed by later ones.
TEST(Rounds, ShowTheSameWhateverTheThreads) {
  using Pictures = std::vector<std::vector<glm::vec3>>;
  const auto shown = [](int threads) {
    std::map<std::tuple<int, int, int>, Pictures> pictures;
    for (FinishedTile& tile : shown_of(fence(threads)).tiles) {
      if (tile.rect.width <= block_size) continue;  // a block of the trial, or later
      pictures[{tile.rect.x, tile.rect.y, tile.rect.width}].push_back(std::move(tile.radiance));
    }
    return pictures;
  };
  const auto one = shown(1);
  const auto many = shown(4);
  ASSERT_EQ(many.size(), one.size());
  std::size_t same = 0;
  for (const auto& [place, later] : many) {
    const auto found = one.find(place);
    ASSERT_NE(found, one.end());
    const Pictures& all = found->second;
    auto at = all.begin();
    bool after_all = false;
    for (const std::vector<glm::vec3>& picture : later) {
      const auto next = std::find(at, all.end(), picture);
      if (next == all.end()) {
        after_all = true;
        continue;
      }
      EXPECT_FALSE(after_all) << "one worker shows no such picture";
      at = next + 1;
      ++same;
    }
  }
  EXPECT_GT(same, 3u * one.size());
}

TEST(Rounds, AreCounted) {
  Snapshot snapshot = fence(2, Method::sobol);
  snapshot.settings.sampling.spp = 1 << 16;
  RenderSession session;
  session.restart(snapshot);
  const Reached first = session.reached();
  if (first.pass < Reached::Pass::samples) {
    EXPECT_EQ(first.round, 0) << "before the first picture";
  }
  while (session.reached().pass < Reached::Pass::samples)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  session.cancel();
  const Reached reached = session.reached();
  EXPECT_EQ(reached.rounds, 17);
  EXPECT_EQ(1 << (reached.round - 2), reached.samples) << "the next round was running";
}

TEST(Rounds, AStoppedRenderKeepsWhatIsFinal) {
  RenderSession session;
  session.restart(fence(2));
  while (session.reached().final_share == 0.0 && session.progress().running)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  session.cancel();
  const Reached reached = session.reached();
  EXPECT_GE(reached.pass, Reached::Pass::samples);
  EXPECT_GT(reached.final_share, 0.0);
  std::size_t final_pixels = 0;
  for (const FinishedTile& tile : session.take_finished())
    if (!tile.coarse) final_pixels += tile.radiance.size();
  EXPECT_EQ(static_cast<double>(final_pixels) / (width * height), reached.final_share);
}

}  // namespace
}  // namespace asos::test::rounds_test
