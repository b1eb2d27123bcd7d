#include "ui/view_study.h"

#include "renderer/comparison/method.h"
#include "renderer/study/measures.h"
#include "renderer/study/progress_curve.h"
#include "renderer/study/reference.h"
#include "renderer/study/timed_out_settings.h"
#include "renderer/study/timed_render.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asos::ui {

namespace {

/// Returns the words for a job in the window, where methods have their buttons' names.
std::string words_of(const Job& job) {
  if (job.kind == JobKind::regions) return "regions";
  if (job.kind == JobKind::reference)
    return fmt::format("reference, {} spp", job.rung.settings.sampling.spp);
  const std::string words =
      fmt::format("{}, {}", row_of(job.rung.settings.method).title, job.rung.setting);
  if (job.kind == JobKind::progress) return words + ", while rendering";
  return job.repetition > 1 ? fmt::format("{}, repetition {}", words, job.repetition) : words;
}

}  // namespace

/// One study: the work of its thread, and the state that other threads may read.
class ViewStudy::Work {
 public:
  Work(Subject subject, std::vector<Job> jobs)
      : subject_(std::move(subject)), jobs_(std::move(jobs)) {
    state_.phase = Phase::running;
    state_.points = points_of(jobs_);
    study_.scene = subject_.plan.scenes.front();
  }

  /// Runs the study, on its own thread.
  void run(const std::stop_token& stop) {
    // The search for boundaries would share the processors with the first renders. If it fails, the
    // renders of ASOS say so.
    (void)subject_.scene->geometry->boundaries.wait(stop);
    const bool measured =
        fit_into_time(stop) && run_pass(0, stop) && run_points(stop) && watch_renders(stop);
    for (int pass = 1; measured && !quiet_ && pass < reference_passes; ++pass)
      if (!run_pass(pass, stop)) break;
    const std::lock_guard lock(mutex_);
    state_.phase = measured && !stop.stop_requested() ? Phase::finished : Phase::stopped;
    state_.doing.clear();
    state_.resting = false;
  }

  void set_disturbed(bool disturbed) {
    const std::lock_guard lock(mutex_);
    if (disturbed && !disturbed_) ++disturbances_;
    disturbed_ = disturbed;
    calm_.notify_all();
  }

  [[nodiscard]] State state() const {
    const std::lock_guard lock(mutex_);
    return state_;
  }
  [[nodiscard]] bool running() const {
    const std::lock_guard lock(mutex_);
    return state_.phase == Phase::running;
  }
  [[nodiscard]] const RenderScene* scene() const { return subject_.scene.get(); }

 private:
  static std::size_t points_of(const std::vector<Job>& jobs) {
    return static_cast<std::size_t>(std::count_if(
        jobs.begin(), jobs.end(), [](const Job& job) { return may_be_given_up(job.kind); }));
  }
  /// Returns the remaining time in seconds.
  [[nodiscard]] double seconds_left() const {
    return subject_.seconds ? *subject_.seconds - spent_seconds_
                            : std::numeric_limits<double>::infinity();
  }

  /// Measures the time per sample and chooses the picture size from it. False on a stop.
  bool fit_into_time(const std::stop_token& stop) {
    if (!subject_.seconds) return true;
    Job probe;
    for (const Job& job : jobs_)
      if (job.kind == JobKind::reference) probe = job;
    constexpr int samples = 4, reduction = 4;
    RenderSettings& settings = probe.rung.settings;
    settings.sampling.spp = samples;
    settings.width = std::max(1, settings.width / reduction);
    settings.height = std::max(1, settings.height / reduction);
    // A render that takes longer counts with this time.
    const double longest = 0.05 * *subject_.seconds;
    const auto rendered = render(probe, longest, stop);
    if (stop.stop_requested()) return false;
    const double taken = rendered ? rendered->wall_seconds : longest;
    const double pixels = static_cast<double>(settings.width) * settings.height;
    subject_.plan = plan_in_time(subject_.plan, taken / (pixels * samples), *subject_.seconds);
    auto jobs = make_jobs(subject_.plan);
    if (!jobs) return false;
    jobs_ = *std::move(jobs);
    const std::lock_guard lock(mutex_);
    state_.points = points_of(jobs_);
    return true;
  }

  /// Waits until no other work disturbs. Returns the number of disturbances so far; nothing on a
  /// stop.
  std::optional<std::uint64_t> wait_for_calm(const Job& job, const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    state_.doing = words_of(job);
    state_.resting = disturbed_;
    if (!calm_.wait(lock, stop, [this] { return !disturbed_; })) return std::nullopt;
    state_.resting = false;
    return disturbances_.load();
  }

  /// Calls `tries` with a stop function, again after each disturbance. The function stops a try on
  /// a stop, on a disturbance and after `seconds`. Returns a default value on a stop.
  template <typename Try>
  auto undisturbed(const Job& job, double seconds, const std::stop_token& stop, Try tries) {
    using Outcome = decltype(tries(std::function<bool()>()));
    while (const auto before = wait_for_calm(job, stop)) {
      const auto start = std::chrono::steady_clock::now();
      Outcome outcome = tries([&] {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        return stop.stop_requested() || disturbances_ != *before || passed.count() > seconds;
      });
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
      if (disturbances_ == *before) {
        spent_seconds_ += took.count();
        return outcome;
      }
    }
    return Outcome{};
  }

  /// Returns nothing on a stop, or if a try takes longer than `seconds`.
  std::optional<TimedRender> render(const Job& job, double seconds, const std::stop_token& stop) {
    return undisturbed(job, seconds, stop, [&](const std::function<bool()>& ends) {
      return timed_render({subject_.scene, subject_.camera, job.rung.settings, false}, ends);
    });
  }

  /// Returns false on a stop, or once the budget is used up.
  bool run_pass(int pass, const std::stop_token& stop) {
    std::vector<Film> halves;
    for (const Job& job : jobs_) {
      if (job.kind != JobKind::reference || job.pass != pass) continue;
      const double left =
          pass == 0 ? std::numeric_limits<double>::infinity()
                    : std::min(subject_.plan.budget_seconds - reference_seconds_, seconds_left());
      if (left <= 0.0) return false;
      auto rendered = render(job, left, stop);
      if (!rendered) return false;
      reference_seconds_ += rendered->wall_seconds;
      halves.push_back(std::move(rendered->film));
    }
    reference_.add(halves[0], halves[1], reference_samples(pass));
    reference_film_ = reference_.film();
    study_.noise = reference_.noise();
    for (std::size_t i = 0; i < films_.size(); ++i)
      study_.points[i].measures.rmse = root_mean_square(films_[i], reference_film_, true);
    for (std::size_t i = 0; i < watched_.size(); ++i)
      study_.while_rendering[i].points = curve_of(watched_[i]);
    publish(0);
    return true;
  }

  bool run_points(const std::stop_token& stop) {
    TimedOutSettings timed_out;
    for (const Job& job : jobs_) {
      if (job.kind != JobKind::point) continue;
      const double longest = std::min(subject_.plan.longest_seconds, seconds_left());
      auto rendered =
          timed_out.holds(job) || longest <= 0.0 ? std::nullopt : render(job, longest, stop);
      if (stop.stop_requested()) return false;
      if (rendered) {
        add(job.rung, *std::move(rendered));
      } else {
        timed_out.add(job);
      }
      publish(1);
    }
    return true;
  }

  bool watch_renders(const std::stop_token& stop) {
    for (const Job& job : jobs_) {
      if (job.kind != JobKind::progress) continue;
      const double longest = std::min(subject_.plan.longest_seconds, seconds_left());
      if (longest <= 0.0) {
        publish(1);
        continue;
      }
      RecordedRender watched =
          undisturbed(job, longest, stop, [&](const std::function<bool()>& ends) {
            return watch_render({subject_.scene, subject_.camera, job.rung.settings, true},
                                study_factor, ends);
          });
      if (stop.stop_requested()) return false;
      if (!watched.pictures.empty()) {
        study_.while_rendering.push_back(
            {job.rung.method, job.rung.setting, watched.finished, curve_of(watched)});
        watched_.push_back(std::move(watched));
      }
      publish(1);
    }
    return true;
  }

  [[nodiscard]] std::vector<CurvePoint> curve_of(const RecordedRender& watched) const {
    std::vector<CurvePoint> curve;
    for (const TimedPicture& picture : watched.pictures)
      curve.push_back({picture.seconds, root_mean_square(picture.film, reference_film_, true)});
    return curve;
  }

  void add(const LadderStep& rung, TimedRender rendered) {
    auto at = std::find_if(study_.points.begin(), study_.points.end(), [&](const StudyPoint& p) {
      return p.rung.method == rung.method && p.rung.setting == rung.setting;
    });
    if (at == study_.points.end()) {
      StudyPoint point;
      point.rung = rung;
      point.rays = rays_of(rendered.statistics);
      point.pyrays = pyrays_of(rendered.statistics);
      point.rejected_samples = rendered.statistics.rejected_samples;
      point.measures.rmse = root_mean_square(rendered.film, reference_film_, true);
      at = study_.points.insert(at, std::move(point));
      films_.push_back(std::move(rendered.film));
    } else {
      const auto index = static_cast<std::size_t>(at - study_.points.begin());
      if (films_[index].radiance != rendered.film.radiance) at->same_picture = false;
    }
    at->costs.push_back({rendered.wall_seconds, rendered.cpu_seconds, rendered.memory_mb});
  }

  void publish(std::size_t points_run) {
    analyse(study_);
    double smallest = std::numeric_limits<double>::infinity();
    for (const StudyPoint& point : study_.points)
      smallest = std::min(smallest, point.measures.rmse);
    quiet_ = !study_.points.empty() && quiet_enough(study_.noise, smallest);
    const std::lock_guard lock(mutex_);
    state_.study = study_;
    state_.points_run += points_run;
    state_.passes = reference_.passes();
    state_.quiet = quiet_;
  }

  // Used by the study's thread; before it starts, by the creating thread. The scene is immutable.
  Subject subject_;
  std::vector<Job> jobs_;
  double spent_seconds_ = 0.0;  // wall-clock seconds without pauses
  Reference reference_;
  Film reference_film_;
  double reference_seconds_ = 0.0;
  bool quiet_ = false;
  std::vector<Film> films_;              // films of the first repetition of each point
  std::vector<RecordedRender> watched_;  // the study's curves of error during a render
  SceneStudy study_;

  mutable std::mutex mutex_;
  std::condition_variable_any calm_;
  bool disturbed_ = false;
  std::atomic<std::uint64_t> disturbances_ = 0;  // changed under the mutex
  State state_;
};

StudyPlan ViewStudy::plan_in_time(StudyPlan plan, double sample_seconds, double seconds) {
  // Number of samples assumed for each setting of ASOS and of methods without a sample count.
  constexpr int uncounted = 24;
  double samples = 0.0;
  double finest = 0.0;
  for (const std::string& method : plan.methods) {
    const auto rungs = ladder_of(method, {});
    if (!rungs) continue;
    for (const LadderStep& rung : *rungs) {
      const bool counted = row_of(rung.settings.method).samples != SampleCount::none;
      const double spp = counted ? rung.settings.sampling.spp : uncounted;
      samples += spp;
      finest = std::max(finest, spp);
    }
  }
  // Noise falls with the square root of the number of samples. With 16 times the samples of the
  // finest setting, the reference is four times less noisy: quiet_enough().
  double reference = 2.0 * reference_samples(0);
  for (int pass = 1; pass < reference_passes && reference < 16.0 * finest; ++pass)
    reference += 2.0 * reference_samples(pass);
  samples += reference;
  constexpr double part = 0.75;  // the rest is for watched renders and a wrong estimate
  constexpr int smallest = 32;   // pixels
  const double pixels = part * seconds / std::max(1e-12, sample_seconds * samples);
  const double fits =
      std::sqrt(pixels / (static_cast<double>(plan.width) * static_cast<double>(plan.height)));
  const auto side = [&](int whole) {
    return std::clamp(static_cast<int>(fits * whole), std::min(smallest, whole), whole);
  };
  plan.width = side(plan.width);
  plan.height = side(plan.height);
  plan.repetitions = 1;
  plan.budget_seconds = seconds;
  plan.longest_seconds = 0.25 * seconds;
  return plan;
}

Result<void> ViewStudy::start(const Subject& subject) {
  if (busy()) return unexpected(Error{"study", "the previous measurement is still running"});
  if (!subject.scene || subject.scene->world().shows_nothing())
    return unexpected(Error{"study", "the scene is empty"});
  if (scenes_of(subject.plan).size() != 1)
    return unexpected(Error{"study", "only one scene at a time"});
  auto jobs = make_jobs(subject.plan);
  if (!jobs) return unexpected(jobs.error());
  for (const Job& job : *jobs)
    if (const auto able = check_method(*subject.scene, job.rung.settings); !able)
      return unexpected(able.error());
  started_ = std::make_shared<Work>(subject, *std::move(jobs));
  shown_ = started_;
  started_->set_disturbed(disturbed_);
  thread_ = std::jthread([work = started_](const std::stop_token& stop) { work->run(stop); });
  return {};
}

void ViewStudy::stop() {
  thread_.request_stop();
}

void ViewStudy::clear() {
  stop();
  shown_.reset();
}

void ViewStudy::update(bool disturbed) {
  disturbed_ = disturbed;
  if (started_) started_->set_disturbed(disturbed);
  // Releases the scene and films of a hidden study as soon as it has ended.
  if (!shown_ && !busy()) started_.reset();
}

const RenderScene* ViewStudy::scene() const {
  return shown_ ? shown_->scene() : nullptr;
}

bool ViewStudy::busy() const {
  return started_ && started_->running();
}

ViewStudy::State ViewStudy::state() const {
  return shown_ ? shown_->state() : State{};
}

}  // namespace asos::ui
