#include "app/command.h"
#include "app/exit_code.h"
#include "app/opened_scene.h"
#include "app/option.h"
#include "app/picture_options.h"
#include "app/printed_json.h"
#include "app/progress_bar.h"
#include "app/scene_argument.h"
#include "app/shutter_option.h"
#include "app/trace_report.h"
#include "renderer/asos/pixel_trace.h"
#include "renderer/comparison/method.h"
#include "renderer/prepared/environment_lights.h"
#include "renderer/prepared/with_ground.h"
#include "renderer/prepared/with_lines.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <ostream>

namespace asos {
namespace {

constexpr const char* trace_footer =
    "The first table is the papers': for each level K the M cells with edges. For each object "
    "near\nthem it counts cell axes that hit it (in) and miss it (out); L is the larger of the "
    "two. Then come\nall cells with their edges and samples. Positions run from 0 to 1 across the "
    "pixel, from its top\nleft corner; colours are linear. #N is the N-th smooth surface of a "
    "part. Last come the pyramids\nthat its cells send to lights, mirrors and glass: the parent, "
    "its sample and weight, and the\nresult. --json adds their cells. Sampled parts send rays, "
    "which are not listed.\n\nExamples:\n  asos trace builtin:boxes --size 320x180 --pixel "
    "160,90\n  asos trace model.glb --pixel 640,360 --method asos-published --json";

struct TraceArguments {
  PictureArguments picture;
  glm::ivec2 pixel{0};
  bool json = false;
};

// Checks everything that can be wrong with the command line without opening a file.
void check(const TraceArguments& arguments) {
  const RenderSettings& settings = arguments.picture.settings;
  if (const auto valid = validated(settings); !valid)
    throw CLI::ValidationError("--" + valid.error().subject, valid.error().reason);
  if (!in_object_space(settings.method))
    throw CLI::ValidationError("--method", "only asos and asos-published split pixels");
  if (arguments.pixel.x >= settings.width || arguments.pixel.y >= settings.height)
    throw CLI::ValidationError(
        "--pixel", fmt::format("{},{} lies outside the picture of {}x{} pixels", arguments.pixel.x,
                               arguments.pixel.y, settings.width, settings.height));
}

Result<nlohmann::ordered_json> trace(const TraceArguments& arguments, ProgressBar& bar) {
  const PictureArguments& wanted = arguments.picture;
  const Result<RenderSettings> with = with_sky(wanted);
  if (!with) return tl::unexpected(with.error());
  bar.say(fmt::format("Loading {} ...", wanted.scene));
  Result<OpenedScene> scene = OpenedScene::open(wanted);
  if (!scene) return tl::unexpected(scene.error());
  scene->expect_ground();
  bar.say("Building ...");
  PictureDescription picture;
  picture.render_features = wanted.render_features;
  picture.settings.sky = with->sky;
  auto prepared = scene->at(scene->time(), picture);
  if (!prepared) return tl::unexpected(prepared.error());
  RenderSettings settings = as_published(*with);
  settings.judged_tone = judged_as_shown(wanted).judged_tone;
  const double aspect = static_cast<double>(settings.width) / settings.height;
  const Result<Camera> camera = scene->camera((*prepared)->world(), wanted.camera, aspect);
  if (!camera) return tl::unexpected(camera.error());
  PictureArguments shown = wanted;
  shown.settings = settings;
  take_default_look(shown, **prepared, *camera);
  settings = shown.settings;
  prepared = lit_under(*std::move(prepared), settings.sky.get())
                 .and_then([&](auto lit) { return with_ground(std::move(lit), settings.ground); })
                 .and_then([&](auto grounded) {
                   return with_lines(std::move(grounded), line_picture(*camera, settings));
                 })
                 .and_then(with_boundaries);
  if (!prepared) return tl::unexpected(prepared.error());
  const RenderScene& ready = **prepared;
  const View view(viewed_camera(ready, *camera, settings), settings.width, settings.height,
                  radius_around_origin(ready.world().bounds));
  return trace_json(trace_pixel(ready, view, settings, arguments.pixel.x, arguments.pixel.y), ready,
                    {wanted.scene, camera->name, scene->time(), settings});
}

int run_trace(const TraceArguments& arguments, const Streams& streams) {
  ProgressBar bar(streams.err, streams.err_is_terminal);
  const auto traced = trace(arguments, bar);
  bar.wipe();
  if (!traced) return fail(streams, traced.error());
  streams.out << (arguments.json ? json_text(*traced) : trace_text(with_printable_texts(*traced)));
  return exit_ok;
}

}  // namespace

Command add_trace_command(CLI::App& program) {
  const auto arguments = std::make_shared<TraceArguments>();
  CLI::App* parser =
      program.add_subcommand("trace", "Print how one pixel is split, cell by cell, and why");
  add_picture_options(*parser, arguments->picture, true);
  add_camera_options(*parser, arguments->picture);
  add_scene_choices(*parser, arguments->picture.scene_of_file, arguments->picture.variant,
                    arguments->picture.asset_root);
  add_clip_options(*parser, arguments->picture.clip);
  add_shutter_option(*parser, arguments->picture);
  // Options that have no effect on one pixel's subdivision.
  for (const char* option : {"--spp", "--threads", "--exposure", "--crop"})
    parser->remove_option(parser->get_option(option));
  add_parsed_option(*parser, "--pixel", "x,y", "Pixel, from the top left corner", parse_pixel,
                    [arguments](glm::ivec2 pixel) { arguments->pixel = pixel; })
      ->required();
  parser->add_flag("--json", arguments->json, "Print JSON");
  parser->footer(trace_footer);
  parser->callback([arguments] {
    take_shutter(arguments->picture, usual_fps);
    check(*arguments);
  });
  return {parser, [arguments](const Streams& streams) { return run_trace(*arguments, streams); }};
}

}  // namespace asos
