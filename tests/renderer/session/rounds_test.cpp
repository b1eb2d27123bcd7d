// The passes of samples that pictures begin with, and the blocks that follow them.

#include "renderer/comparison/method.h"
#include "renderer/scene/builtin.h"
#include "renderer/session/final_blocks.h"
#include "renderer/session/render_session.h"
#include "renderer/session/sample_rounds.h"
#include "tests/support/expect_same.h"
#include "tests/support/render_picture.h"
#include "tests/support/sanitized.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numeric>
#include <thread>
#include <tuple>

namespace asos::test::rounds_test {
namespace {

constexpr int width = 160;
constexpr int height = 90;

Snapshot fence(int threads, Method method = Method::asos) {
  static const auto scene = *prepare(*builtin_scene("fence"));
  Snapshot snapshot;
  snapshot.scene = scene;
  (void)scene->features();
  snapshot.camera = first_camera(scene->world(), double{width} / height);
  snapshot.settings.method = method;
  snapshot.settings.width = width;
  snapshot.settings.height = height;
  snapshot.settings.threads = threads;
  snapshot.settings.shadow.cast = false;  // shadows take a third of the time
  return snapshot;
}

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
  EXPECT_EQ(session.reached().round, 0) << "before the first picture";
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

TEST(SampleRounds, DoubleUntilThePictureHasItsSamples) {
  Snapshot snapshot = fence(1, Method::uniform);
  snapshot.settings.sampling.spp = 10;
  const SampleRounds own{PlannedRender(snapshot)};
  EXPECT_TRUE(own.make_the_picture());
  EXPECT_EQ(own.rounds(), (std::vector{1, 2, 4, 8, 16}));
  snapshot.settings.sampling.spp = 9;
  EXPECT_EQ(SampleRounds{PlannedRender(snapshot)}.rounds(), (std::vector{1, 2, 4, 8, 9}));
  const SampleRounds first{PlannedRender(fence(1))};
  EXPECT_FALSE(first.make_the_picture());
  EXPECT_EQ(first.rounds().back(), 1024);
}

// The sums of a group are freed once it is final or its blocks no longer need them.
TEST(SampleRounds, FreeTheirSumsOnceNobodyNeedsThem) {
  Snapshot snapshot = fence(1, Method::sobol);
  snapshot.settings.sampling.spp = 4;
  for (const bool own : {true, false}) {
    if (!own) snapshot.settings.method = Method::asos;
    const PlannedRender render(snapshot);
    TileCollector tiles(render.plan, {});
    SampleRounds samples(render);
    RunClock clock(render.plan.blocks.size(), std::vector<double>(samples.rounds().size(), 1.0));
    clock.begin_forecast();
    for (const std::size_t round : {0, 1})
      (void)samples.work(render, round, round, tiles, clock, {});
    constexpr std::size_t of_a_pixel = sizeof(SampleSums::Sum) + sizeof(float);
    EXPECT_EQ(samples.bytes(), of_a_pixel * width * height);
    EXPECT_EQ(samples.work(render, 2, 2, tiles, clock, {}), own);
    EXPECT_EQ(samples.bytes(), own ? 0 : of_a_pixel * width * height);
    samples.release();
    EXPECT_EQ(samples.bytes(), 0u);
    EXPECT_EQ(film_of(tiles.take_finished()).radiance.size(), std::size_t{width} * height);
  }
}

// Edges change from pass to pass; flat areas do not.
TEST(SampleRounds, TellWhichBlocksMove) {
  const PlannedRender render(fence(1));
  TileCollector tiles(render.plan, {});
  SampleRounds samples(render);
  RunClock clock(render.plan.blocks.size(), std::vector<double>(samples.rounds().size(), 1.0));
  clock.begin_forecast();
  for (const std::size_t round : {0, 1, 2})
    EXPECT_FALSE(samples.work(render, round, round, tiles, clock, {}));
  ASSERT_TRUE(samples.wait_for(2, {}));
  EXPECT_GT(samples.seconds_up_to(1), samples.seconds_up_to(0));
  const std::vector<double> moved = samples.moved(render.plan);
  ASSERT_EQ(moved.size(), render.plan.blocks.size());
  // Errors against the picture that the passes converge to.
  const Film best = render_to_end(fence(1)).film;
  Film shown(width, height);
  for (const FinishedTile& tile : tiles.take_finished()) shown.put(tile);
  std::vector<double> off(moved.size(), 0.0);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const PixelRect& block = render.plan.blocks[i].rect;
    for (int y = block.y; y < block.y + block.height; ++y)
      for (int x = block.x; x < block.x + block.width; ++x) {
        const glm::vec3 error = shown.radiance[shown.index(x, y)] - best.radiance[best.index(x, y)];
        off[i] += static_cast<double>(glm::dot(error, error));
      }
  }
  // The half of the blocks that changed most has most of the error.
  std::vector<std::size_t> order(moved.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return moved[a] > moved[b]; });
  double first = 0.0, all = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    all += off[order[k]];
    if (k < order.size() / 2) first += off[order[k]];
  }
  EXPECT_GT(first, 0.85 * all);
}

TEST(FinalBlocks, ThoseOfTheLargestGainComeFirst) {
  Snapshot snapshot = fence(1);
  snapshot.settings.asos.max_level = 0;
  const PlannedRender render(snapshot);
  TileCollector tiles(render.plan, {});
  FinalBlocks blocks(render, 0);
  RunClock clock(render.plan.blocks.size(), {1.0});
  clock.begin_forecast();
  EXPECT_FALSE(blocks.work_trial(render, 1e9, tiles, clock, {}));
  ASSERT_TRUE(blocks.wait_for_trial({}));
  const std::size_t tried = tiles.take_finished().size();
  EXPECT_GT(tried, 1u);
  EXPECT_LT(tried, render.plan.blocks.size() / 20);
  std::vector<double> gain(render.plan.blocks.size());
  std::iota(gain.begin(), gain.end(), 0.0);
  blocks.set_gains(gain);
  EXPECT_TRUE(blocks.work(render, tiles, clock, {}));
  const std::vector<FinishedTile> rest = tiles.take_finished();
  ASSERT_EQ(rest.size(), render.plan.blocks.size() - tried);
  const auto number = [&](const FinishedTile& tile) {
    const auto found = std::find_if(
        render.plan.blocks.begin(), render.plan.blocks.end(), [&](const WorkPlan::Block& block) {
          return block.rect.x == tile.rect.x && block.rect.y == tile.rect.y;
        });
    return found - render.plan.blocks.begin();
  };
  // Every fourth block is one of those spread over the picture; the others are in order of gain.
  std::vector<std::ptrdiff_t> by_gain, spread;
  for (std::size_t i = 0; i < rest.size(); ++i)
    (i % 4 == 3 ? spread : by_gain).push_back(number(rest[i]));
  EXPECT_TRUE(std::is_sorted(by_gain.rbegin(), by_gain.rend()));
  EXPECT_FALSE(std::is_sorted(spread.rbegin(), spread.rend()));
}

// A few blocks spread over the picture predict the total time, within a limited trial time.
TEST(FinalBlocks, ATrialTellsTheTimeOfAll) {
  const PlannedRender render(fence(1));
  const auto expected = [&](double enough) {
    TileCollector tiles(render.plan, {});
    FinalBlocks blocks(render, 0);
    RunClock clock(render.plan.blocks.size(), {1.0});
    clock.begin_forecast();
    (void)blocks.work_trial(render, enough, tiles, clock, {});
    EXPECT_TRUE(blocks.wait_for_trial({}));
    const std::vector<FinishedTile> tried = tiles.take_finished();
    double seconds = 0.0;
    for (const FinishedTile& tile : tried)
      for (const float of_pixel : tile.seconds) seconds += static_cast<double>(of_pixel);
    const auto count = static_cast<double>(tried.size());
    const double all = seconds / count * static_cast<double>(render.plan.blocks.size());
    EXPECT_NEAR(blocks.expected_seconds(), all, 1e-3 * all);
    return std::pair(blocks.expected_seconds(), tried.size());
  };
  const auto [all_told, all_tried] = expected(1e9);
  const auto [first_told, first_tried] = expected(1e-9);
  EXPECT_EQ(all_tried, (render.plan.blocks.size() + 31) / 32);
  EXPECT_LT(first_tried, all_tried);
  EXPECT_GT(first_told, 0.0);
  EXPECT_GT(all_told, 0.0);
}

// Unlit surfaces have their final colour from the first stage on.
TEST(FinalBlocks, OfAnUnlitSurfaceComeInTwoStages) {
  World world = still_life().world;
  world.materials[world.parts.front().material].unlit = true;
  Snapshot snapshot;
  snapshot.scene = make_render_scene(std::move(world), still_life().lights);
  snapshot.camera = look_at({2, 2, 5}, {0, 0.7, 0}, 0.7);
  snapshot.settings.asos.max_level = 2;
  snapshot.settings.width = 64;
  snapshot.settings.height = 64;
  const PlannedRender render(snapshot);
  ASSERT_TRUE(render.unlit);
  TileCollector tiles(render.plan, {});
  FinalBlocks blocks(render, 0);
  RunClock clock(render.plan.blocks.size(), {1.0});
  clock.begin_forecast();
  EXPECT_TRUE(blocks.work(render, tiles, clock, {}));
  std::size_t started = 0, partly_unlit = 0;
  Film film(64, 64);
  for (const FinishedTile& tile : tiles.take_finished()) {
    film.put(tile);
    if (!tile.coarse) continue;
    ++started;
    partly_unlit += tile.unlit.empty() ? 0 : 1;
  }
  EXPECT_GT(started, 0u);
  EXPECT_GT(partly_unlit, 0u);
  const Film direct = render_to_end(snapshot).film;
  EXPECT_EQ(film.radiance, direct.radiance);
  EXPECT_TRUE(film.unlit == direct.unlit);
}

}  // namespace
}  // namespace asos::test::rounds_test
