#include "app/command.h"
#include "app/exit_code.h"
#include "app/picture_options.h"
#include "app/printed_json.h"
#include "app/scene_argument.h"
#include "app/scene_info.h"
#include "renderer/prepared/render_scene.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>
#include <ostream>

namespace asos {
namespace {

struct InfoArguments {
  std::string scene;
  std::string variant;
  std::string scene_of_file;
  NeedsChoice needs = NeedsChoice::scene;
  bool json = false;
};

int run_info(const InfoArguments& arguments, const Streams& streams) {
  Result<Scene> scene = open_scene_argument(
      arguments.scene, {.variant = arguments.variant, .scene = arguments.scene_of_file});
  // All of what a render would do first, for what a scene does not need is known only then.
  const auto ready = scene
                         .and_then([&](const Scene& opened) {
                           return prepare(opened, forced_by(arguments.needs));
                         })
                         .and_then(with_boundaries);
  if (!ready) return fail(streams, ready.error());
  const nlohmann::ordered_json info = scene_info_json(*scene, **ready);
  if (arguments.json)
    streams.out << json_text(info);
  else
    streams.out << scene_info_text(info);
  return exit_ok;
}

}  // namespace

Command add_info_command(CLI::App& program) {
  const auto arguments = std::make_shared<InfoArguments>();
  CLI::App* parser = program.add_subcommand(
      "info", "Say what a scene holds, what is unsupported and what is left out");
  add_scene_argument(*parser, arguments->scene, true);
  add_scene_choices(*parser, arguments->scene_of_file, arguments->variant);
  add_needs_option(*parser, arguments->needs);
  parser->add_flag("--json", arguments->json, "Answer in JSON");
  parser->footer(
      "Examples:\n  asos info model.glb\n  asos info builtin:office --json\n"
      "  asos info model.glb --needs all   # what it takes when nothing is left out");
  return {parser, [arguments](const Streams& streams) { return run_info(*arguments, streams); }};
}

}  // namespace asos
