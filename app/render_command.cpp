#include "app/camera_choice.h"
#include "app/chosen_exposure.h"
#include "app/command.h"
#include "app/exit_code.h"
#include "app/exposed_scene.h"
#include "app/frame_list.h"
#include "app/from_option.h"
#include "app/interrupt.h"
#include "app/kept_picture.h"
#include "app/opened_scene.h"
#include "app/option.h"
#include "app/picture_files.h"
#include "app/progress_bar.h"
#include "app/render_arguments.h"
#include "app/render_job.h"
#include "app/render_messages.h"
#include "app/render_report.h"
#include "app/render_warnings.h"
#include "app/scene_argument.h"
#include "app/shutter_option.h"
#include "renderer/comparison/method.h"
#include "renderer/picture/exr_picture.h"
#include "renderer/prepared/default_look.h"
#include "renderer/prepared/environment_lights.h"
#include "renderer/prepared/focus.h"
#include "renderer/prepared/with_ground.h"
#include "renderer/prepared/with_lines.h"
#include "renderer/scene/source_files.h"
#include "renderer/session/film_render.h"
#include "renderer/world/ground.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <ostream>

namespace asos {
namespace {

constexpr const char* render_footer =
    "--crop renders a part of the picture, with the same pixels. PNG holds display values, EXR "
    "linear\nradiance without exposure. Both contain settings, times and statistics as text; "
    "--from renders\nsuch a file again.\n\nExamples:\n  asos render builtin:office -o office.png "
    "--size 1920x1080 --max 4\n  asos render model.glb -o model.exr --look-at 4,2,4,0,1,0 --fov 40 "
    "--stats model.json\n  asos render builtin:fence -o fence.png --crop 320,180,64,48 --split-map "
    "levels.png\n  asos render builtin:boxes -o sampled.png --method stochastic --spp 64\n  asos "
    "render --from office.png -o larger.png --size 3840x2160\n  asos render builtin:office -o "
    "soon.png --time-limit 10\n  asos render builtin:boxes -o turn.png --frames 0-29/120   # a "
    "quarter of a turn\n  asos render fox.glb -o fox.png --animation Run --time 0.5\n  asos render "
    "fox.glb -o fox.png --animation Run --frames 0-23/24   # its first second\n\nExit codes: 0 "
    "done, 1 bad input (scene or file), 2 bad command line, 130 interrupted.";

constexpr const char* nothing_written = "asos: interrupted, nothing was written\n";
constexpr const char* best_written =
    "asos: interrupted; the picture that was written is unfinished\n";
constexpr const char* frames_kept =
    "asos: interrupted; the same command continues with the first missing frame\n";
constexpr double most_time_limit_seconds = 1e6;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Reads --frames as frames of a turn or of an animation; this depends on the other options.
void read_frames(RenderArguments& arguments) {
  const auto read = [&](auto parse, auto& frames) {
    const auto parsed = parse(arguments.frames);
    if (!parsed) throw CLI::ValidationError("--frames", parsed.error().message());
    frames = *parsed;
  };
  if (arguments.frames.empty()) return;
  const ClipChoice& clip = arguments.picture.clip;
  if (!clip.animation) return read(parse_frames, arguments.turn);
  if (clip.seconds)
    throw CLI::ValidationError("--time", "frames of an animation have times of their own");
  read(parse_clip_frames, arguments.clip_frames);
}

// Checks everything that can be wrong with the command line without opening a file.
void check(const RenderArguments& arguments) {
  if (arguments.picture.from_error) return;  // reported later, as bad input
  if (arguments.picture.scene.empty()) throw CLI::RequiredError("SCENE (or --from)");
  const RenderSettings& settings = arguments.picture.settings;
  const PixelRect crop = settings.crop;
  const auto has_to_end = [](const char* option, const std::string& path, const char* how) {
    throw CLI::ValidationError(option, fmt::format("\"{}\": has to end in {}", path, how));
  };
  const std::string &output = arguments.output, &map = arguments.split_map,
                    &statistics = arguments.stats_file;
  if (!is_picture_path(output)) has_to_end("-o", output, ".png or .exr");
  if (arguments.layers_chosen && !has_extension(output, ".exr"))
    has_to_end("--layers", output, ".exr to hold layers");
  if (!map.empty() && !has_extension(map, ".png")) has_to_end("--split-map", map, ".png");
  const auto twice = [](const std::string& a, const std::string& b) {
    return !a.empty() && !b.empty() && same_file(a, b);
  };
  if (twice(output, map) || twice(output, statistics) || twice(map, statistics))
    throw CLI::ValidationError("-o, --split-map, --stats", "two of them name the same file");
  if (!crop.empty() &&
      (crop.x + crop.width > settings.width || crop.y + crop.height > settings.height))
    throw CLI::ValidationError(
        "--crop", fmt::format("{},{},{},{} reaches beyond the picture of {}x{} pixels", crop.x,
                              crop.y, crop.width, crop.height, settings.width, settings.height));
}

const char* last_words(const RenderArguments& arguments) {
  return arguments.frames.empty() ? nothing_written : frames_kept;
}

tl::unexpected<Error> interrupted_error() {
  return tl::unexpected(Error{"render", "interrupted"});
}

// The parts of the saved picture that are not overridden. The picture's lights are used only with
// the picture's scene.
PictureDescription wanted_picture(const PictureArguments& wanted, const SceneContents& shown) {
  PictureDescription picture = wanted.from.value_or(PictureDescription{});
  picture.render_features = wanted.render_features;
  picture.settings.sky = wanted.settings.sky;
  // The lights of the picture's environment are dropped with it.
  const bool brought = picture.sky.environment && picture.sky != wanted.sky;
  const int number = picture.scene_number < 0 ? shown.default_scene : picture.scene_number;
  if (picture.scene != wanted.scene || number != shown.shown_scene) {
    picture.lights.reset();
    picture.dfrs.reset();
  }
  if (brought) picture.lights.reset();
  return picture;
}

Error scene_error(const PictureArguments& wanted, const Error& error) {
  if (!wanted.from || wanted.from->scene != wanted.scene) return error;
  return scene_of_picture_error(wanted.from_file, error);
}

/// State that all pictures of one command line share.
struct Work {
  OpenedScene scene;
  double load_seconds = 0.0;
  std::vector<std::string> sources;  ///< files that the pictures depend on
};

// Opens the scene, and reads the selected sky into the settings.
Result<Work> open(RenderArguments& arguments, ProgressBar& bar, const InterruptGuard& interrupt) {
  const AbandonableWork loading(nothing_written);
  PictureArguments& wanted = arguments.picture;
  wanted.settings = judged_as_shown(wanted);
  Result<RenderSettings> settings = with_sky(wanted);
  if (!settings) return tl::unexpected(settings.error());
  wanted.settings = *std::move(settings);
  bar.say(fmt::format("Loading {} ...", wanted.scene));
  const auto started = std::chrono::steady_clock::now();
  Result<OpenedScene> scene = OpenedScene::open(wanted);
  if (!scene) return tl::unexpected(scene_error(wanted, scene.error()));
  if (interrupt.interrupted()) return interrupted_error();
  scene->expect_ground();
  Work work{*std::move(scene), seconds_since(started), {}};
  if (!arguments.frames.empty()) work.sources = source_files(wanted.scene, wanted.asset_root);
  if (!wanted.sky.file.empty()) work.sources.push_back(wanted.sky.file);
  return work;
}

RenderReport report_of(const RenderArguments& arguments, const RenderScene& ready,
                       const Camera& camera) {
  const PictureArguments& wanted = arguments.picture;
  RenderReport report;
  report.scene = wanted.scene;
  tell_warnings(report, ready, wanted.sky);
  report.triangles = triangles_without_ground(ready.world());
  for (const Light& light : ready.lights()) report.lights.push_back({light.name, light.type});
  report.description =
      describe(ready, camera, wanted.settings, {wanted.exposure_ev, false, {}, 0.0f, wanted.tone});
  report.time_limit_seconds = arguments.time_limit_seconds;
  return report;
}

/// Renders one picture; in a series, skips a picture that is finished already. `arguments` are the
/// picture's own.
Result<RenderReport> render(RenderArguments arguments, const FrameRequest& frame, Work& work,
                            ProgressBar& bar, const InterruptGuard& interrupt) {
  const Result<OutputPlan> outputs = plan_outputs(arguments);
  if (!outputs) return tl::unexpected(outputs.error());
  std::optional<AbandonableWork> building(std::in_place, last_words(arguments));
  const PictureArguments& wanted = arguments.picture;
  const PictureDescription picture = wanted_picture(wanted, work.scene.contents());

  // Prepares the scene; with a time limit the first passes need no edges
  if (bar.pictures() == 1) bar.say("Building ...");
  const auto started = std::chrono::steady_clock::now();
  auto prepared = work.scene.at(frame.time, picture);
  if (!prepared) return tl::unexpected(prepared.error());
  CameraChoice choice = wanted.camera;
  if (wanted.from) choice.given = picture.camera_from((*prepared)->world().origin);
  const double aspect = static_cast<double>(wanted.settings.width) / wanted.settings.height;
  const Result<Camera> camera = work.scene.camera((*prepared)->world(), choice, aspect);
  if (!camera) return tl::unexpected(camera.error());
  take_default_look(arguments.picture, **prepared, *camera);
  arguments.picture.settings.shutter.camera =
      followed_camera(choice, (*prepared)->world(), wanted.settings.shutter);
  if (!picture.lights) prepared = lit_under(*prepared, wanted.settings.sky.get());
  if (prepared) prepared = with_ground(*std::move(prepared), wanted.settings.ground);
  if (prepared) work.scene.keep(*prepared);
  if (prepared) prepared = with_lines(*prepared, line_picture(*camera, wanted.settings));
  if (!prepared) return tl::unexpected(prepared.error());
  const std::shared_ptr<const RenderScene> still = *prepared;
  const RenderScene& ready = *still;
  if (const auto fits = check_method(ready, wanted.settings); !fits)
    return tl::unexpected(fits.error());
  RenderReport report = report_of(arguments, ready, *camera);
  for (const std::string& note :
       {fit_remark(ready.world(), choice, aspect),
        lens_remark(focused(ready, *camera, wanted.settings), choice.lens, wanted.settings.method),
        planes_remark(ready, *camera, wanted.settings)})
    if (!note.empty()) report.camera_notes.push_back(note);
  // Objects of an animation may be hidden at times.
  const bool empty = ready.world().shows_nothing();
  if (empty && !frame.time && !arguments.allow_empty) return tl::unexpected(nothing_drawn(report));
  report.kept = bar.pictures() > 1 && is_rendered(arguments, report.description, work.sources);
  if (report.kept) return report;
  const bool at_once =
      arguments.time_limit_seconds || !needs_of_picture(ready, wanted.settings).boundaries;
  if (const auto found = at_once ? prepared : with_boundaries(*prepared); !found)
    return tl::unexpected(found.error());
  prepared = exposed_scene(still, *camera, wanted.settings, picture, work.scene);
  if (!prepared) return tl::unexpected(prepared.error());
  const Exposure* exposure = (*prepared)->exposure.get();
  report.shows_nothing = empty && frame.time && !(exposure && exposure->moves());
  for (std::string& note : shutter_remarks(wanted.settings, exposure))
    report.camera_notes.push_back(std::move(note));
  report.load_seconds = work.load_seconds;
  report.build_seconds = seconds_since(started);
  building.reset();

  const std::optional<RenderResult> rendered = run_render_job(
      {*prepared, *camera, wanted.settings, false}, bar, interrupt, arguments.time_limit_seconds);
  // With a time limit there is a picture to write even then.
  const bool in_passes = arguments.time_limit_seconds.has_value();
  if (interrupt.interrupted() && !(rendered && in_passes)) return interrupted_error();
  if (!rendered) return tl::unexpected(with_boundaries(*prepared).error());
  if (ready.geometry->boundaries.known()) report.feature_edges = ready.features().counts();
  tell_warnings(report, ready, wanted.sky);
  report.render_features = needs_of_picture(ready, wanted.settings);
  report.threads = worker_count(wanted.settings.threads);
  report.statistics = rendered->statistics;
  warn_of_cut_stacks(report);
  report.render_seconds = rendered->seconds;
  report.stopped_at = rendered->stopped_at;
  report.interrupted = interrupt.interrupted() && report.stopped_at;
  report.memory_mb = peak_memory_mb();

  ExrOptions exr = exr_options(ready, *camera, wanted.settings);
  exr.compression = arguments.compression;
  if (arguments.clip_frames) exr.frames_a_second = arguments.clip_frames->fps;
  const Result<void> written = write_outputs(*outputs, rendered->film, report, exr);
  if (!written) return tl::unexpected(written.error());
  return report;
}

// Reads the scene for its textures and buffers, to check that no output overwrites them.
Result<void> check_inputs(const RenderArguments& arguments) {
  const AbandonableWork reading(nothing_written);
  return check_inputs_stay(arguments);
}

// Renders each picture as if alone, so that frames can be rendered in any order and on any machine.
// Sets `unfinished` if an interrupt ended a picture that was written all the same.
Result<void> render_all(RenderArguments arguments, const Streams& streams, ProgressBar& bar,
                        const InterruptGuard& interrupt, bool& unfinished) {
  if (arguments.picture.from_error) return tl::unexpected(*arguments.picture.from_error);
  if (auto fits = check_picture_fits(arguments.picture.settings); !fits) return fits;
  // Checked before the scene is loaded, which may take long.
  if (auto stay = check_inputs(arguments_of(arguments, first_frame(arguments))); !stay) return stay;
  if (const auto plan = plan_outputs(arguments_of(arguments, first_frame(arguments))); !plan)
    return tl::unexpected(plan.error());
  Result<Work> work = open(arguments, bar, interrupt);
  if (!work) return tl::unexpected(work.error());

  const Result<std::string> exposed = choose_exposure(
      arguments.picture, work->scene, wanted_picture(arguments.picture, work->scene.contents()));
  if (!exposed) return tl::unexpected(exposed.error());

  const std::vector<FrameRequest> frames =
      frames_of(arguments, work->scene.contents(), work->scene.time());
  if (frames.empty())
    return tl::unexpected(Error{arguments.picture.scene, "the animation ends before that frame"});
  // Checked before the first picture takes its time.
  for (const FrameRequest& frame : frames) {
    const RenderArguments one = arguments_of(arguments, frame);
    if (auto stay = check_inputs_stay(one, work->sources); !stay) return stay;
    if (const auto plan = plan_outputs(one); !plan) return tl::unexpected(plan.error());
  }
  PicturesDone done;
  done.count = static_cast<int>(frames.size());
  for (const FrameRequest& frame : frames) {
    bar.set_done(done);
    const RenderArguments one = arguments_of(arguments, frame);
    const Result<RenderReport> report = render(one, frame, *work, bar, interrupt);
    bar.wipe();
    if (!report) return tl::unexpected(report.error());
    if (!arguments.quiet) {
      if (done.finished == 0) {
        say_warnings(*report, streams.err);
        say_notes(arguments, frames, work->scene, streams.err);
        if (!exposed->empty()) say_note(*exposed, streams.err);
        for (const std::string& note : report->camera_notes) say_note(note, streams.err);
      }
      say_nothing_visible(one, *report, frame, streams.err);
      say_written(one, *report, streams.out);
    }
    unfinished = report->interrupted;
    if (unfinished) return interrupted_error();
    ++done.finished;
    if (!report->kept) ++done.rendered, done.seconds += report->render_seconds;
  }
  return {};
}

int run_render(const RenderArguments& arguments, const Streams& streams) {
  const InterruptGuard interrupt;
  ProgressBar bar(streams.err, streams.err_is_terminal && !arguments.quiet);
  bool unfinished = false;
  const Result<void> done = render_all(arguments, streams, bar, interrupt, unfinished);
  bar.wipe();
  if (done) return exit_ok;
  if (!interrupt.interrupted()) return fail(streams, done.error());
  streams.err << (unfinished && arguments.frames.empty() ? best_written : last_words(arguments));
  return exit_interrupted;
}

}  // namespace

Command add_render_command(CLI::App& program) {
  const auto arguments = std::make_shared<RenderArguments>();
  CLI::App* parser = program.add_subcommand("render", "Render a scene to PNG or EXR");
  arguments->picture.scene.clear();
  add_from_option(*parser, arguments->picture);
  add_picture_options(*parser, arguments->picture, true);
  parser->get_option("SCENE")->required(false);  // as --from names one
  parser->add_option("-o,--output", arguments->output, "Picture to write, .png or .exr")
      ->type_name("OUT.(png|exr)")
      ->required();
  add_camera_options(*parser, arguments->picture);
  add_scene_choices(*parser, arguments->picture.scene_of_file, arguments->picture.variant,
                    arguments->picture.asset_root);
  add_clip_options(*parser, arguments->picture.clip);
  add_shutter_option(*parser, arguments->picture);
  parser
      ->add_option("--frames", arguments->frames,
                   "Frames A to B (or one, or all N) of a turntable of N frames: OUT-000.png and "
                   "so on. With --animation: frames of the animation at FPS, OUT-0000.png. "
                   "Finished frames with the same settings are kept")
      ->type_name("A-B/N|FPS");
  CLI::Option* split_map =
      parser->add_option("--split-map", arguments->split_map, "Also write the split map")
          ->type_name("FILE.png");
  add_choice(*parser, "--split-map-by", "WHAT",
             "Colours of the split map: level (deepest, 0 to MAX), cause, rays or time",
             split_map_names, arguments->split_map_by)
      ->needs(split_map);
  add_parsed_option(
      *parser, "--layers", "NAME,...|all",
      "Also write these layers to the EXR, such as depth, normal, object; asos info "
      "--layers lists them",
      [](const std::string& text) { return parse_layers(text); },
      [arguments](LayerSet layers) {
        arguments->picture.settings.layers = layers;
        arguments->layers_chosen = true;
      });
  add_choice(*parser, "--exr-compression", "NAME",
             "Compression of EXR pictures: zip (lossless) or dwaa (lossy for colours)",
             exr_compression_names, arguments->compression);
  parser->add_option("--stats", arguments->stats_file, "Also write statistics as JSON")
      ->type_name("FILE.json");
  add_parsed_option(
      *parser, "--time-limit", "SECONDS",
      "Render time in seconds, without loading: writes the best picture of that time [none: to the "
      "end]",
      [](const std::string& text) { return parse_number(text, 0.0, most_time_limit_seconds); },
      [arguments](double seconds) { arguments->time_limit_seconds = seconds; });
  parser->add_flag("--allow-empty", arguments->allow_empty,
                   "Accept a scene without triangles, lines or points");
  parser->add_flag("--quiet", arguments->quiet, "No progress bar, warnings or closing line");
  parser->footer(render_footer);
  parser->callback([arguments] {
    read_frames(*arguments);
    const std::optional<ClipFrames>& frames = arguments->clip_frames;
    take_shutter(arguments->picture, frames ? frames->fps : usual_fps);
    // Layers of a saved picture are kept only for an EXR.
    if (!arguments->layers_chosen && !has_extension(arguments->output, ".exr"))
      arguments->picture.settings.layers = {};
    check(*arguments);
  });
  return {parser, [arguments](const Streams& streams) { return run_render(*arguments, streams); }};
}

}  // namespace asos
