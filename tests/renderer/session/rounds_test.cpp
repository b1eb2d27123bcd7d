// The passes of samples that pictures begin with, and the blocks that follow them.

#include "renderer/comparison/method.h"
#include "renderer/scene/builtin.h"
#include "renderer/session/render_session.h"
#include "renderer/session/render_steps.h"
#include "renderer/session/sample_rounds.h"
#include "tests/support/expect_same.h"
#include "tests/support/render_picture.h"
#include "tests/support/sanitized.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <set>
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
  EXPECT_EQ(first.rounds(), (std::vector{1, 2, 4}));
}

// The sums of a group are freed once it is final.
TEST(SampleRounds, FreeTheirSumsOnceNobodyNeedsThem) {
  Snapshot snapshot = fence(1, Method::sobol);
  snapshot.settings.sampling.spp = 4;
  const PlannedRender render(snapshot);
  TileCollector tiles(render.plan, {});
  SampleRounds samples(render);
  RunClock clock(render.plan.blocks.size(), std::vector<double>(samples.rounds().size(), 1.0));
  clock.begin_forecast();
  for (const std::size_t round : {0, 1})
    EXPECT_FALSE(samples.work(render, round, round, tiles, clock, {}));
  EXPECT_GT(samples.bytes(), sizeof(SampleSums::Sum) * width * height);
  EXPECT_TRUE(samples.work(render, 2, 2, tiles, clock, {}));
  EXPECT_EQ(samples.bytes(), 0u);
}

/// A picture of the fence after its rounds of samples, without steps.
struct Sampled {
  PlannedRender render{fence(1)};
  TileCollector tiles{render.plan, {}};
  SampleRounds samples{render};
  RunClock clock{render.plan.blocks.size(), std::vector<double>(3, 1.0)};

  Sampled() {
    clock.begin_forecast();
    for (const std::size_t round : {0, 1, 2})
      EXPECT_FALSE(samples.work(render, round, round, tiles, clock, {}));
    EXPECT_TRUE(samples.wait_for_rounds(3, {}));
  }
};

// Single pixels that continue have the samples of a block in which all do.
TEST(SampleRounds, ContinueSinglePixels) {
  Sampled of;
  const WorkPlan& plan = of.render.plan;
  std::vector<PlannedPixel> some;
  for (std::uint32_t b = 0; b < plan.blocks.size(); b += 7) {
    const PixelRect& block = plan.blocks[b].rect;
    some.push_back({b, block.x + 3, block.y + 1});
    if (b % 2 == 0) some.push_back({b, block.x, block.y});
  }
  Film film(width, height);
  for (const FinishedTile& tile : of.tiles.take_finished()) film.put(tile);
  Film expected = film;
  for (const BlockGroup& group : plan.groups) {
    RenderSettings settings = of.render.snapshot.settings;
    settings.method = Method::sobol;
    const BlockJob job = of.render.job(settings, group.rect, {});
    const auto places = row_of(Method::sobol).places(settings);
    PixelSamples pixels(group.rect);
    for (const int end : {1, 2, 4, 16}) pixels.advance(job, *places, end, end);
    for (const PlannedPixel& p : some) {
      if (plan.groups[plan.blocks[p.block].group].rect != group.rect) continue;
      const std::size_t at = expected.index(p.x, p.y);
      EXPECT_NE(expected.radiance[at], glm::vec3(0.0f));
      expected.radiance[at] = glm::vec3(pixels.sum(pixels.index(p.x, p.y)).mean());
    }
  }
  const auto sampled = of.samples.continue_pixels(of.render, some, of.tiles, {});
  ASSERT_EQ(sampled.size(), some.size());
  for (std::size_t i = 0; i < some.size(); ++i) {
    const std::size_t at = expected.index(some[i].x, some[i].y);
    const glm::vec3 off =
        glm::clamp(expected.radiance[at], 0.0f, 1.0f) - glm::clamp(film.radiance[at], 0.0f, 1.0f);
    EXPECT_EQ(sampled[i].taken, 16);
    EXPECT_NEAR(sampled[i].moved, glm::dot(off, off), 1e-5f);
  }
  const std::vector<FinishedTile> tiles = of.tiles.take_finished();
  EXPECT_EQ(tiles.size(), (plan.blocks.size() + 6) / 7);
  for (const FinishedTile& tile : tiles) film.put(tile);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    // Packets of other rays may change the last bits of a hit.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(film.radiance[i][c], expected.radiance[i][c], 1e-4f);
    changed += film.radiance[i] != expected.radiance[i];
  }
  EXPECT_LT(changed, some.size() / 2);
}

// A worker that enters after the others have passed some rounds walks through them again, and
// leaves the order of the later ones alone.
TEST(SampleRounds, ALateWorkerRendersNothingTwice) {
  Snapshot snapshot = fence(2, Method::sobol);
  snapshot.settings.sampling.spp = 16;
  const PlannedRender render(snapshot);
  TileCollector tiles(render.plan, {});
  SampleRounds samples(render);
  RunClock clock(render.plan.blocks.size(), std::vector<double>(samples.rounds().size(), 1.0));
  clock.begin_forecast();
  std::atomic<bool> finished = false;
  const auto walk = [&](const auto& before_round) {
    for (std::size_t round = 0; round < samples.rounds().size(); ++round) {
      before_round(round);
      ASSERT_TRUE(samples.put_what_moves_first(round, {}));
      if (samples.work(render, round, round, tiles, clock, {})) finished = true;
    }
  };
  std::jthread late;
  walk([&](std::size_t round) {
    if (round == 3) late = std::jthread([&] { walk([](std::size_t) {}); });
  });
  late.join();
  EXPECT_TRUE(finished);
  std::map<std::pair<int, int>, int> seen;
  for (const FinishedTile& tile : tiles.take_finished()) ++seen[{tile.rect.x, tile.rect.y}];
  EXPECT_EQ(seen.size(), render.plan.groups.size());
  for (const auto& [place, count] : seen) EXPECT_LE(count, 5) << "rounds of 1, 2, 4, 8 and 16";
  EXPECT_EQ(tiles.statistics().eye_rays, 16u * width * height);
}

/// Does all steps of a queue, each in the time that `seconds` says.
template <typename Seconds>
std::vector<Step> all_steps(StepQueue& queue, const Seconds& seconds) {
  std::vector<Step> steps;
  while (!queue.finished()) {
    std::optional<Step> step = queue.take(true);
    if (!step) ADD_FAILURE() << "no step, and not finished";
    if (!step) break;
    std::vector<StepQueue::Sampled> sampled;
    if (step->kind == Step::Kind::samples) {
      for (std::size_t i = 0; i < step->pixels.size(); ++i) sampled.push_back({16, 0.001f});
    }
    queue.done(*step, seconds(*step), sampled);
    steps.push_back(*std::move(step));
  }
  return steps;
}

TEST(StepQueue, RendersEachBlockOnceInSpreadOrderWithoutSamples) {
  const PlannedRender render(fence(1));
  StepQueue queue(render.plan, 1.0 / 256.0);
  const std::vector<Step> steps = all_steps(queue, [](const Step&) { return 0.5; });
  std::vector<std::size_t> blocks;
  for (const Step& step : steps) {
    EXPECT_EQ(step.kind, Step::Kind::start);
    blocks.push_back(step.block);
  }
  EXPECT_EQ(blocks, render.plan.spread_blocks());
}

// Most of the error lies in few pixels: they come before anything else, and blocks of flat pixels
// come last.
TEST(StepQueue, LargestGainsComeFirst) {
  Sampled of;
  StepQueue queue(of.render.plan, 1.0 / 256.0);
  queue.begin(of.samples);
  double rounds = 0.0;
  for (std::size_t g = 0; g < of.render.plan.groups.size(); ++g) rounds += of.samples.seconds(g);
  const double of_block = 20.0 * rounds / static_cast<double>(of.render.plan.blocks.size());
  const std::vector<Step> steps = all_steps(queue, [&](const Step& step) {
    return step.kind == Step::Kind::samples ? step.seconds : of_block;
  });
  std::vector<double> seen(of.render.plan.blocks.size(), 0.0);
  std::set<std::pair<int, int>> sampled;
  double early = 0.0, all = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].kind == Step::Kind::start) ++seen[steps[i].block];
    for (const PlannedPixel& p : steps[i].pixels) {
      sampled.emplace(p.x, p.y);
      EXPECT_EQ(seen[p.block], 0.0) << "a pixel of a block that is rendered already";
    }
    if (std::isinf(steps[i].gain)) continue;  // measures its kind
    const double gain = steps[i].gain * steps[i].seconds;
    all += gain;
    if (i < steps.size() / 4) early += gain;
  }
  EXPECT_EQ(seen, std::vector<double>(seen.size(), 1.0));
  EXPECT_GT(sampled.size(), 100u);
  EXPECT_LT(sampled.size(), std::size_t{width} * height) << "flat pixels wait for their blocks";
  EXPECT_GT(early, 0.7 * all);
}

// Until blocks can be rendered, pixels take samples, and then none is left.
TEST(StepQueue, TakesSamplesWhileBlocksCannotBeRendered) {
  Sampled of;
  StepQueue queue(of.render.plan, 1.0 / 256.0);
  queue.begin(of.samples);
  std::size_t samples = 0;
  while (const std::optional<Step> step = queue.take(false)) {
    ASSERT_EQ(step->kind, Step::Kind::samples);
    std::vector<StepQueue::Sampled> sampled;
    for (std::size_t i = 0; i < step->pixels.size(); ++i)
      sampled.push_back({SampleRounds::most_samples, 0.0f});
    samples += step->pixels.size();
    queue.done(*step, step->seconds, sampled);
  }
  EXPECT_GT(samples, 100u);
  EXPECT_FALSE(queue.finished());
  EXPECT_FALSE(queue.seconds_left().has_value()) << "no block was measured";
  const std::optional<Step> step = queue.take(true);
  ASSERT_TRUE(step.has_value());
  EXPECT_EQ(step->kind, Step::Kind::start);
}

// Unlit surfaces have their final colour from the first stage on.
TEST(RenderSteps, OfAnUnlitSurfaceComeInTwoStages) {
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
  SampleRounds samples(render);
  RenderSteps steps(render, samples);
  RunClock clock(render.plan.blocks.size(), {1.0});
  clock.begin_forecast();
  EXPECT_TRUE(steps.work(render, tiles, clock, {}));
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
