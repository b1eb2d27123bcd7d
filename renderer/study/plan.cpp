#include "renderer/study/plan.h"

#include "renderer/shading/sky.h"
#include "renderer/study/paper_cases.h"
#include "renderer/study/regions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asos {
namespace {

// The seeds of the reference's two halves; all renders use smaller ones.
constexpr std::array half_seeds{1'000'003, 1'500'007};

RenderSettings base_settings(const StudyPlan& plan, const StudyLook& look) {
  RenderSettings base;
  base.width = plan.width;
  base.height = plan.height;
  base.threads = plan.threads;
  base.sky = look.opened_sky;
  base.mirror.bounces = look.reflections;
  base.mirror.roughest = look.roughest_mirror;
  base.mirror.dfr = look.dfr;
  return base;
}

std::string dfr_text(const Dfr& dfr) {
  std::string text = " DFR";
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0 && dfr.rgb[i] == dfr.rgb[0]) continue;
    text += fmt::format(" {},{},{}", dfr.rgb[i].min, dfr.rgb[i].max, dfr.rgb[i].exponent);
  }
  return text;
}

using Ladders = std::vector<std::vector<LadderStep>>;

void add_rung(Ladders& ladders, LadderStep rung) {
  const auto same = [&](const LadderStep& r) {
    return r.method == rung.method && r.setting == rung.setting;
  };
  for (const auto& ladder : ladders)
    if (std::any_of(ladder.begin(), ladder.end(), same)) return;
  for (auto& ladder : ladders) {
    if (ladder.front().method != rung.method) continue;
    ladder.push_back(std::move(rung));
    return;
  }
  ladders.push_back({std::move(rung)});
}

// The scene of the papers' argument against methods that record only fractions of a pixel, and the
// methods that are compared in it.
const StudyScene& argument_scene() {
  static const StudyScene scene{"builtin:cards", {}};
  return scene;
}
constexpr std::array argument_methods{"asos", "sobol", "cone", "covers", "mask"};

void add_argument_rungs(Ladders& ladders, const RenderSettings& base) {
  for (const char* method : argument_methods) {
    auto ladder = ladder_of(method, base);
    if (!ladder) continue;
    for (LadderStep& rung : *ladder) add_rung(ladders, std::move(rung));
  }
}

void add_paper_rungs(Ladders& ladders, const StudyScene& scene, const RenderSettings& base) {
  if (scene == argument_scene()) return add_argument_rungs(ladders, base);
  bool any = false;
  for (const PaperCase& row : paper_cases) {
    if (!(scene == scene_of(row))) continue;
    any = true;
    for (const char* method : {"asos", "asos-published"})
      add_rung(ladders, asos_rung(row, method, base));
    if (row.rival_spp > 0) add_rung(ladders, sampling_rung("stochastic", base, row.rival_spp));
  }
  if (!any) return;
  // The rival's whole ladder, since its time at equal error needs several settings.
  for (const int spp : {1, 4, 16, 64, 256})
    add_rung(ladders, sampling_rung("stochastic", base, spp));
}

/// Returns the plan's own scenes, each in the plan's look.
std::vector<StudyScene> own_scenes(const StudyPlan& plan) {
  std::vector<StudyScene> scenes;
  for (const std::string& source : plan.scenes) scenes.push_back({source, plan.look});
  return scenes;
}

bool contains(const std::vector<StudyScene>& scenes, const StudyScene& scene) {
  return std::find(scenes.begin(), scenes.end(), scene) != scenes.end();
}

std::vector<std::string> methods_of(const StudyPlan& plan) {
  return plan.methods.empty() ? default_methods() : plan.methods;
}

Result<Ladders> ladders_of(const StudyPlan& plan, const StudyScene& scene) {
  RenderSettings base = base_settings(plan, scene.look);
  Ladders ladders;
  if (contains(own_scenes(plan), scene)) {
    base.texture.resolution = plan.texture_resolution;
    for (const std::string& method : methods_of(plan)) {
      auto ladder = ladder_of(method, base);
      if (!ladder) return unexpected(ladder.error());
      ladders.push_back(*std::move(ladder));
    }
  }
  if (plan.paper) add_paper_rungs(ladders, scene, base);
  return ladders;
}

Job job_of(JobKind kind, const StudyScene& scene) {
  Job job;
  job.kind = kind;
  job.scene = scene.name();
  job.subject = scene;
  return job;
}

Job regions_job(const StudyPlan& plan, const StudyScene& scene) {
  Job job = job_of(JobKind::regions, scene);
  job.rung = {"asos", "regions", "", region_settings(base_settings(plan, scene.look))};
  return job;
}

Job reference_job(const StudyPlan& plan, const StudyScene& scene, int pass, int half) {
  Job job = job_of(JobKind::reference, scene);
  job.pass = pass;
  job.half = half;
  job.rung = sampling_rung("sobol", base_settings(plan, scene.look), reference_samples(pass));
  // Each half and pass has its own samples. Textures are sampled at points, so that only the
  // pixel's own filter averages.
  job.rung.settings.seed = half_seeds[static_cast<std::size_t>(half)] + pass;
  job.rung.settings.texture.filter = TextureFilter::point;
  return job;
}

void add_points(std::vector<Job>& jobs, const Ladders& ladders, const StudyScene& scene,
                int repetition) {
  std::size_t longest = 0;
  for (const auto& ladder : ladders) longest = std::max(longest, ladder.size());
  for (std::size_t step = 0; step < longest; ++step) {
    for (const auto& ladder : ladders) {
      if (step >= ladder.size()) continue;
      Job job = job_of(JobKind::point, scene);
      job.rung = ladder[step];
      job.repetition = repetition;
      jobs.push_back(std::move(job));
    }
  }
}

Result<void> add_progress(std::vector<Job>& jobs, const StudyPlan& plan, const StudyScene& scene) {
  if (!contains(own_scenes(plan), scene)) return {};
  RenderSettings base = base_settings(plan, scene.look);
  base.texture.resolution = plan.texture_resolution;
  for (const std::string& method : methods_of(plan)) {
    auto rung = watched_rung(method, base);
    if (!rung) return unexpected(rung.error());
    Job job = job_of(JobKind::progress, scene);
    job.rung = *std::move(rung);
    job.repetition = 1;
    jobs.push_back(std::move(job));
  }
  return {};
}

Result<void> check(const StudyPlan& plan) {
  if (scenes_of(plan).empty()) return unexpected(Error{"SCENE", "the study has no scene"});
  if (plan.repetitions < 1 || plan.repetitions > 99)
    return unexpected(
        Error{"repetitions", fmt::format("{} is not from 1 to 99", plan.repetitions)});
  if (!(plan.budget_seconds > 0.0 && std::isfinite(plan.budget_seconds)))
    return unexpected(Error{"budget", fmt::format("{} s is not above 0", plan.budget_seconds)});
  if (!(plan.longest_seconds > 0.0 && std::isfinite(plan.longest_seconds)))
    return unexpected(Error{"longest", fmt::format("{} s is not above 0", plan.longest_seconds)});
  for (std::size_t i = 0; i < plan.scenes.size(); ++i)
    if (std::count(plan.scenes.begin(), plan.scenes.end(), plan.scenes[i]) > 1)
      return unexpected(Error{plan.scenes[i], "the scene is named twice"});
  for (std::size_t i = 0; i < plan.methods.size(); ++i)
    if (std::count(plan.methods.begin(), plan.methods.end(), plan.methods[i]) > 1)
      return unexpected(Error{plan.methods[i], "the method is named twice"});
  RenderSettings asked = base_settings(plan, plan.look);
  asked.texture.resolution = plan.texture_resolution;
  const auto settings = validated(asked);
  if (!settings) return unexpected(settings.error());
  return {};
}

}  // namespace

StudyLook look_of(const RenderSettings& settings) {
  StudyLook look;
  if (settings.sky) look.sky = settings.sky->name();
  look.opened_sky = settings.sky;
  look.reflections = settings.mirror.bounces;
  look.roughest_mirror = settings.mirror.roughest;
  look.dfr = settings.mirror.dfr;
  return look;
}

std::string StudyScene::name() const {
  const StudyLook usual;
  std::string text;
  const StudyCamera& camera = look.camera;
  if (camera.index) text += fmt::format(" camera {}", *camera.index);
  if (camera.look_at) text += fmt::format(" look-at {}", fmt::join(*camera.look_at, ","));
  if (camera.fov_y_deg) text += fmt::format(" fov {}", *camera.fov_y_deg);
  if (look.moment) text += fmt::format(" at {} s", look.moment->seconds);
  if (look.moment && look.moment->animation) text += " of " + *look.moment->animation;
  if (look.sky != usual.sky) text += " sky " + look.sky;
  if (look.reflections != usual.reflections) text += fmt::format(" bounces {}", look.reflections);
  if (look.roughest_mirror != usual.roughest_mirror)
    text += fmt::format(" mirrors to {}", look.roughest_mirror);
  if (look.dfr) text += dfr_text(*look.dfr);
  return source + text;
}

std::string Job::title() const {
  switch (kind) {
    case JobKind::regions:
      return fmt::format("{} regions", scene);
    case JobKind::progress:
      return fmt::format("{} {} {} while rendering", scene, rung.method, rung.setting);
    case JobKind::reference:
      return fmt::format("{} reference pass {} half {} ({} spp)", scene, pass + 1,
                         half == 0 ? "a" : "b", rung.settings.sampling.spp);
    case JobKind::point:
      break;
  }
  return fmt::format("{} {} {} repetition {}", scene, rung.method, rung.setting, repetition);
}

int reference_samples(int pass) {
  return 64 << std::max(0, pass - 1);
}

std::vector<StudyScene> scenes_of(const StudyPlan& plan) {
  std::vector<StudyScene> scenes = own_scenes(plan);
  if (!plan.paper) return scenes;
  for (const PaperCase& row : paper_cases)
    if (const StudyScene scene = scene_of(row); !contains(scenes, scene)) scenes.push_back(scene);
  if (!contains(scenes, argument_scene())) scenes.push_back(argument_scene());
  return scenes;
}

Result<std::vector<Job>> make_jobs(const StudyPlan& plan) {
  if (const auto sound = check(plan); !sound) return unexpected(sound.error());
  std::vector<Job> jobs;
  for (const StudyScene& scene : scenes_of(plan)) {
    const auto ladders = ladders_of(plan, scene);
    if (!ladders) return unexpected(ladders.error());
    jobs.push_back(regions_job(plan, scene));
    for (int repetition = 1; repetition <= plan.repetitions; ++repetition)
      add_points(jobs, *ladders, scene, repetition);
    if (const auto added = add_progress(jobs, plan, scene); !added)
      return unexpected(added.error());
    for (int pass = 0; pass < reference_passes; ++pass)
      for (const int half : {0, 1}) jobs.push_back(reference_job(plan, scene, pass, half));
  }
  for (std::size_t i = 0; i < jobs.size(); ++i) jobs[i].id = i;
  return jobs;
}

}  // namespace asos
