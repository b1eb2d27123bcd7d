#include "renderer/study/plan.h"

#include "renderer/study/paper_cases.h"
#include "renderer/study/regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asos {
namespace {

// Of the reference's two halves; any render asks for smaller ones.
constexpr std::array half_seeds{1'000'003, 1'500'007};

RenderSettings base_settings(const StudyPlan& plan) {
  RenderSettings base;
  base.width = plan.width;
  base.height = plan.height;
  base.threads = plan.threads;
  return base;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

using Ladders = std::vector<std::vector<Rung>>;

void add_rung(Ladders& ladders, Rung rung) {
  const auto same = [&](const Rung& r) {
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

void add_paper_rungs(Ladders& ladders, const std::string& scene, const RenderSettings& base) {
  for (const PaperCase& row : paper_cases) {
    if (scene != row.scene) continue;
    add_rung(ladders, asos_rung("asos", base, row.max_level, row.eps));
    add_rung(ladders, asos_rung("asos-published", base, row.max_level, row.eps));
    if (row.rival_spp > 0) add_rung(ladders, sampling_rung("stochastic", base, row.rival_spp));
  }
  if (scene == plain_house) {
    add_rung(ladders, asos_rung("asos", base, 2, 0.0));
    add_rung(ladders, asos_rung("asos-published", base, 2, 0.0));
  }
  // All of the rival's ladder: its time at equal error cannot be told from one setting.
  for (const int spp : {1, 4, 16, 64, 256})
    add_rung(ladders, sampling_rung("stochastic", base, spp));
}

Result<Ladders> ladders_of(const StudyPlan& plan, const std::string& scene) {
  const RenderSettings base = base_settings(plan);
  Ladders ladders;
  if (contains(plan.scenes, scene)) {
    for (const std::string& method : plan.methods.empty() ? default_methods() : plan.methods) {
      auto ladder = ladder_of(method, base);
      if (!ladder) return unexpected(ladder.error());
      ladders.push_back(*std::move(ladder));
    }
  }
  if (plan.paper) add_paper_rungs(ladders, scene, base);
  return ladders;
}

Job regions_job(const StudyPlan& plan, const std::string& scene) {
  Job job;
  job.kind = JobKind::regions;
  job.scene = scene;
  job.rung = {"asos", "regions", "", region_settings(base_settings(plan))};
  return job;
}

Job reference_job(const StudyPlan& plan, const std::string& scene, int pass, int half) {
  Job job;
  job.kind = JobKind::reference;
  job.scene = scene;
  job.pass = pass;
  job.half = half;
  job.rung = sampling_rung("sobol", base_settings(plan), reference_samples(pass));
  // Points of their own for each half and pass; every sample looked up as a point, so that nothing
  // but the pixel's own filter is averaged.
  job.rung.settings.seed = half_seeds[static_cast<std::size_t>(half)] + pass;
  job.rung.settings.texture_filter = TextureFilter::point;
  return job;
}

void add_points(std::vector<Job>& jobs, const Ladders& ladders, const std::string& scene,
                int repetition) {
  std::size_t longest = 0;
  for (const auto& ladder : ladders) longest = std::max(longest, ladder.size());
  for (std::size_t step = 0; step < longest; ++step) {
    for (const auto& ladder : ladders) {
      if (step >= ladder.size()) continue;
      Job job;
      job.scene = scene;
      job.rung = ladder[step];
      job.repetition = repetition;
      jobs.push_back(std::move(job));
    }
  }
}

Result<void> check(const StudyPlan& plan) {
  if (scenes_of(plan).empty()) return unexpected(Error{"SCENE", "the study has no scene"});
  if (plan.repetitions < 1 || plan.repetitions > 99)
    return unexpected(
        Error{"repetitions", fmt::format("{} is not from 1 to 99", plan.repetitions)});
  if (!(plan.budget_seconds > 0.0 && std::isfinite(plan.budget_seconds)))
    return unexpected(Error{"budget", fmt::format("{} s is not above 0", plan.budget_seconds)});
  for (std::size_t i = 0; i < plan.scenes.size(); ++i)
    if (std::count(plan.scenes.begin(), plan.scenes.end(), plan.scenes[i]) > 1)
      return unexpected(Error{plan.scenes[i], "the scene is named twice"});
  for (std::size_t i = 0; i < plan.methods.size(); ++i)
    if (std::count(plan.methods.begin(), plan.methods.end(), plan.methods[i]) > 1)
      return unexpected(Error{plan.methods[i], "the method is named twice"});
  const auto settings = validated(base_settings(plan));
  if (!settings) return unexpected(settings.error());
  return {};
}

}  // namespace

std::string Job::title() const {
  switch (kind) {
    case JobKind::regions:
      return fmt::format("{} regions", scene);
    case JobKind::reference:
      return fmt::format("{} reference pass {} half {} ({} spp)", scene, pass + 1,
                         half == 0 ? "a" : "b", rung.settings.spp);
    case JobKind::point:
      break;
  }
  return fmt::format("{} {} {} repetition {}", scene, rung.method, rung.setting, repetition);
}

int reference_samples(int pass) {
  return 64 << std::max(0, pass - 1);
}

std::vector<std::string> scenes_of(const StudyPlan& plan) {
  std::vector<std::string> scenes = plan.scenes;
  if (!plan.paper) return scenes;
  for (const PaperCase& row : paper_cases)
    if (row.scene[0] != '\0' && !contains(scenes, row.scene)) scenes.emplace_back(row.scene);
  if (!contains(scenes, plain_house)) scenes.emplace_back(plain_house);
  return scenes;
}

Result<std::vector<Job>> make_jobs(const StudyPlan& plan) {
  if (const auto sound = check(plan); !sound) return unexpected(sound.error());
  std::vector<Job> jobs;
  for (const std::string& scene : scenes_of(plan)) {
    const auto ladders = ladders_of(plan, scene);
    if (!ladders) return unexpected(ladders.error());
    jobs.push_back(regions_job(plan, scene));
    for (int repetition = 1; repetition <= plan.repetitions; ++repetition)
      add_points(jobs, *ladders, scene, repetition);
    for (int pass = 0; pass < reference_passes; ++pass)
      for (const int half : {0, 1}) jobs.push_back(reference_job(plan, scene, pass, half));
  }
  for (std::size_t i = 0; i < jobs.size(); ++i) jobs[i].id = i;
  return jobs;
}

}  // namespace asos
