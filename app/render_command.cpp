#include "app/camera_choice.h"
#include "app/command.h"
#include "app/exit_code.h"
#include "app/from_option.h"
#include "app/interrupt.h"
#include "app/option.h"
#include "app/picture_files.h"
#include "app/progress_bar.h"
#include "app/render_arguments.h"
#include "app/render_job.h"
#include "app/render_report.h"
#include "app/scene_argument.h"
#include "renderer/comparison/method.h"
#include "renderer/scene/remarks.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <ostream>

namespace asos {
namespace {

constexpr const char* render_footer =
    "The picture is of the whole camera's view; --crop renders a part of it, pixel for pixel the\n"
    "same. PNG is what the window shows; EXR holds linear radiance, which --exposure does not\n"
    "change. Both carry the settings, times and statistics as text, and --from renders such a\n"
    "picture again.\n"
    "\n"
    "Examples:\n"
    "  asos render builtin:office -o office.png --size 1920x1080 --max 4\n"
    "  asos render model.glb -o model.exr --look-at 4,2,4,0,1,0 --fov 40 --stats model.json\n"
    "  asos render builtin:fence -o fence.png --crop 320,180,64,48 --split-map levels.png\n"
    "  asos render builtin:boxes -o rival.png --method stochastic --spp 64\n"
    "  asos render --from office.png -o larger.png --size 3840x2160\n"
    "  asos render builtin:office -o soon.png --time-limit 10\n"
    "  asos render builtin:boxes -o turn.png --frames 0-29/120   # a quarter of a turn\n"
    "\n"
    "Exit codes: 0 done, 1 bad input (scene or file), 2 bad command line, 130 interrupted.";

constexpr const char* nothing_written = "asos: interrupted, nothing was written\n";
constexpr double most_time_limit_seconds = 1e6;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Everything about the command line that can be wrong without opening anything.
void check(const RenderArguments& arguments) {
  if (arguments.picture.from_error) return;  // which is told later, as bad input
  if (arguments.picture.scene.empty()) throw CLI::RequiredError("SCENE (or --from)");
  const RenderSettings& settings = arguments.picture.settings;
  const PixelRect crop = settings.crop;
  if (!is_picture_path(arguments.output))
    throw CLI::ValidationError("-o",
                               fmt::format("\"{}\": has to end in .png or .exr", arguments.output));
  if (!arguments.split_map.empty() && !has_extension(arguments.split_map, ".png"))
    throw CLI::ValidationError("--split-map",
                               fmt::format("\"{}\": has to end in .png", arguments.split_map));
  const auto twice = [](const std::string& a, const std::string& b) {
    return !a.empty() && !b.empty() && same_file(a, b);
  };
  if (twice(arguments.output, arguments.split_map) ||
      twice(arguments.output, arguments.stats_file) ||
      twice(arguments.split_map, arguments.stats_file))
    throw CLI::ValidationError("-o, --split-map, --stats", "two of them name the same file");
  if (!crop.empty() &&
      (crop.x + crop.width > settings.width || crop.y + crop.height > settings.height))
    throw CLI::ValidationError(
        "--crop", fmt::format("{},{},{},{} reaches beyond the picture of {}x{} pixels", crop.x,
                              crop.y, crop.width, crop.height, settings.width, settings.height));
}

tl::unexpected<Error> interrupted_error() {
  return tl::unexpected(Error{"render", "interrupted"});
}

// The parts of the saved picture that are not overridden: its lights belong to its scene alone.
PictureDescription wanted_picture(const PictureArguments& wanted) {
  PictureDescription picture = wanted.from.value_or(PictureDescription{});
  picture.needs = wanted.needs;
  if (picture.scene != wanted.scene) {
    picture.lights.reset();
    picture.dfrs.reset();
  }
  return picture;
}

Error scene_error(const PictureArguments& wanted, const Error& error) {
  if (!wanted.from || wanted.from->scene != wanted.scene) return error;
  return scene_of_picture_error(wanted.from_file, error);
}

Error nothing_drawn(const RenderReport& report) {
  const std::string why = report.warnings.empty() ? "" : " (" + report.warnings.back() + ")";
  return {
      report.scene,
      fmt::format("there is nothing in it to draw{}; --allow-empty renders it all the same", why)};
}

/// Says what of the scene is not in the picture, in a bounded number of lines.
void say_warnings(const RenderReport& report, std::ostream& err) {
  constexpr std::size_t most_lines = 10;
  const std::size_t said = std::min(report.warnings.size(), most_lines);
  for (std::size_t i = 0; i < said; ++i) err << "asos: warning: " << report.warnings[i] << "\n";
  if (report.warning_count > said)
    err << fmt::format("asos: warning: and {} more\n", report.warning_count - said);
}

Result<RenderReport> render(const RenderArguments& arguments, const OutputPlan& outputs,
                            ProgressBar& bar, const InterruptGuard& interrupt) {
  std::optional<AbandonableWork> loading(std::in_place, nothing_written);
  PictureArguments wanted = arguments.picture;
  Result<RenderSettings> settings = with_sky(wanted);
  if (!settings) return tl::unexpected(settings.error());
  wanted.settings = *std::move(settings);
  RenderReport report;
  report.scene = wanted.scene;

  // Open the scene
  bar.say(fmt::format("Loading {} ...", wanted.scene));
  const auto started = std::chrono::steady_clock::now();
  Result<Scene> scene = open_scene_argument(wanted.scene);
  if (!scene) return tl::unexpected(scene_error(wanted, scene.error()));
  report.load_seconds = seconds_since(started);
  report.warnings = remarks(scene->notes);
  report.warning_count = remark_count(scene->notes);
  if (interrupt.interrupted()) return interrupted_error();

  // Make it ready to render; what the author wrote is not needed any more
  bar.say("Building ...");
  const auto loaded = std::chrono::steady_clock::now();
  const PictureDescription picture = wanted_picture(wanted);
  auto prepared = prepare(*scene, picture);
  *scene = Scene{};
  // With a limit of time the picture begins with what rays alone can tell.
  const bool at_once = arguments.time_limit_seconds || !needs_boundaries(wanted.settings.method);
  if (!at_once) prepared = std::move(prepared).and_then(with_boundaries);
  if (!prepared) return tl::unexpected(prepared.error());
  const RenderScene& ready = **prepared;
  if (ready.world().surface_count() == 0 && !arguments.allow_empty)
    return tl::unexpected(nothing_drawn(report));
  if (const auto fits = check_method(ready, wanted.settings); !fits)
    return tl::unexpected(fits.error());
  report.build_seconds = seconds_since(loaded);
  report.triangles = ready.world().triangles.size();
  for (const Light& light : ready.lights()) report.lights.push_back({light.name, light.type});

  // Render
  const double aspect = static_cast<double>(wanted.settings.width) / wanted.settings.height;
  if (wanted.from) wanted.camera.given = picture.camera_from(ready.world().origin);
  const Result<Camera> camera = choose_camera(ready.world(), wanted.camera, aspect);
  if (!camera) return tl::unexpected(camera.error());
  report.description =
      describe(ready, *camera, wanted.settings, {wanted.exposure_ev, false, {}, 0.0f, wanted.tone});
  loading.reset();
  const std::optional<RenderedPicture> rendered = run_render_job(
      {*prepared, *camera, wanted.settings, false}, bar, interrupt, arguments.time_limit_seconds);
  if (interrupt.interrupted()) return interrupted_error();
  if (!rendered) return tl::unexpected(with_boundaries(*prepared).error());
  if (ready.geometry->boundaries.known()) report.feature_edges = ready.features().counts();
  report.needs = needs_of(ready, wanted.settings);
  report.threads = rendered->threads;
  report.statistics = rendered->statistics;
  report.render_seconds = rendered->seconds;
  report.time_limit_seconds = arguments.time_limit_seconds;
  report.stopped_at = rendered->stopped_at;
  report.memory_mb = peak_memory_mb();

  const Result<void> written = write_outputs(outputs, rendered->film, report);
  if (!written) return tl::unexpected(written.error());
  return report;
}

int run_picture(const RenderArguments& arguments, const Streams& streams, bool first = true) {
  const InterruptGuard interrupt;
  ProgressBar bar(streams.err, streams.err_is_terminal && !arguments.quiet);
  const std::optional<Error>& no_picture = arguments.picture.from_error;
  const Result<void> given =
      no_picture ? Result<void>(tl::unexpected(*no_picture)) : Result<void>();
  const Result<RenderReport> report =
      given.and_then([&] { return check_picture_fits(arguments.picture.settings); })
          .and_then([&] { return plan_outputs(arguments); })
          .and_then([&](const OutputPlan& outputs) {
            return render(arguments, outputs, bar, interrupt);
          });
  bar.wipe();
  if (!report) {
    if (interrupt.interrupted()) {
      streams.err << nothing_written;
      return exit_interrupted;
    }
    return fail(streams, report.error());
  }
  if (first) say_warnings(*report, streams.err);
  const auto& from = arguments.picture.from;
  if (!arguments.quiet && from && from->display.split_map)
    streams.err << "asos: note: " << printable(arguments.picture.from_file)
                << " shows the split map over the picture, which is rendered without it\n";
  if (!arguments.quiet)
    streams.out << fmt::format(
        "Wrote {}: {} triangles, load {:.2f} s, build {:.2f} s, render {:.2f} s{}.\n",
        printable(arguments.output), report->triangles, report->load_seconds, report->build_seconds,
        report->render_seconds,
        report->stopped_at
            ? fmt::format(", stopped by --time-limit: {}", reached_text(*report->stopped_at))
            : "");
  return exit_ok;
}

std::string path_of_frame(const std::string& path, const CameraTurn& turn) {
  return path.empty() ? path : frame_path(path, turn.frame, turn.count);
}

// Each as if it were asked for alone, so that frames can be rendered anywhere and in any order.
int run_render(const RenderArguments& arguments, const Streams& streams) {
  if (!arguments.frames) return run_picture(arguments, streams);
  for (int frame = arguments.frames->first; frame <= arguments.frames->last; ++frame) {
    const CameraTurn turn{frame, arguments.frames->count};
    RenderArguments one = arguments;
    one.picture.camera.turn = turn;
    one.output = path_of_frame(arguments.output, turn);
    one.split_map = path_of_frame(arguments.split_map, turn);
    one.stats_file = path_of_frame(arguments.stats_file, turn);
    if (const int code = run_picture(one, streams, frame == arguments.frames->first);
        code != exit_ok)
      return code;
  }
  return exit_ok;
}

}  // namespace

Command add_render_command(CLI::App& program) {
  const auto arguments = std::make_shared<RenderArguments>();
  CLI::App* parser = program.add_subcommand("render", "Render a scene to a PNG or an EXR file");
  arguments->picture.scene.clear();
  add_from_option(*parser, arguments->picture);
  add_picture_options(*parser, arguments->picture, true);
  parser->get_option("SCENE")->required(false);  // as --from names one
  parser->add_option("-o,--output", arguments->output, "Picture to write; the ending decides")
      ->type_name("OUT.(png|exr)")
      ->required();
  add_camera_options(*parser, arguments->picture);
  add_parsed_option(
      *parser, "--frames", "A-B/N",
      "Frames A to B (or one, or with N alone all) of a turn of N frames around what the camera is "
      "told to look at, or the scene's middle: OUT-000.png and so on",
      parse_frames, [arguments](FrameRange frames) { arguments->frames = frames; });
  CLI::Option* split_map = parser
                               ->add_option("--split-map", arguments->split_map,
                                            "Also write the split map, in the window's colours")
                               ->type_name("FILE.png");
  add_choice(*parser, "--split-map-by", "WHAT",
             "What the split map's colours tell of a pixel: level (the deepest, 0 to MAX), cause "
             "(why it was split), rays (how many it took) or time",
             split_map_names, arguments->split_map_by)
      ->needs(split_map);
  parser->add_option("--stats", arguments->stats_file, "Also write the statistics as JSON")
      ->type_name("FILE.json");
  add_parsed_option(
      *parser, "--time-limit", "SECONDS",
      "Of rendering, without loading: the picture comes in passes, each better than the last, and "
      "is "
      "written as good as it is by then, each pixel at its best [none: as long as it takes]",
      [](const std::string& text) { return parse_number(text, 0.0, most_time_limit_seconds); },
      [arguments](double seconds) { arguments->time_limit_seconds = seconds; });
  parser->add_flag("--allow-empty", arguments->allow_empty,
                   "Render a scene of which nothing can be drawn, which is an error otherwise");
  parser->add_flag("--quiet", arguments->quiet, "No progress bar and no closing line");
  parser->footer(render_footer);
  parser->callback([arguments] { check(*arguments); });
  return {parser, [arguments](const Streams& streams) { return run_render(*arguments, streams); }};
}

}  // namespace asos
