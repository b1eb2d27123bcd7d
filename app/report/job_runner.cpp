#include "app/report/job_runner.h"

#include "app/camera_choice.h"
#include "app/interrupt.h"
#include "app/opened_scene.h"
#include "renderer/comparison/method.h"
#include "renderer/film/image_io.h"
#include "renderer/sampling/random.h"
#include "renderer/study/progress_curve.h"
#include "renderer/study/timed_render.h"

#include <fmt/format.h>

#include <bit>
#include <chrono>
#include <utility>

namespace asos {
namespace {

/// Hash of the radiance's bits: equal for equal pictures, and almost certainly different otherwise.
std::string hash_of(const Film& film) {
  std::uint64_t hash = mix_bits(static_cast<std::uint64_t>(film.width));
  for (const glm::vec3& v : film.radiance)
    for (int c = 0; c < 3; ++c) hash = mix_bits(hash ^ std::bit_cast<std::uint32_t>(v[c]));
  return fmt::format("{:016x}", hash);
}

Snapshot snapshot_for(const Job& job, const ComparedScene& open) {
  return {open.scene, open.camera, job.rung.settings, false};
}

CameraChoice choice_of(const StudyCamera& camera) {
  CameraChoice choice;
  choice.index = camera.index;
  choice.fov_y_deg = camera.fov_y_deg;
  if (const auto& at = camera.look_at)
    choice.look_at = LookAt{{(*at)[0], (*at)[1], (*at)[2]}, {(*at)[3], (*at)[4], (*at)[5]}};
  return choice;
}

}  // namespace

JobRunner::JobRunner(StudyPlan plan, std::string jobs_folder, std::function<bool()> stop)
    : plan_(std::move(plan)), folder_(std::move(jobs_folder)), stop_(std::move(stop)) {}

Result<void> JobRunner::open(const StudyScene& subject) {
  if (open_ && open_subject_ == subject) return {};
  const AbandonableWork loading("asos: interrupted, no report was written\n");
  open_.reset();  // frees its memory before the next one is loaded
  PictureArguments wanted;
  wanted.scene = subject.source;
  wanted.render_features = plan_.render_features;
  wanted.asset_root = plan_.asset_root;
  wanted.camera = choice_of(subject.look.camera);
  if (const auto& moment = subject.look.moment) wanted.clip = {moment->animation, moment->seconds};
  Result<OpenedScene> opened = OpenedScene::open(wanted);
  if (!opened) return tl::unexpected(opened.error());
  auto ready = compared_scene(*opened, opened->time(), wanted, plan_, subject.look);
  if (!ready) return tl::unexpected(ready.error());
  open_ = *std::move(ready);
  open_subject_ = subject;
  return {};
}

Result<void> JobRunner::write_picture(const JobRecord& record, const Film& film) const {
  const Job& job = record.job;
  switch (job.kind) {
    case JobKind::regions:
      return write_regions(job_file(folder_, job.id, ".png"),
                           find_regions(snapshot_for(job, *open_), film));
    case JobKind::point:
      // Other repetitions are only compared by their hash.
      if (job.repetition > 1) return {};
      break;
    case JobKind::progress:
    case JobKind::reference:
      break;
  }
  return write_exr(job_file(folder_, job.id, ".exr"), film, {{"asos.job", job.title()}});
}

JobRecord JobRunner::record_of(const Job& job) const {
  JobRecord record;
  record.job = job;
  record.machine = machine_;
  record.folder = folder_;
  record.when = utc_now();
  return record;
}

Result<JobRecord> JobRunner::give_up(const Job& job) const {
  JobRecord record = record_of(job);
  record.finished = false;
  if (const auto written = write_record(plan_, record); !written)
    return tl::unexpected(written.error());
  return record;
}

Result<void> JobRunner::render(JobRecord& record, const std::function<bool()>& stop) const {
  const Job& job = record.job;
  const auto rendered = timed_render(snapshot_for(job, *open_), stop);
  record.finished = rendered.has_value();
  if (!rendered) return {};
  record.cost = {rendered->wall_seconds, rendered->cpu_seconds, rendered->memory_mb};
  record.rays = rays_of(rendered->statistics);
  record.pyrays = pyrays_of(rendered->statistics);
  record.rejected_samples = rendered->statistics.rejected_samples;
  record.picture_hash = hash_of(rendered->film);
  const RenderScene& scene = *open_->scene;
  record.scene = {scene.world().triangles.size(), scene.geometry->memory_mb(),
                  scene.lights().size(), needs_of(scene, job.rung.settings).left_out()};
  return write_picture(record, rendered->film);
}

Result<void> JobRunner::watch(JobRecord& record, const std::function<bool()>& stop) const {
  const Job& job = record.job;
  Snapshot snapshot = snapshot_for(job, *open_);
  snapshot.progressive = true;
  const RecordedRender watched = watch_render(snapshot, study_factor, stop);
  record.finished = watched.finished;
  for (const TimedPicture& picture : watched.pictures) {
    const std::string path = job_file(folder_, job.id, moment_ending(record.moments.size()));
    if (auto written = write_exr(path, picture.film, {{"asos.job", job.title()}}); !written)
      return written;
    record.moments.push_back(picture.seconds);
  }
  if (watched.pictures.empty()) return {};
  const TimedPicture& last = watched.pictures.back();
  record.cost.wall_seconds = last.progress.seconds;
  record.cost.cpu_seconds = last.seconds;
  record.picture_hash = hash_of(last.film);
  return {};
}

Result<JobRecord> JobRunner::run(const Job& job, double seconds) {
  if (const auto opened = open(job.subject); !opened) return tl::unexpected(opened.error());
  if (const auto fits = check_method(*open_->scene, job.rung.settings); !fits)
    return tl::unexpected(fits.error());
  const bool may_be_cut =
      may_be_given_up(job.kind) || (job.kind == JobKind::reference && job.pass > 0);
  const auto start = std::chrono::steady_clock::now();
  const auto out_of_time = [&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return may_be_cut && passed.count() > seconds;
  };
  const auto interrupted = [this] { return stop_ && stop_(); };

  JobRecord record = record_of(job);
  const auto stop = [&] { return interrupted() || out_of_time(); };
  const auto rendered = job.kind == JobKind::progress ? watch(record, stop) : render(record, stop);
  if (interrupted()) return tl::unexpected(Error{"report", "interrupted"});
  if (!rendered) return tl::unexpected(rendered.error());
  if (const auto written = write_record(plan_, record); !written)
    return tl::unexpected(written.error());
  return record;
}

}  // namespace asos
