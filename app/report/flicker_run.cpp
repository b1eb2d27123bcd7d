#include "app/frame_list.h"
#include "app/report/compared_scene.h"
#include "app/report/flicker_study.h"
#include "app/report/pictures.h"
#include "renderer/comparison/method.h"
#include "renderer/study/reference.h"
#include "renderer/study/timed_render.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

namespace asos {
namespace {

constexpr int usual_frames = 24;
constexpr double usual_fps = 24.0;
constexpr int strip_length = 6;

tl::unexpected<Error> report_interrupted() {
  return tl::unexpected(Error{"report", "interrupted"});
}

Film cut_out(const Film& film, const PixelRect& part) {
  Film cut(part.width, part.height);
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      cut.radiance[cut.index(x, y)] = film.radiance[film.index(part.x + x, part.y + y)];
  return cut;
}

/// The area of the pictures, a fifth of their width and height, that differs most from the first
/// one.
PixelRect liveliest_part(const std::vector<Film>& films) {
  const int width = films.front().width, height = films.front().height;
  PixelRect part{0, 0, std::clamp(width / 5, 8, width), std::clamp(height / 5, 8, height)};
  part.width = std::min(part.width, width);
  part.height = std::min(part.height, height);
  FlickerMeter changes;
  for (const Film& film : films) changes.add(film, films.front());
  const std::vector<double> map = changes.map();
  PixelRect best = part;
  double most = -1.0;
  for (int y = 0; y + part.height <= height; y += std::max(1, part.height / 4)) {
    for (int x = 0; x + part.width <= width; x += std::max(1, part.width / 4)) {
      double sum = 0.0;
      for (int row = y; row < y + part.height; ++row)
        for (int column = x; column < x + part.width; ++column)
          sum += std::pow(map[films.front().index(column, row)], 2.0);
      if (sum > most) most = sum, best = {x, y, part.width, part.height};
    }
  }
  return best;
}

/// One study, from its command line to its measurements.
class FlickerRun {
 public:
  FlickerRun(const ReportArguments& arguments, std::string scene, ProgressBar& bar,
             const InterruptGuard& interrupt)
      : arguments_(arguments), bar_(bar), interrupt_(interrupt) {
    study_.scene = std::move(scene);
    study_.width = arguments.plan.width;
    study_.height = arguments.plan.height;
    study_.machine = this_machine();
    study_.when = utc_now();
  }

  Result<FlickerStudy> run() {
    return open()
        .and_then([&] { return list_work(); })
        .and_then([&] { return choose_passes(); })
        .and_then([&] { return show_strip(); })
        .and_then([&] { return render_all_frames(); })
        .map([&] {
          study_.noise = 0.5 * halves_.rmse();
          study_.floor = flicker_floor(halves_);
          compare_flicker(study_);
          return std::move(study_);
        });
  }

 private:
  Result<void> open() {
    const AbandonableWork loading("asos: interrupted, no report was written\n");
    bar_.say(fmt::format("Loading {} ...", study_.scene));
    wanted_ = arguments_.look;
    wanted_.scene = study_.scene;
    if (!wanted_.clip.any()) wanted_.clip.seconds = 0.0;
    auto opened = OpenedScene::open(wanted_);
    if (!opened) return tl::unexpected(opened.error());
    scene_.emplace(*std::move(opened));
    RenderArguments frames;
    frames.clip_frames = arguments_.frames.value_or(ClipFrames{0, usual_frames - 1, usual_fps});
    study_.fps = frames.clip_frames->fps;
    frames_ = frames_of(frames, scene_->contents(), scene_->time());
    if (!arguments_.frames)  // a short animation ends earlier
      std::erase_if(frames_,
                    [&](const FrameRequest& f) { return beyond_the_end({f}, scene_->contents()); });
    if (frames_.size() < 2)
      return tl::unexpected(Error{study_.scene, "flicker is told from two frames at least"});
    study_.frames = static_cast<int>(frames_.size());
    study_.first_frame = *frames_.front().of_clip;
    study_.animation_number = scene_->time()->animation;
    study_.animation =
        scene_->contents().animations[static_cast<std::size_t>(study_.animation_number)].name;
    const int shown = std::min(strip_length, study_.frames);
    study_.strip_first = (study_.frames - shown) / 2;
    strip_end_ = study_.strip_first + shown;
    return {};
  }

  Result<void> list_work() {
    StudyPlan plan = arguments_.plan;
    plan.scenes = {study_.scene};
    plan.paper = false;
    plan.repetitions = 1;
    const auto jobs = make_jobs(plan);
    if (!jobs) return tl::unexpected(jobs.error());
    for (const Job& job : *jobs) {
      if (job.kind == JobKind::point) study_.points.push_back({job.rung, {}, {}, {}, false});
      if (job.kind == JobKind::reference) passes_.push_back(job.rung.settings);
    }
    // Sorts by curve and by increasing quality. The anchor's method comes first, because its time
    // limits the others'.
    std::stable_sort(study_.points.begin(), study_.points.end(),
                     [](const FlickerPoint& a, const FlickerPoint& b) {
                       const bool first_a = a.rung.method == "asos";
                       const bool first_b = b.rung.method == "asos";
                       if (first_a != first_b) return first_a;
                       return a.rung.curve < b.rung.curve;
                     });
    return {};
  }

  /// Prepares a frame for rendering.
  Result<void> go_to(std::size_t frame) {
    if (at_ == frame) return {};
    const AbandonableWork building("asos: interrupted, no report was written\n");
    auto ready = compared_scene(*scene_, frames_[frame].time, wanted_, arguments_.plan,
                                arguments_.plan.look);
    if (!ready) return tl::unexpected(ready.error());
    ready_ = *std::move(ready);
    at_ = frame;
    return {};
  }

  /// Returns nullopt if the picture took longer than the limit.
  Result<std::optional<TimedRender>> render(const RenderSettings& settings, bool may_be_cut) {
    if (const auto fits = check_method(*ready_.scene, settings); !fits)
      return tl::unexpected(fits.error());
    const auto start = std::chrono::steady_clock::now();
    auto rendered = timed_render({ready_.scene, ready_.camera, settings, false}, [&] {
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
      const bool too_long = may_be_cut && passed.count() > arguments_.plan.longest_seconds;
      return interrupt_.interrupted() || too_long;
    });
    if (interrupt_.interrupted()) return report_interrupted();
    return rendered;
  }

  /// Adds a pass to the reference of the prepared frame.
  Result<void> add_pass(Reference& reference, std::size_t pass) {
    std::array<Film, 2> halves;
    for (std::size_t half = 0; half < 2; ++half) {
      auto rendered = render(passes_[2 * pass + half], false);
      if (!rendered) return tl::unexpected(rendered.error());
      halves[half] = std::move((*rendered)->film);
    }
    reference.add(halves[0], halves[1], passes_[2 * pass].sampling.spp);
    return {};
  }

  Result<Reference> reference_of_frame(std::size_t frame) {
    bar_.say(fmt::format("{}: reference of frame {} of {}, {} passes", study_.scene, frame + 1,
                         study_.frames, passes_done_));
    Reference reference;
    for (std::size_t pass = 0; pass < passes_done_; ++pass)
      if (const auto added = add_pass(reference, pass); !added)
        return tl::unexpected(added.error());
    study_.samples = reference.samples();
    return reference;
  }

  /// Chooses the number of passes. It is the same for all references, so that their noise is
  /// constant in static areas. Aims at noise of a quarter of ASOS's error, within the budget.
  Result<void> choose_passes() {
    if (const auto there = go_to(static_cast<std::size_t>(study_.strip_first)); !there)
      return there;
    const FlickerPoint* anchor = anchor_of(study_.points);
    bar_.say(fmt::format("{}: how long a picture takes", study_.scene));
    const auto picture = render(anchor->rung.settings, true);
    if (!picture) return tl::unexpected(picture.error());
    const StudyPlan& plan = arguments_.plan;
    const double budget =
        plan.budget_seconds * (plan.patient ? StudyPlan::patience : 1.0) / study_.frames;
    const auto start = std::chrono::steady_clock::now();
    Reference reference;
    for (std::size_t pass = 0; 2 * pass < passes_.size(); ++pass) {
      const auto before = std::chrono::steady_clock::now();
      if (const auto added = add_pass(reference, pass); !added) return added;
      const auto now = std::chrono::steady_clock::now();
      passes_done_ = pass + 1;
      const bool quiet =
          *picture && quiet_enough(reference.noise(),
                                   root_mean_square((*picture)->film, reference.film(), true));
      // The next pass takes twice as long as the last.
      const double with_next =
          std::chrono::duration<double>((now - start) + 2 * (now - before)).count();
      if (quiet || with_next > budget) break;
    }
    return {};
  }

  /// Finds the area for the film strip. This needs the references of the strip's frames.
  Result<void> show_strip() {
    std::vector<Film> films;
    for (int i = study_.strip_first; i < strip_end_; ++i) {
      const auto frame = static_cast<std::size_t>(i);
      if (const auto there = go_to(frame); !there) return there;
      auto reference = reference_of_frame(frame);
      if (!reference) return tl::unexpected(reference.error());
      films.push_back(reference->film());
      references_.emplace(frame, *std::move(reference));
    }
    study_.strip_part = liveliest_part(films);
    for (const Film& film : films) study_.strip.push_back(cut_out(film, study_.strip_part));
    return {};
  }

  Result<void> render_all_frames() {
    for (std::size_t frame = 0; frame < frames_.size(); ++frame) {
      if (const auto there = go_to(frame); !there) return there;
      if (!references_.contains(frame)) {
        auto reference = reference_of_frame(frame);
        if (!reference) return tl::unexpected(reference.error());
        references_.emplace(frame, *std::move(reference));
      }
      const Reference reference = std::move(references_.extract(frame).mapped());
      halves_.add(reference.half(0), reference.half(1));
      bar_.say(fmt::format("{}: frame {} of {}", study_.scene, frame + 1, study_.frames));
      const auto done = frame == 0 ? choose_points(reference) : render_points(frame, reference);
      if (!done) return done;
    }
    return {};
  }

  /// Renders the first frame with all settings. Leaves out settings slower than the first one of
  /// their curve that takes longer than the anchor.
  Result<void> choose_points(const Reference& reference) {
    std::vector<FlickerPoint> all = std::exchange(study_.points, {});
    std::map<std::string, double> longest;  // slowest rendered setting of each curve, in seconds
    double anchor_seconds = 0.0;
    const auto take = [&](FlickerPoint& p) -> Result<void> {
      const bool wanted = !longest.contains(p.rung.curve) || !(anchor_seconds > 0.0) ||
                          longest[p.rung.curve] <= anchor_seconds;
      if (!wanted) return {};
      const Result<bool> rendered = add_frame(p, 0, reference);
      if (!rendered) return tl::unexpected(rendered.error());
      if (!*rendered) {
        study_.timed_out.push_back(p.rung.method + " " + p.rung.setting);
        longest[p.rung.curve] = std::numeric_limits<double>::infinity();
        if (!(anchor_seconds > 0.0)) anchor_seconds = arguments_.plan.longest_seconds;
        return {};
      }
      double& curve = longest[p.rung.curve];
      curve = std::max(curve, p.frame_seconds.front());
      if (is_anchor(p.rung)) anchor_seconds = p.frame_seconds.front();
      study_.points.push_back(std::move(p));
      return {};
    };
    // The anchor's method goes first.
    std::stable_partition(all.begin(), all.end(),
                          [](const FlickerPoint& p) { return p.rung.method == "asos"; });
    for (FlickerPoint& p : all)
      if (const auto taken = take(p); !taken) return taken;
    return {};
  }

  Result<void> render_points(std::size_t frame, const Reference& reference) {
    for (std::size_t i = 0; i < study_.points.size();) {
      const Result<bool> rendered = add_frame(study_.points[i], frame, reference);
      if (!rendered) return tl::unexpected(rendered.error());
      if (*rendered) {
        ++i;
        continue;
      }
      study_.timed_out.push_back(study_.points[i].rung.method + " " +
                                 study_.points[i].rung.setting);
      study_.points.erase(study_.points.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return {};
  }

  /// Returns whether the frame was finished in time.
  Result<bool> add_frame(FlickerPoint& p, std::size_t frame, const Reference& reference) {
    const auto rendered = render(p.rung.settings, true);
    if (!rendered) return tl::unexpected(rendered.error());
    if (!*rendered) return false;
    const Film& film = (*rendered)->film;
    p.frame_seconds.push_back((*rendered)->cpu_seconds);
    p.meter.add(film, reference.half(0), reference.half(1));
    const auto number = static_cast<int>(frame);
    if (number >= study_.strip_first && number < strip_end_)
      p.strip.push_back(cut_out(film, study_.strip_part));
    return true;
  }

  const ReportArguments& arguments_;
  ProgressBar& bar_;
  const InterruptGuard& interrupt_;
  FlickerStudy study_;
  PictureArguments wanted_;
  std::optional<OpenedScene> scene_;
  std::vector<FrameRequest> frames_;
  int strip_end_ = 0;
  std::vector<RenderSettings> passes_;  // passes of a reference, two halves each
  std::size_t passes_done_ = 0;         // that each reference has
  std::map<std::size_t, Reference> references_;
  FlickerMeter halves_;  // flicker between the two halves of the references
  std::optional<std::size_t> at_;
  ComparedScene ready_;
};

}  // namespace

Result<FlickerStudy> study_flicker(const ReportArguments& arguments, const std::string& scene,
                                   ProgressBar& bar, const InterruptGuard& interrupt) {
  return FlickerRun(arguments, scene, bar, interrupt).run();
}

}  // namespace asos
