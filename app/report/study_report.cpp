#include "app/report/study_report.h"

#include "renderer/film/image_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace asos {
namespace {

const JobRecord* record_of(const JobRecords& jobs, const Job& job) {
  const auto at =
      std::lower_bound(jobs.records.begin(), jobs.records.end(), job.id,
                       [](const JobRecord& record, std::size_t id) { return record.job.id < id; });
  return at != jobs.records.end() && at->job.id == job.id ? &*at : nullptr;
}

Result<Film> film_of(const JobRecord& record, const std::string& ending = ".exr") {
  const std::string path = job_file(record.folder, record.job.id, ending);
  auto image = read_exr(path);
  if (!image) return tl::unexpected(image.error());
  const RenderSettings& settings = record.job.rung.settings;
  if (image->film.width != settings.width || image->film.height != settings.height)
    return tl::unexpected(Error{path, "is not of the size that its study has"});
  return std::move(image->film);
}

Result<void> check_complete(const JobRecords& jobs) {
  std::size_t missing = 0;
  const Job* first = nullptr;
  for (const Job& job : jobs.jobs) {
    if (job.kind == JobKind::reference && job.pass > 0) continue;
    const JobRecord* record = record_of(jobs, job);
    if (record && (record->finished || may_be_given_up(job.kind))) continue;
    if (missing++ == 0) first = &job;
  }
  if (missing == 0) return {};
  return tl::unexpected(
      Error{fmt::format("job {} ({})", first->id, first->title()),
            fmt::format("has not been run, {} of {} jobs are missing", missing, jobs.jobs.size())});
}

/// The first repetition of each finished setting of a scene.
std::vector<const JobRecord*> first_repetitions(const JobRecords& jobs, const std::string& scene) {
  std::vector<const JobRecord*> found;
  for (const JobRecord& record : jobs.records)
    if (record.job.kind == JobKind::point && record.job.repetition == 1 && record.finished &&
        record.job.scene == scene)
      found.push_back(&record);
  return found;
}

std::vector<std::string> timed_out(const JobRecords& jobs, const std::string& scene) {
  std::vector<std::string> settings;
  for (const JobRecord& record : jobs.records)
    if (record.job.kind == JobKind::point && record.job.repetition == 1 && !record.finished &&
        record.job.scene == scene)
      settings.push_back(record.job.rung.method + " " + record.job.rung.setting);
  return settings;
}

/// Decides whether the reference is quiet enough for the errors of the points.
Result<void> judge(const std::vector<const JobRecord*>& points, ScenesReference& made) {
  const Film reference = made.reference.film();
  const double noise = made.reference.noise();
  double smallest = std::numeric_limits<double>::infinity();
  NoiseFloorCount found;
  for (const JobRecord* point : points) {
    const Result<Film> film = film_of(*point);
    if (!film) return tl::unexpected(film.error());
    const double error = root_mean_square(*film, reference, true);
    smallest = std::min(smallest, error);
    if (point->job.rung.method != "asos") continue;
    ++found.settings;
    found.under_floor += error < floor_of(noise);
  }
  made.quiet = quiet_enough(noise, smallest);
  made.comparable = !found.too_many();
  return {};
}

/// Adds one pass; returns false if it is missing or unfinished.
Result<bool> add_pass(const JobRecords& jobs, const std::string& scene, int pass,
                      Reference& reference) {
  std::vector<Film> halves;
  for (const Job& job : jobs.jobs) {
    if (job.kind != JobKind::reference || job.scene != scene || job.pass != pass) continue;
    const JobRecord* record = record_of(jobs, job);
    if (!record || !record->finished) return false;
    Result<Film> film = film_of(*record);
    if (!film) return tl::unexpected(film.error());
    halves.push_back(*std::move(film));
  }
  reference.add(halves[0], halves[1], reference_samples(pass));
  return true;
}

/// Fills in a setting's results except its error.
StudyPoint point_of(const JobRecords& jobs, const JobRecord& first) {
  StudyPoint point;
  point.rung = first.job.rung;
  point.rays = first.rays;
  point.pyrays = first.pyrays;
  point.rejected_samples = first.rejected_samples;
  for (const JobRecord& record : jobs.records) {
    const Job& job = record.job;
    if (job.kind != JobKind::point || !record.finished || job.scene != first.job.scene ||
        job.rung.method != point.rung.method || job.rung.setting != point.rung.setting)
      continue;
    point.costs.push_back(record.cost);
    if (record.picture_hash != first.picture_hash) point.same_picture = false;
  }
  return point;
}

Result<void> add_regions(const JobRecords& jobs, SceneReport& scene) {
  for (const JobRecord& record : jobs.records) {
    if (record.job.kind != JobKind::regions || record.job.scene != scene.study.scene) continue;
    auto map = read_regions(job_file(record.folder, record.job.id, ".png"));
    if (!map) return tl::unexpected(map.error());
    if (map->width != scene.reference.width || map->height != scene.reference.height)
      return tl::unexpected(Error{job_file(record.folder, record.job.id, ".png"),
                                  "is not of the size that its study has"});
    scene.regions = *std::move(map);
    scene.facts = record.scene;
  }
  for (const Region region : scene.regions.region)
    ++scene.region_pixels[static_cast<std::size_t>(region)];
  return {};
}

/// Computes the errors of the watched renders.
Result<void> add_while_rendering(const JobRecords& jobs, SceneReport& scene) {
  for (const JobRecord& record : jobs.records) {
    if (record.job.kind != JobKind::progress || record.job.scene != scene.study.scene) continue;
    const LadderStep& rung = record.job.rung;
    RenderCurve curve{rung.method, rung.setting, record.finished, {}};
    for (const double seconds : record.moments) {
      const Result<Film> film = film_of(record, moment_ending(curve.points.size()));
      if (!film) return tl::unexpected(film.error());
      curve.points.push_back({seconds, root_mean_square(*film, scene.reference, true)});
    }
    if (!curve.points.empty()) scene.study.while_rendering.push_back(std::move(curve));
  }
  return {};
}

Result<SceneReport> assemble_scene(const JobRecords& jobs, const std::string& name) {
  SceneReport scene;
  scene.study.scene = name;
  const auto made = reference_of(jobs, name);
  if (!made) return tl::unexpected(made.error());
  scene.reference = made->reference.film();
  scene.passes = made->reference.passes();
  scene.samples = made->reference.samples();
  scene.quiet = made->quiet;
  scene.study.noise = made->reference.noise();
  scene.timed_out = timed_out(jobs, name);
  if (const auto added = add_regions(jobs, scene); !added) return tl::unexpected(added.error());

  // Group by method, whatever the order of the jobs
  std::vector<const JobRecord*> points = first_repetitions(jobs, name);
  std::vector<std::string> methods;
  for (const JobRecord* p : points)
    if (std::find(methods.begin(), methods.end(), p->job.rung.method) == methods.end())
      methods.push_back(p->job.rung.method);
  const auto place = [&](const JobRecord* p) {
    return std::find(methods.begin(), methods.end(), p->job.rung.method) - methods.begin();
  };
  std::stable_sort(points.begin(), points.end(),
                   [&](const JobRecord* a, const JobRecord* b) { return place(a) < place(b); });
  for (const JobRecord* first : points) {
    const Result<Film> film = film_of(*first);
    if (!film) return tl::unexpected(film.error());
    StudyPoint point = point_of(jobs, *first);
    point.measures = measure(*film, scene.reference);
    point.regions = region_errors(*film, scene.reference, scene.regions.region);
    scene.study.points.push_back(std::move(point));
    scene.pictures.push_back(job_file(first->folder, first->job.id, ".exr"));
  }
  if (const auto added = add_while_rendering(jobs, scene); !added)
    return tl::unexpected(added.error());
  analyse(scene.study);
  return scene;
}

}  // namespace

Result<ScenesReference> reference_of(const JobRecords& jobs, const std::string& scene) {
  const auto points = first_repetitions(jobs, scene);
  ScenesReference made;
  for (int pass = 0; pass < reference_passes && !made.quiet; ++pass) {
    const auto added = add_pass(jobs, scene, pass, made.reference);
    if (!added) return tl::unexpected(added.error());
    if (!*added) break;
    if (const auto judged = judge(points, made); !judged) return tl::unexpected(judged.error());
  }
  if (made.reference.passes() == 0)
    return tl::unexpected(Error{scene, "the first pass of its reference has not been run"});
  return made;
}

Result<StudyReport> assemble(const JobRecords& jobs) {
  if (const auto complete = check_complete(jobs); !complete)
    return tl::unexpected(complete.error());
  StudyReport report;
  report.plan = jobs.plan;
  for (const JobRecord& record : jobs.records) {
    if (std::find(report.machines.begin(), report.machines.end(), record.machine) ==
        report.machines.end())
      report.machines.push_back(record.machine);
    if (report.first.empty() || record.when < report.first) report.first = record.when;
    report.last = std::max(report.last, record.when);
  }
  for (const StudyScene& place : scenes_of(jobs.plan)) {
    auto scene = assemble_scene(jobs, place.name());
    if (!scene) return tl::unexpected(scene.error());
    report.scenes.push_back(*std::move(scene));
  }
  return report;
}

}  // namespace asos
