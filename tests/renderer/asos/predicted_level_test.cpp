#include "renderer/asos/predicted_level.h"

#include "renderer/scene/builtin.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace asos::test::predicted_level_test {
namespace {

RenderSettings settings_of(int max_level, double eps) {
  RenderSettings settings = make_settings(96, 54);
  settings.asos.max_level = max_level;
  settings.asos.eps = eps;
  return settings;
}

TEST(LevelPrediction, FollowsEachCause) {
  const RenderSettings now = settings_of(4, 1.0 / 256.0);
  const LevelPrediction same(now, now), deeper(now, settings_of(6, 1.0 / 1024.0)),
      flatter(now, settings_of(4, 1.0 / 16.0)), shallow(now, settings_of(1, 1.0 / 256.0));
  SplitPredictionData clear;
  for (const LevelPrediction& prediction : {same, deeper, flatter, shallow})
    EXPECT_EQ(prediction.level_of(clear), 0);
  SplitPredictionData cut{.edges = 2};
  EXPECT_EQ(same.level_of(cut), 2);
  EXPECT_EQ(deeper.level_of(cut), 2) << "its cells are exact";
  EXPECT_EQ(shallow.level_of(cut), 1);
  SplitPredictionData marginal{.unresolved = 1.0f / 128.0f, .edges = 4, .at_limit = true};
  EXPECT_EQ(same.level_of(marginal), 4);
  EXPECT_EQ(deeper.level_of(marginal), 6);
  EXPECT_EQ(flatter.level_of(marginal), 1) << "three halvings fewer";
  SplitPredictionData at_max_zero{.unresolved = 1.0f, .at_limit = true};
  const RenderSettings zero = settings_of(0, 1.0 / 256.0);
  EXPECT_EQ(LevelPrediction(zero, zero).level_of(at_max_zero), 0);
  EXPECT_EQ(LevelPrediction(zero, now).level_of(at_max_zero), 4);
  SplitPredictionData shaded{.error = 1.0f / 32.0f};
  EXPECT_EQ(same.level_of(shaded), 0) << "sampled, and not divided";
  EXPECT_GT(same.samples_of(shaded), 4u);
  EXPECT_EQ(flatter.samples_of(shaded), 0u);
  SplitPredictionData sampled{.samples = 64};
  EXPECT_EQ(same.samples_of(sampled), 64u);
  EXPECT_GT(deeper.samples_of(sampled), 64u);
  EXPECT_LT(flatter.samples_of(sampled), 64u);
  EXPECT_EQ(deeper.level_of(sampled), 0);
}

// At a large EPS every lit pixel takes a few samples. These once counted as splits, so the map
// differed from its prediction and had more split pixels than at a small EPS.
TEST(LevelPrediction, AgreesWithTheMapOfALargeEps) {
  const std::shared_ptr<const RenderScene> scene = *prepare(*builtin_scene("boxes"));
  const auto render = [&](const RenderSettings& settings) {
    return render_picture(*scene, first_camera(scene->world(), 96.0 / 54.0), settings).film;
  };
  const auto of = [](double eps) {
    RenderSettings settings = settings_of(4, eps);
    settings.width = 160;
    settings.height = 90;
    return settings;
  };
  const RenderSettings now = of(1.0 / 256.0), asked = of(0.46);
  const Film film = render(now), truth = render(asked), fine = render(of(1.0 / 64.0));
  const LevelPrediction prediction(now, asked);
  double apart = 0.0;
  int split = 0, split_fine = 0;
  for (std::size_t i = 0; i < film.outlook.size(); ++i) {
    apart += std::abs(prediction.level_of(film.outlook[i]) - truth.split_level[i]);
    split += truth.split_level[i] > 0;
    split_fine += fine.split_level[i] > 0;
  }
  EXPECT_LT(apart / static_cast<double>(film.outlook.size()), 0.08) << "levels; 0.16 before";
  EXPECT_LT(split, split_fine);
}

// The predicted map of other settings is close to their actual map: most pixels are within one
// level, and about as many are split.
TEST(LevelPrediction, IsCloseToTheMapOfOtherSettings) {
  for (const char* name : {"boxes", "office", "fence", "primitives"}) {
    const std::shared_ptr<const RenderScene> scene = *prepare(*builtin_scene(name));
    const auto render = [&](const RenderSettings& settings) {
      return render_picture(*scene, first_camera(scene->world(), 96.0 / 54.0), settings).film;
    };
    const RenderSettings now = settings_of(4, 1.0 / 256.0);
    const Film film = render(now);
    ASSERT_EQ(film.outlook.size(), film.radiance.size());
    for (const RenderSettings& asked :
         {now, settings_of(2, 1.0 / 256.0), settings_of(4, 1.0 / 32.0), settings_of(5, 1.0 / 512.0),
          settings_of(1, 1.0 / 16.0)}) {
      const Film truth = render(asked);
      const LevelPrediction prediction(now, asked);
      int close = 0, split = 0, truly_split = 0;
      for (std::size_t i = 0; i < film.outlook.size(); ++i) {
        const int level = prediction.level_of(film.outlook[i]);
        close += std::abs(level - truth.split_level[i]) <= 1;
        split += level > 0 || prediction.samples_of(film.outlook[i], film.cause[i]) > 0;
        truly_split += truth.split_level[i] > 0 || truth.samples[i] > 0;
      }
      const auto pixels = static_cast<double>(film.outlook.size());
      EXPECT_GT(close / pixels, 0.8)
          << name << " MAX " << asked.asos.max_level << " EPS 1/" << 1.0 / asked.asos.eps;
      EXPECT_NEAR(split / pixels, truly_split / pixels, 0.15)
          << name << " MAX " << asked.asos.max_level << " EPS 1/" << 1.0 / asked.asos.eps;
    }
  }
}

}  // namespace
}  // namespace asos::test::predicted_level_test
