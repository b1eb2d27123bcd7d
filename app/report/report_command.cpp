#include "app/command.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/option.h"
#include "app/picture_options.h"
#include "app/progress_bar.h"
#include "app/report/flicker_files.h"
#include "app/report/flicker_study.h"
#include "app/report/gnuplot.h"
#include "app/report/job_runner.h"
#include "app/report/report_arguments.h"
#include "app/report/report_files.h"
#include "app/report/study_report.h"
#include "app/scene_argument.h"
#include "renderer/session/film_render.h"
#include "renderer/study/timed_out_settings.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <ostream>
#include <utility>

namespace asos {
namespace {

constexpr const char* report_footer =
    "Renders every scene by every method at several settings. DIR gets report.html, points.csv,\n"
    "progress.csv, report.json, plots/, pictures/ and jobs/.\n"
    "\n"
    "Jobs can run apart on equal machines and be merged:\n"
    "  asos report SCENE -o DIR --list-jobs        lists the jobs\n"
    "  asos report SCENE -o DIR --job K            runs job K, into DIR/jobs\n"
    "  asos report --merge DIR [DIR...] -o OUT     makes the report of finished jobs\n"
    "\n"
    "--frames, or --animation alone, measures flicker: the variation of a pixel's error over the\n"
    "frames of an animation. DIR gets report.html, flicker.csv, flicker.json, plots/ and\n"
    "pictures/.\n"
    "\n"
    "Examples:\n"
    "  asos report builtin:boxes -o boxes --size 320x180\n"
    "  asos report model.glb builtin:office -o both --budget 600 --methods asos,sobol\n"
    "  asos report --suite paper -o paper --size 640x480\n"
    "  asos report bike.glb -o bike --sky studio.hdr --reflections 2 --tr 2\n"
    "  asos report fox.glb --animation Run --time 0.5 -o moment\n"
    "  asos report --animation builtin:walking-pole -o pole   # flicker over its first second\n"
    "  asos report fox.glb --animation Run --frames 0-11/24 -o fox --methods asos,sobol\n"
    "\n"
    "Exit codes: 0 done, 1 bad input (scene or file), 2 bad command line, 130 interrupted.";

/// Reports the progress to the user.
class Journal {
 public:
  Journal(ProgressBar& bar, std::size_t count) : bar_(bar), count_(count) {}
  void begin(const Job& job) {
    bar_.say(fmt::format("{} of at most {}: {}", job.id + 1, count_, job.title()));
  }

 private:
  ProgressBar& bar_;
  std::size_t count_;
};

/// Opens the sky if it is a file, and copies the look into the plan.
Result<void> take_look(ReportArguments& arguments) {
  const auto settings = with_sky(arguments.look);
  if (!settings) return tl::unexpected(settings.error());
  StudyPlan& plan = arguments.plan;
  plan.look = look_of(*settings);
  plan.look.camera.index = arguments.look.camera.index;
  plan.look.camera.fov_y_deg = arguments.look.camera.fov_y_deg;
  if (const auto& look = arguments.look.camera.look_at)
    plan.look.camera.look_at = {look->eye.x,    look->eye.y,    look->eye.z,
                                look->target.x, look->target.y, look->target.z};
  if (const ClipChoice& clip = arguments.look.clip; clip.seconds)
    plan.look.moment = StudyMoment{clip.animation, *clip.seconds};
  plan.texture_resolution = settings->texture.resolution;
  plan.render_features = arguments.look.render_features;
  plan.asset_root = arguments.look.asset_root;
  return {};
}

Result<void> check_scenes(const StudyPlan& plan) {
  for (const StudyScene& scene : scenes_of(plan))
    if (const auto there = check_scene_argument(scene.source); !there)
      return tl::unexpected(there.error());
  RenderSettings settings;
  settings.width = plan.width;
  settings.height = plan.height;
  return check_picture_fits(settings);
}

/// Renders passes of a scene's reference until it is quiet enough or the budget is used up. The
/// budget is larger if too few settings could be compared.
Result<void> run_reference(JobRunner& runner, JobRecords& done, const std::string& scene,
                           Journal& journal) {
  const auto start = std::chrono::steady_clock::now();
  double budget = done.plan.budget_seconds * (done.plan.patient ? StudyPlan::patience : 1.0);
  for (const Job& job : done.jobs) {
    if (job.kind != JobKind::reference || job.scene != scene) continue;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    const double left = budget - passed.count();
    if (job.pass > 0 && job.half == 0 && left <= 0.0) break;
    journal.begin(job);
    auto record = runner.run(job, left);
    if (!record) return tl::unexpected(record.error());
    const bool finished = record->finished;
    done.records.push_back(*std::move(record));
    if (!finished) break;
    if (job.half == 0) continue;
    const auto reference = reference_of(done, scene);
    if (!reference) return tl::unexpected(reference.error());
    if (reference->quiet) break;
    if (reference->comparable) budget = done.plan.budget_seconds;
  }
  return {};
}

Result<void> run_all(const ReportArguments& arguments, const std::vector<Job>& jobs,
                     ProgressBar& bar, const InterruptGuard& interrupt) {
  const std::string folder = jobs_folder(arguments.output);
  if (const auto ready = make_folder(folder).and_then([&] { return clear_jobs(folder); }); !ready)
    return ready;
  JobRunner runner(arguments.plan, folder, [&] { return interrupt.interrupted(); });
  Journal journal(bar, jobs.size());
  JobRecords done{arguments.plan, jobs, {}};
  for (const StudyScene& subject : scenes_of(arguments.plan)) {
    const std::string scene = subject.name();
    TimedOutSettings timed_out;
    for (const Job& job : jobs) {
      if (job.scene != scene || job.kind == JobKind::reference) continue;
      journal.begin(job);
      auto record = timed_out.holds(job) ? runner.give_up(job)
                                         : runner.run(job, arguments.plan.longest_seconds);
      if (!record) return tl::unexpected(record.error());
      if (!record->finished) timed_out.add(job);
      done.records.push_back(*std::move(record));
    }
    if (const auto ran = run_reference(runner, done, scene, journal); !ran) return ran;
  }
  return {};
}

/// Assembles the report from folders of jobs into the output folder.
Result<std::string> make_report(const std::vector<std::string>& folders,
                                const std::string& output) {
  const auto jobs = read_records(folders);
  if (!jobs) return tl::unexpected(jobs.error());
  const auto report = assemble(*jobs);
  if (!report) return tl::unexpected(report.error());
  if (const auto written = write_report(*report, output); !written)
    return tl::unexpected(written.error());
  return (std::filesystem::path(output) / "report.html").string();
}

Result<std::string> run_one(const ReportArguments& arguments, const std::vector<Job>& jobs,
                            const InterruptGuard& interrupt) {
  const Job& job = jobs[*arguments.job];
  const std::string folder = jobs_folder(arguments.output);
  if (const auto made = make_folder(folder); !made) return tl::unexpected(made.error());
  JobRunner runner(arguments.plan, folder, [&] { return interrupt.interrupted(); });
  const StudyPlan& plan = arguments.plan;
  const auto record =
      runner.run(job, job.kind == JobKind::reference ? plan.budget_seconds : plan.longest_seconds);
  if (!record) return tl::unexpected(record.error());
  return job_file(folder, job.id, ".json");
}

/// Studies the flicker of all scenes, and writes it to the output folder.
Result<std::string> run_flicker(const ReportArguments& arguments, ProgressBar& bar,
                                const InterruptGuard& interrupt) {
  const auto ready = check_gnuplot().and_then([&] { return make_folder(arguments.output); });
  if (!ready) return tl::unexpected(ready.error());
  std::vector<FlickerStudy> studies;
  for (const std::string& scene : arguments.plan.scenes) {
    auto study = study_flicker(arguments, scene, bar, interrupt);
    if (!study) return tl::unexpected(study.error());
    studies.push_back(*std::move(study));
  }
  bar.say("Writing the report ...");
  if (const auto written = write_flicker_report(studies, arguments.output); !written)
    return tl::unexpected(written.error());
  return (std::filesystem::path(arguments.output) / "report.html").string();
}

Result<std::string> run(const ReportArguments& arguments, const std::vector<Job>& jobs,
                        ProgressBar& bar, const InterruptGuard& interrupt) {
  if (arguments.flicker) return run_flicker(arguments, bar, interrupt);
  if (arguments.job) return run_one(arguments, jobs, interrupt);
  const auto ready = check_gnuplot().and_then([&] { return make_folder(arguments.output); });
  if (!ready) return tl::unexpected(ready.error());
  if (!arguments.merge.empty()) return make_report(arguments.merge, arguments.output);
  if (const auto ran = run_all(arguments, jobs, bar, interrupt); !ran)
    return tl::unexpected(ran.error());
  bar.say("Writing the report ...");
  return make_report({arguments.output}, arguments.output);
}

int run_report(ReportArguments arguments, const Streams& streams) {
  std::vector<Job> jobs;
  if (arguments.merge.empty()) {
    const auto ready = check_scenes(arguments.plan).and_then([&] { return take_look(arguments); });
    if (!ready) return fail(streams, ready.error());
    auto made = make_jobs(arguments.plan);
    if (!made) return fail(streams, made.error());
    jobs = *std::move(made);
  }
  if (arguments.list_jobs) {
    for (const Job& job : jobs)
      streams.out << fmt::format("{}\t{}\n", job.id, printable(job.title()));
    return exit_ok;
  }
  if (arguments.job && *arguments.job >= jobs.size()) {
    streams.err << fmt::format("asos report: --job: {} is not from 0 to {}\n", *arguments.job,
                               jobs.size() - 1);
    return exit_usage;
  }
  const InterruptGuard interrupt;
  ProgressBar bar(streams.err, streams.err_is_terminal && !arguments.quiet);
  const auto wrote = run(arguments, jobs, bar, interrupt);
  bar.wipe();
  if (interrupt.interrupted()) {
    streams.err << "asos: interrupted, no report was written\n";
    return exit_interrupted;
  }
  if (!wrote) return fail(streams, wrote.error());
  if (!arguments.quiet) streams.out << fmt::format("Wrote {}.\n", printable(*wrote));
  return exit_ok;
}

/// Chooses between frames and one time of an animation. For frames without SCENE, the value of
/// `--animation` is the scene.
void choose_frames(ReportArguments& arguments) {
  ClipChoice& clip = arguments.look.clip;
  StudyPlan& plan = arguments.plan;
  arguments.flicker = arguments.frames || (clip.animation && !clip.seconds);
  if (arguments.frames && clip.seconds)
    throw CLI::ValidationError("--time", "frames of an animation have times of their own");
  if (!arguments.flicker) return;
  if (arguments.job || arguments.list_jobs || plan.paper || !arguments.merge.empty())
    throw CLI::ValidationError("--animation",
                               "flicker does not work with --job, --list-jobs, --merge or --suite");
  if (plan.scenes.empty() && clip.animation)
    plan.scenes = {*std::exchange(clip.animation, std::nullopt)};
}

// Checks everything that can be wrong with the command line without opening a file.
void check(ReportArguments& arguments) {
  choose_frames(arguments);
  StudyPlan& plan = arguments.plan;
  const bool studies = !plan.scenes.empty() || plan.paper;
  if (arguments.merge.empty() && !studies) throw CLI::RequiredError("SCENE, --suite or --merge");
  if (!arguments.merge.empty() && (studies || arguments.job || arguments.list_jobs))
    throw CLI::ValidationError("--merge",
                               "--merge takes scenes and settings from the jobs: do not name any");
  if (arguments.output.empty() && !arguments.list_jobs) throw CLI::RequiredError("-o");
  if (plan.methods.empty()) plan.methods = default_methods();
  for (const std::string& method : plan.methods)
    if (const auto known = ladder_of(method, {}); !known)
      throw CLI::ValidationError("--methods", known.error().message());
}

void add_study_options(CLI::App& app, StudyPlan& plan) {
  app.add_option("SCENE", plan.scenes, "Paths of .gltf or .glb files, or builtin:NAME")
      ->type_name("");
  add_parsed_option(
      app, "--size", "WxH", "Size of the pictures in pixels",
      [](const std::string& text) { return parse_size(text, largest_side); },
      [&](PictureSize s) { plan.width = s.width, plan.height = s.height; })
      ->default_str(fmt::format("{}x{}", plan.width, plan.height));
  add_parsed_option(
      app, "--budget", "SECONDS",
      "Wall time for the reference of each scene; its first pass always finishes. Unless given, up "
      "to "
      "ten times longer while a quarter of ASOS's settings cannot be compared. With --job, for "
      "each half of a pass",
      [](const std::string& text) { return parse_number(text, 0.0, 1e9, true); },
      [&](double seconds) {
        plan.budget_seconds = seconds;
        plan.patient = false;
      })
      ->default_str(fmt::format("{}", plan.budget_seconds));
  add_parsed_option(
      app, "--longest", "SECONDS",
      "Wall time for one picture; a slower setting is abandoned, with all slower settings of its "
      "method",
      [](const std::string& text) { return parse_number(text, 0.0, 1e9, true); },
      [&](double seconds) { plan.longest_seconds = seconds; })
      ->default_str(fmt::format("{}", plan.longest_seconds));
  std::string known;
  for (const std::string& name : ladder_methods()) known += (known.empty() ? "" : ", ") + name;
  app.add_option("--methods", plan.methods, "Methods to compare, separated by commas: " + known)
      ->delimiter(',')
      ->type_name("LIST")
      ->default_str("all but beam");
  app.add_option_function<std::string>(
         "--suite",
         [&](const std::string& name) {
           if (name != "paper")
             throw CLI::ValidationError("--suite", "\"" + name + "\": not one of paper");
           plan.paper = true;
         },
         "paper: also the cases of CGF'98 table 2 with the published figures")
      ->type_name("NAME");
  add_parsed_option(
      app, "--repetitions", "N", "Renders per setting: 1 to 99",
      [](const std::string& text) { return parse_whole(text, 1, 99); },
      [&](int n) { plan.repetitions = n; })
      ->default_str(std::to_string(plan.repetitions));
  add_parsed_option(
      app, "--threads", "N", "Worker threads, 1 to 1024; 0: one for each core",
      [](const std::string& text) { return parse_whole(text, 0, 1024); },
      [&](int n) { plan.threads = n; })
      ->default_str("0");
}

}  // namespace

Command add_report_command(CLI::App& program) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App* parser = program.add_subcommand(
      "report", "Measure error against run time, or flicker, of ASOS and other methods");
  add_study_options(*parser, arguments->plan);
  add_look_options(*parser, arguments->look);
  add_clip_options(*parser, arguments->look.clip);
  add_parsed_option(
      *parser, "--frames", "A-B/FPS",
      "Frames of the animation to measure flicker over (FPS alone: all) [0-23/24, with --animation "
      "and without --time]",
      [](const std::string& text) { return parse_clip_frames(text); },
      [arguments](const ClipFrames& frames) { arguments->frames = frames; });
  parser->add_option("-o,--output", arguments->output, "Folder to write to")->type_name("DIR");
  parser->add_flag("--list-jobs", arguments->list_jobs, "List the jobs, one per line");
  add_parsed_option(
      *parser, "--job", "K", "Run one job by its number",
      [](const std::string& text) { return parse_whole(text, 0, 1'000'000'000); },
      [arguments](int k) { arguments->job = static_cast<std::size_t>(k); });
  parser
      ->add_option("--merge", arguments->merge,
                   "Make the report from finished jobs in these folders")
      ->type_name("DIR...");
  parser->add_flag("--quiet", arguments->quiet, "No progress and no closing line");
  parser->footer(report_footer);
  parser->callback([arguments] { check(*arguments); });
  return {parser, [arguments](const Streams& streams) { return run_report(*arguments, streams); }};
}

}  // namespace asos
