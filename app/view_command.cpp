#include "app/command.h"
#include "app/exit_code.h"
#include "app/picture_options.h"
#include "app/scene_argument.h"
#include "app/shutter_option.h"
#include "ui/viewer.h"

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <memory>
#include <ostream>

namespace asos {
namespace {

bool has_display() {
  const auto is_set = [](const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
  };
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

int run_view(const PictureArguments& arguments, bool own_size, const Streams& streams) {
  if (const Result<void> scene = check_scene_argument(arguments.scene); !scene)
    return fail(streams, scene.error());
  const Result<RenderSettings> settings = with_sky(arguments);
  if (!settings) return fail(streams, settings.error());
  if (has_display())
    return ui::run_viewer(
        {{arguments.scene,
          arguments.variant,
          arguments.scene_of_file,
          arguments.clip,
          {},
          arguments.asset_root},
         *settings,
         own_size,
         {arguments.sky_chosen, arguments.ground_chosen, arguments.background_chosen},
         forced_by(arguments.render_features)});
  streams.err << "asos: no display to open a window on. Render to a file instead:\n"
              << "  asos render '" << printable(arguments.scene) << "' -o picture.png\n";
  return exit_bad_input;
}

}  // namespace

Command add_view_command(CLI::App& program) {
  const auto arguments = std::make_shared<PictureArguments>();
  CLI::App* parser = program.add_subcommand("view", "Open a scene in a window (the default)");
  add_picture_options(*parser, *arguments, false);
  add_scene_choices(*parser, arguments->scene_of_file, arguments->variant, arguments->asset_root);
  add_clip_options(*parser, arguments->clip);
  add_shutter_option(*parser, *arguments);
  parser->callback([arguments] { take_shutter(*arguments, usual_fps); });
  parser->footer(
      "Files can also be dropped on the window.\n\nExamples:\n  asos\n  asos model.glb --eps 0.01 "
      "--max 4\n  asos builtin:fence --method stochastic --spp 16");
  return {parser, [arguments, parser](const Streams& streams) {
            return run_view(*arguments, parser->count("--size") > 0, streams);
          }};
}

}  // namespace asos
