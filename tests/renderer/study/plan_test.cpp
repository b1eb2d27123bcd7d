#include "renderer/study/plan.h"

#include "renderer/scene/load.h"
#include "renderer/study/regions.h"
#include "renderer/study/timed_render.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace asos {
namespace {

StudyPlan small_plan() {
  StudyPlan plan;
  plan.scenes = {"builtin:boxes", "builtin:fence"};
  plan.width = 16;
  plan.height = 12;
  return plan;
}

TEST(Plan, ListsEveryJobOnceInAnOrderOfItsOwn) {
  const auto jobs = make_jobs(small_plan());
  ASSERT_TRUE(jobs) << jobs.error().message();
  std::set<std::string> titles;
  for (std::size_t i = 0; i < jobs->size(); ++i) {
    EXPECT_EQ((*jobs)[i].id, i);
    titles.insert((*jobs)[i].title());
  }
  EXPECT_EQ(titles.size(), jobs->size());
  const auto again = make_jobs(small_plan());
  for (std::size_t i = 0; i < jobs->size(); ++i) EXPECT_EQ((*jobs)[i].title(), (*again)[i].title());
}

TEST(Plan, RepetitionsFollowEachOtherAndMethodsTakeTurns) {
  const auto jobs = make_jobs(small_plan());
  ASSERT_TRUE(jobs);
  int last = 1;
  std::set<std::string> met;
  for (const Job& job : *jobs) {
    if (job.kind != JobKind::point || job.scene != "builtin:boxes") continue;
    EXPECT_GE(job.repetition, last);
    last = job.repetition;
    // The first step of every method comes before the second of any.
    if (met.size() < default_methods().size()) {
      EXPECT_TRUE(met.insert(job.rung.method).second) << job.title();
    }
  }
  EXPECT_EQ(last, 3);
}

TEST(Plan, EverySettingIsOneThatTheRendererTakes) {
  StudyPlan plan = small_plan();
  plan.methods = ladder_methods();
  plan.paper = true;
  const auto jobs = make_jobs(plan);
  ASSERT_TRUE(jobs);
  for (const Job& job : *jobs) {
    const auto settings = validated(job.rung.settings);
    EXPECT_TRUE(settings) << job.title() << ": " << settings.error().message();
  }
}

TEST(Plan, TheReferenceDoublesAndSharesNoPointsWithAnyMethod) {
  EXPECT_EQ(reference_samples(0), 64);
  int total = reference_samples(0);
  for (int pass = 1; pass < reference_passes; ++pass) {
    EXPECT_EQ(reference_samples(pass), total) << "pass " << pass;
    total += reference_samples(pass);
  }
  const auto jobs = make_jobs(small_plan());
  std::set<int> seeds;
  for (const Job& job : *jobs)
    if (job.kind == JobKind::reference && job.scene == "builtin:boxes") {
      EXPECT_TRUE(seeds.insert(job.rung.settings.seed).second) << job.title();
    }
  for (const Job& job : *jobs)
    if (job.kind == JobKind::point) {
      EXPECT_EQ(seeds.count(job.rung.settings.seed), 0u);
    }
}

TEST(Plan, ThePapersCasesBringTheirOwnScenesAndSettings) {
  StudyPlan plan;
  plan.paper = true;
  const auto jobs = make_jobs(plan);
  ASSERT_TRUE(jobs);
  std::set<std::string> points;
  for (const Job& job : *jobs)
    if (job.kind == JobKind::point && job.scene == "builtin:office")
      points.insert(job.rung.method + " " + job.rung.setting);
  for (const char* expected : {"asos MAX 2 EPS 1/8", "asos-published MAX 4 EPS 1/8",
                               "stochastic 16 spp", "stochastic 64 spp"})
    EXPECT_EQ(points.count(expected), 1u) << expected;
  EXPECT_EQ(points.count("sobol 16 spp"), 0u);
}

TEST(Plan, RefusesWhatMakesNoSense) {
  StudyPlan plan = small_plan();
  plan.methods = {"asos", "magic"};
  const auto unknown = make_jobs(plan);
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message().find("magic"), std::string::npos);
  EXPECT_NE(unknown.error().message().find("stochastic"), std::string::npos) << "lists the known";
  EXPECT_FALSE(make_jobs(StudyPlan{})) << "no scene";
  plan = small_plan();
  plan.scenes.push_back("builtin:boxes");
  EXPECT_FALSE(make_jobs(plan)) << "twice the same scene";
  plan = small_plan();
  plan.width = 0;
  EXPECT_FALSE(make_jobs(plan));
  plan = small_plan();
  plan.budget_seconds = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(make_jobs(plan));
}

TEST(EpsText, IsAFractionWhereItCanBe) {
  EXPECT_EQ(eps_text(0.0), "0");
  EXPECT_EQ(eps_text(1.0 / 256.0), "1/256");
  EXPECT_EQ(eps_text(0.125), "1/8");
  EXPECT_EQ(eps_text(0.3), "0.3");
}

class RenderedBoxes : public testing::Test {
 protected:
  void SetUp() override {
    const auto scene = load_scene("builtin:boxes");
    ASSERT_TRUE(scene);
    const auto ready = prepare(*scene);
    ASSERT_TRUE(ready);
    snapshot_.scene = *ready;
    snapshot_.camera = test::first_camera((*ready)->world, 16.0 / 12.0);
    snapshot_.settings.width = 16;
    snapshot_.settings.height = 12;
    snapshot_.settings.threads = 2;
  }
  Snapshot snapshot_;
};

TEST_F(RenderedBoxes, ATimedRenderIsTheSamePicture) {
  const auto timed = timed_render(snapshot_);
  ASSERT_TRUE(timed);
  const RenderResult plain = render_to_end(snapshot_);
  EXPECT_EQ(timed->film.radiance, plain.film.radiance);
  EXPECT_EQ(rays_of(timed->statistics), rays_of(plain.statistics));
  EXPECT_GT(pyrays_of(timed->statistics), 0u);
}

TEST_F(RenderedBoxes, AStopEndsARender) {
  snapshot_.settings.method = Method::sobol;
  snapshot_.settings.spp = 65536;
  snapshot_.settings.width = 320;
  snapshot_.settings.height = 240;
  EXPECT_FALSE(timed_render(snapshot_, [] { return true; }));
}

TEST_F(RenderedBoxes, RegionsFollowWhatSplitsThePixel) {
  snapshot_.settings = region_settings(snapshot_.settings);
  const RenderResult result = render_to_end(snapshot_);
  const RegionMap map = find_regions(snapshot_, result.film);
  ASSERT_EQ(map.region.size(), 16u * 12u);
  std::size_t outlines = 0;
  for (std::size_t i = 0; i < map.region.size(); ++i) {
    if (result.film.cause[i] == SplitCause::outline) {
      EXPECT_EQ(map.region[i], Region::outlines) << "pixel " << i;
      ++outlines;
    }
    if (result.film.cause[i] == SplitCause::shadow) {
      EXPECT_EQ(map.region[i], Region::penumbrae) << "pixel " << i;
    }
  }
  EXPECT_GT(outlines, 0u);
  EXPECT_LT(outlines, map.region.size());
}

}  // namespace
}  // namespace asos
