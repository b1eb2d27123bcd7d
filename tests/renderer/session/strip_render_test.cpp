#include "renderer/session/strip_render.h"

#include "renderer/session/film_render.h"
#include "renderer/session/render_session.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stop_token>
#include <vector>

namespace asos {
namespace {

/// Keeps the rows.
class RowsInMemory : public PictureWriter {
 public:
  Result<void> add_rows(std::span<const glm::vec3> radiance, std::span<const float> coverage,
                        std::span<const glm::vec4> unlit) override {
    if (fails) return unexpected(Error{"memory", "is full"});
    covered.insert(covered.end(), coverage.begin(), coverage.end());
    unlit_parts.insert(unlit_parts.end(), unlit.begin(), unlit.end());
    rows.insert(rows.end(), radiance.begin(), radiance.end());
    largest = std::max(largest, radiance.size());
    return {};
  }
  Result<void> finish() override { return {}; }

  std::vector<glm::vec3> rows;
  std::vector<float> covered;
  std::vector<glm::vec4> unlit_parts;
  std::size_t largest = 0;
  bool fails = false;
};

Snapshot still_life_of(Method method) {
  return {
      .scene = test::make_render_scene(test::still_life()),
      .camera = test::look_at({2, 2, 5}, {0, 0.7, 0}, 0.7),
      .settings = {
          .width = 83, .height = 131, .method = method, .asos = {.max_level = 2}, .threads = 2}};
}

TEST(StripRender, GivesThePictureOfOnePieceBitForBit) {
  for (const Method method : {Method::asos, Method::whitted}) {
    for (const PixelRect crop : {PixelRect{}, PixelRect{5, 37, 70, 90}}) {
      Snapshot snapshot = still_life_of(method);
      snapshot.settings.crop = crop;
      RowsInMemory writer;
      std::vector<double> shares;
      const auto end = render_strips(
          snapshot, writer, {}, [&](double share) { shares.push_back(share); }, 83 * 40);
      ASSERT_TRUE(end) << end.error().message();
      EXPECT_EQ(*end, StripsEnd::finished);
      EXPECT_TRUE(writer.rows == render_to_end(snapshot).film.radiance);
      EXPECT_LE(writer.largest, 83u * 32u);
      EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
      EXPECT_EQ(shares.back(), 1.0);
    }
  }
}

// The unlit part is the same in strips, stages or passes as in one piece.
TEST(StripRender, TellsTheUnlitPartOfPixels) {
  for (const Method method : {Method::asos, Method::sobol}) {
    Snapshot snapshot = still_life_of(method);
    World world = test::still_life().world;
    world.materials[world.parts.front().material].unlit = true;
    snapshot.scene = test::make_render_scene(std::move(world), test::still_life().lights);
    snapshot.settings.sampling.spp = 16;
    RowsInMemory writer;
    ASSERT_TRUE(render_strips(snapshot, writer, {}));
    const std::vector<glm::vec4> unlit = render_to_end(snapshot).film.unlit;
    EXPECT_TRUE(writer.unlit_parts == unlit);
    const auto share = [&](float least, float most) {
      return std::count_if(unlit.begin(), unlit.end(),
                           [&](glm::vec4 part) { return part.w >= least && part.w <= most; });
    };
    EXPECT_GT(share(1.0f, 1.0f), 100) << "it fills pixels";
    EXPECT_GT(share(0.01f, 0.99f), 10) << "it shares pixels";
    EXPECT_GT(share(0.0f, 0.0f), 100) << "lit surfaces fill pixels";
    RenderSession session;  // like a window, with coarse passes first
    session.restart(snapshot);
    session.wait();
    Film shown(83, 131);
    for (const FinishedTile& tile : session.take_finished()) shown.put(tile);
    EXPECT_TRUE(shown.unlit == unlit);
  }
}

TEST(StripRender, StopsAndFailsWithoutDelay) {
  const Snapshot snapshot = still_life_of(Method::asos);
  RowsInMemory writer;
  std::stop_source stop;
  const auto stopped = render_strips(
      snapshot, writer, stop.get_token(), [&](double) { stop.request_stop(); }, 83 * 32);
  EXPECT_EQ(stopped.value(), StripsEnd::stopped);
  EXPECT_LT(writer.rows.size(), 83u * 131u);
  writer.fails = true;
  EXPECT_EQ(render_strips(snapshot, writer, {}).error().reason, "is full");
  Snapshot wrong = snapshot;
  wrong.settings.width = 0;
  EXPECT_EQ(render_strips(wrong, writer, {}).error().subject, "width");
}

}  // namespace
}  // namespace asos
