#include "renderer/study/plan.h"

#include "renderer/gltf/load.h"
#include "renderer/shading/sky.h"
#include "renderer/study/paper_cases.h"
#include "renderer/study/regions.h"
#include "renderer/study/timed_render.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>

namespace asos {
namespace {

StudyPlan small_plan() {
  return {.scenes = {"builtin:boxes", "builtin:fence"}, .width = 16, .height = 12};
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
    // The first step of every method comes before the second step of any.
    if (met.size() < default_methods().size()) {
      EXPECT_TRUE(met.insert(job.rung.method).second) << job.title();
    }
  }
  EXPECT_EQ(last, 3);
}

TEST(Plan, WatchesOneRenderOfEachMethodAfterTheSettings) {
  StudyPlan plan = small_plan();
  plan.methods = {"asos", "sobol", "mitchell", "whitted"};
  plan.texture_resolution = 2;
  plan.paper = true;
  const auto jobs = make_jobs(plan);
  ASSERT_TRUE(jobs);
  std::vector<std::string> watched;
  bool reference = false;
  for (const Job& job : *jobs) {
    if (job.scene != "builtin:boxes") {
      EXPECT_TRUE(job.kind != JobKind::progress || job.scene == "builtin:fence")
          << "a published case: " << job.title();
      continue;
    }
    reference = reference || job.kind == JobKind::reference;
    if (job.kind == JobKind::point) {
      EXPECT_TRUE(watched.empty()) << job.title();
    }
    if (job.kind != JobKind::progress) continue;
    EXPECT_FALSE(reference) << job.title();
    watched.push_back(job.title());
    if (job.rung.method != "asos") continue;
    EXPECT_EQ(job.rung.settings.asos, AsosSettings{});
    EXPECT_EQ(job.rung.settings.texture.resolution, 2);
  }
  EXPECT_EQ(watched, (std::vector<std::string>{
                         "builtin:boxes asos MAX 4 EPS 1/256 TR 2 while rendering",
                         "builtin:boxes sobol 256 spp while rendering",
                         "builtin:boxes mitchell 256 spp while rendering",
                         "builtin:boxes whitted contrast 0.0125 depth 5 spheres while rendering"}));
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
  StudyPlan plan{.paper = true};
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
  std::set<std::string> argued;
  for (const Job& job : *jobs)
    if (job.kind == JobKind::point && job.scene == "builtin:cards") argued.insert(job.rung.method);
  EXPECT_EQ(argued, (std::set<std::string>{"asos", "cone", "covers", "mask", "sobol"}));
}

TEST(Plan, EveryPublishedCaseIsMeasuredOnATruePictureOfItsOwn) {
  StudyPlan plan{.paper = true};
  const auto jobs = make_jobs(plan);
  ASSERT_TRUE(jobs);
  const auto settings_of = [&](const std::string& scene, const std::string& method,
                               const std::string& setting) -> std::optional<RenderSettings> {
    for (const Job& job : *jobs)
      if (job.scene == scene && job.rung.method == method && job.rung.setting == setting)
        return job.rung.settings;
    ADD_FAILURE() << scene << " " << method << " " << setting << " is no job";
    return std::nullopt;
  };
  for (const PaperCase& row : paper_cases) {
    const StudyScene scene = scene_of(row);
    for (const char* method : {"asos", "asos-published"}) {
      const LadderStep rung = asos_rung(row, method, {});
      const auto settings = settings_of(scene.name(), method, rung.setting);
      ASSERT_TRUE(settings);
      EXPECT_EQ(settings->asos.max_level, row.max_level);
      EXPECT_EQ(settings->asos.eps, row.eps);
      EXPECT_EQ(settings->texture.resolution, row.texture_resolution);
      EXPECT_EQ(settings->mirror.dfr, scene.look.dfr);
      EXPECT_EQ(settings->mirror.bounces, scene.look.reflections);
    }
  }
  const auto blurred = settings_of("builtin:house-mirror DFR 0.05,1,32", "stochastic", "16 spp");
  ASSERT_TRUE(blurred && blurred->mirror.dfr) << "the rival reflects like ASOS";
  EXPECT_EQ(blurred->mirror.dfr->rgb[2], (DfrCurve{0.05, 1.0, 32.0}));
  EXPECT_EQ(settings_of("builtin:solids bounces 6", "stochastic", "64 spp")->mirror.bounces, 6);
  EXPECT_EQ(settings_of("builtin:house-textured", "asos", "MAX 2 EPS 0 TR 4")->texture.resolution,
            4);
  EXPECT_EQ(scenes_of(plan).size(), 8u) << "seven true pictures of cases, and the cards";
  for (const Job& job : *jobs)
    if (job.kind == JobKind::reference && job.scene == "builtin:house-mirror DFR 0.05,1,64") {
      EXPECT_EQ(job.rung.settings.mirror.dfr->rgb[0].exponent, 64.0) << job.title();
    }
}

TEST(Plan, ALookIsThatOfAllMethodsAndOfTheReference) {
  StudyPlan plan = small_plan();
  plan.look.reflections = 1;
  plan.look.opened_sky = std::make_shared<const Sky>(glm::vec3(1.0f, 0.5f, 0.25f));
  plan.look.sky = plan.look.opened_sky->name();
  plan.look.camera.fov_y_deg = 30.0;
  plan.texture_resolution = 2;
  plan.paper = true;
  const auto jobs = make_jobs(plan);
  ASSERT_TRUE(jobs) << jobs.error().message();
  std::size_t own = 0;
  for (const Job& job : *jobs) {
    if (!job.scene.starts_with("builtin:boxes")) continue;
    ++own;
    EXPECT_EQ(job.scene, "builtin:boxes fov 30 sky 1,0.5,0.25 bounces 1");
    EXPECT_EQ(job.subject.source, "builtin:boxes");
    EXPECT_EQ(job.rung.settings.mirror.bounces, 1) << job.title();
    EXPECT_EQ(job.rung.settings.sky, plan.look.opened_sky) << job.title();
    if (job.rung.method == "asos" && job.kind == JobKind::point) {
      EXPECT_TRUE(job.rung.setting.ends_with(" TR 2")) << job.title();
      EXPECT_EQ(job.rung.settings.texture.resolution, 2) << job.title();
    }
  }
  EXPECT_GT(own, 0u);
  for (const Job& job : *jobs)
    if (job.scene == "builtin:office") {
      EXPECT_EQ(job.rung.settings.sky, nullptr) << "a published case has a look of its own";
    }
  plan.texture_resolution = 9;
  EXPECT_FALSE(make_jobs(plan));
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

class RenderedScene : public testing::Test {
 protected:
  void open(const char* name) {
    const auto scene = load_scene(name);
    ASSERT_TRUE(scene);
    const auto ready = prepare(*scene);
    ASSERT_TRUE(ready);
    snapshot_.scene = *ready;
    snapshot_.camera = test::first_camera((*ready)->world(), 16.0 / 12.0);
    snapshot_.settings.width = 16;
    snapshot_.settings.height = 12;
    snapshot_.settings.threads = 2;
  }

  /// Number of pixels of a cause in a region.
  static std::size_t count(const RegionMap& map, SplitCause cause, Region region) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < map.region.size(); ++i)
      n += map.cause[i] == cause && map.region[i] == region ? 1 : 0;
    return n;
  }

  Snapshot snapshot_;
};

class RenderedBoxes : public RenderedScene {
 protected:
  void SetUp() override { open("builtin:boxes"); }
};

// The house stands on a mirror: pixels split there by reflected edges belong to the mirror, as do
// those without an edge. Without bounces there is no mirror.
TEST_F(RenderedScene, MirrorsAreARegionOfTheirOwn) {
  open("builtin:house-mirror");
  snapshot_.settings = region_settings(snapshot_.settings);
  const RegionMap map = find_regions(snapshot_, render_to_end(snapshot_).film);
  const std::size_t split = count(map, SplitCause::reflection, Region::reflections);
  EXPECT_GT(split, 5u);
  for (const Region other : {Region::outlines, Region::penumbrae, Region::textures, Region::rest})
    EXPECT_EQ(count(map, SplitCause::reflection, other), 0u);
  EXPECT_GT(count(map, SplitCause::none, Region::reflections), 5u);
  EXPECT_GT(count(map, SplitCause::outline, Region::outlines), 5u);

  snapshot_.settings.mirror.bounces = 0;
  const RegionMap dull = find_regions(snapshot_, render_to_end(snapshot_).film);
  for (const Region region : dull.region) EXPECT_NE(region, Region::reflections);
}

TEST_F(RenderedScene, TexturesAreARegionOfTheirOwn) {
  open("builtin:house-textured");
  snapshot_.settings = region_settings(snapshot_.settings);
  const RegionMap map = find_regions(snapshot_, render_to_end(snapshot_).film);
  EXPECT_GT(std::count(map.region.begin(), map.region.end(), Region::textures), 20);
}

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
  snapshot_.settings.sampling.spp = 65536;
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
