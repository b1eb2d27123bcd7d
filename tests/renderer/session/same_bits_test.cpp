#include "renderer/comparison/method.h"
#include "renderer/scene/builtin.h"
#include "renderer/session/render_session.h"
#include "renderer/session/work_plan.h"
#include "tests/support/expect_same.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

// A picture depends only on scene, camera and settings. It is the same, bit by bit, for any number
// of workers, order of blocks and crop.

namespace asos::test {
namespace {

struct Choice {
  std::string name;
  RenderSettings settings;
};

/// Each method, and each variant of ASOS.
std::vector<Choice> choices() {
  RenderSettings base;
  base.width = 90;  // so that the last blocks are clipped to all sizes
  base.height = 54;
  base.sampling.spp = 4;
  base.asos.max_level = 2;
  std::vector<Choice> all;
  const auto add = [&](const std::string& name, auto change) {
    change(all.emplace_back(Choice{name, base}).settings);
  };
  add("asos_published", [](RenderSettings& s) { s.method = Method::asos_published; });
  add("uniform", [](RenderSettings& s) { s.method = Method::uniform; });
  add("stochastic", [](RenderSettings& s) { s.method = Method::stochastic; });
  add("sobol", [](RenderSettings& s) { s.method = Method::sobol; });
  add("sobol_adaptive", [](RenderSettings& s) { s.method = Method::sobol_adaptive; });
  add("forced shadows", [](RenderSettings& s) { s.shadow.quality = ShadowQuality::forced; });
  add("whitted", [](RenderSettings& s) { s.method = Method::whitted; });
  add("whitted with spheres", [](RenderSettings& s) {
    s.method = Method::whitted;
    s.sampling.spheres = true;
    s.sampling.depth = 5;  // in parts of a block
  });
  add("mitchell", [](RenderSettings& s) {
    s.method = Method::mitchell;
    s.sampling.spp = 9;
  });
  add("ray_bound", [](RenderSettings& s) { s.method = Method::ray_bound; });
  add("average", [](RenderSettings& s) { s.method = Method::average; });
  add("beam", [](RenderSettings& s) { s.method = Method::beam; });
  for (const int fat : {2, 4, 8, 16})
    add("fat " + std::to_string(fat), [fat](RenderSettings& s) { s.asos.fat = fat; });
  add("published rule", [](RenderSettings& s) { s.asos.rule = StoppingRule::published; });
  add("cone", [](RenderSettings& s) { s.asos.detect = Detection::cone; });
  add("cone, fat 16", [](RenderSettings& s) {
    s.asos.detect = Detection::cone;
    s.asos.fat = 16;
  });
  add("wide filter", [](RenderSettings& s) { s.filter_width = 2.5; });
  add("jittered point leaves", [](RenderSettings& s) {
    s.asos.leaf = LeafKind::point;
    s.asos.jitter = true;
  });
  if (!sanitized) return all;
  // A fifth of the settings: the data shared between threads does not depend on them.
  std::vector<Choice> some;
  for (std::size_t i = 0; i < all.size(); i += 5) some.push_back(all[i]);
  return some;
}

class SameBits : public testing::Test {
 protected:
  void SetUp() override {
    const auto loaded = builtin_scene("boxes");
    ASSERT_TRUE(loaded) << loaded.error().message();
    const auto scene = prepare(*loaded);
    ASSERT_TRUE(scene) << scene.error().message();
    scene_ = *scene;
  }

  [[nodiscard]] Snapshot snapshot(const RenderSettings& settings) const {
    return {scene_, scene_->world().cameras.front(), settings, false};
  }
  [[nodiscard]] RenderResult render(RenderSettings settings, int threads) const {
    settings.threads = threads;
    return render_to_end(snapshot(settings));
  }

  std::shared_ptr<const RenderScene> scene_;
};

TEST_F(SameBits, ForAnyNumberOfThreads) {
  for (const Choice& choice : choices()) {
    SCOPED_TRACE(choice.name);
    const RenderResult one = render(choice.settings, 1);
    ASSERT_EQ(one.film.width, choice.settings.width);
    const std::vector<glm::vec3>& pixels = one.film.radiance;
    EXPECT_NE(std::adjacent_find(pixels.begin(), pixels.end(), std::not_equal_to<>()), pixels.end())
        << "a flat picture proves nothing";
    for (const int threads : {2, 5}) {
      SCOPED_TRACE(threads);
      const RenderResult many = render(choice.settings, threads);
      expect_same(many.film, one.film);
      expect_same(many.statistics, one.statistics);
    }
  }
}

TEST_F(SameBits, ForBlocksInReverseOrder) {
  for (const Choice& choice : choices()) {
    SCOPED_TRACE(choice.name);
    const RenderSettings& settings = choice.settings;
    const WorkPlan plan(settings);
    const View view(scene_->world().cameras.front(), settings.width, settings.height);
    Film film(settings.width, settings.height);
    std::vector<RenderStatistics> of_block(plan.blocks.size());
    for (std::size_t i = plan.blocks.size(); i-- > 0;) {
      const BlockResult block = render_block(*scene_, view, settings, plan.blocks[i].rect);
      film.put(block.tile);
      of_block[i] = block.statistics;
    }
    RenderStatistics statistics;
    for (const RenderStatistics& s : of_block) statistics += s;
    const RenderResult forwards = render(settings, 2);
    expect_same(film, forwards.film);
    expect_same(statistics, forwards.statistics);
  }
}

TEST_F(SameBits, ForACropAsThatPartOfTheWhole) {
  for (const Choice& choice : choices()) {
    SCOPED_TRACE(choice.name);
    const RenderResult whole = render(choice.settings, 2);
    for (const PixelRect crop : {PixelRect{37, 21, 25, 18},
                                 {0, 0, 1, 1},
                                 {89, 53, 1, 1},
                                 {31, 31, 3, 3},
                                 {0, 0, 90, 54}}) {
      SCOPED_TRACE(crop.x);
      RenderSettings settings = choice.settings;
      settings.crop = crop;
      const RenderResult part = render(settings, 2);
      Film expected(crop.width, crop.height);
      for (int y = 0; y < crop.height; ++y) {
        for (int x = 0; x < crop.width; ++x) {
          const std::size_t from = whole.film.index(crop.x + x, crop.y + y);
          expected.radiance[expected.index(x, y)] = whole.film.radiance[from];
          expected.split_level[expected.index(x, y)] = whole.film.split_level[from];
          expected.cause[expected.index(x, y)] = whole.film.cause[from];
        }
      }
      expect_same(part.film, expected);
    }
  }
}

}  // namespace
}  // namespace asos::test
