#include "app/command.h"
#include "app/exit_code.h"
#include "app/picture_options.h"
#include "app/printed_json.h"
#include "app/scene_argument.h"
#include "app/scene_info.h"
#include "renderer/film/layers.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/scene/posable_scene.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <memory>
#include <ostream>
#include <utility>

namespace asos {
namespace {

struct InfoArguments {
  std::string scene;
  std::string variant;
  std::string scene_of_file;
  std::string asset_root;
  FeatureChoice render_features = FeatureChoice::scene;
  ClipChoice clip;
  bool json = false;
  bool all = false;
  bool layers = false;
};

std::string layers_text() {
  std::string text = "Layers of asos render --layers, in an EXR:\n";
  for (const LayerRow& row : layer_table())
    text += fmt::format("  {:<17} {:<4} {:<9} {:<18} {}\n", row.name,
                        row.holds_ids() ? "ids" : row.channels, name_of(row.filter), row.unit,
                        row.about);
  return text +
         "Filters: mean (by area), nearest (to the eye), coverage (area of each id), pixel.\n";
}

nlohmann::ordered_json layers_json() {
  auto layers = nlohmann::ordered_json::array();
  for (const LayerRow& row : layer_table())
    layers.push_back({{"name", row.name},
                      {"channels", row.channels},
                      {"type", row.holds_ids() ? "ids" : "float"},
                      {"filter", name_of(row.filter)},
                      {"unit", row.unit},
                      {"about", row.about}});
  return layers;
}

/// The subject of `info`: the scene at one moment, prepared as for rendering. Preparation finds out
/// which features the scene uses.
struct Told {
  Scene scene;
  std::shared_ptr<const RenderScene> ready;
};

Result<Told> prepared_for_info(const InfoArguments& arguments) {
  Result<Scene> scene = open_scene_argument(arguments.scene, {.keep_posable = arguments.clip.any(),
                                                              .variant = arguments.variant,
                                                              .scene = arguments.scene_of_file,
                                                              .asset_root = arguments.asset_root});
  if (!scene) return tl::unexpected(scene.error());
  const RenderFeatures forced = forced_by(arguments.render_features);
  const auto time = clip_time(scene->contents, arguments.scene, arguments.clip);
  if (!time) return tl::unexpected(time.error());
  auto ready = prepare(*scene, forced);
  if (*time && ready) {
    scene = scene->rig->pose(*time);
    if (!scene) return tl::unexpected(scene.error());
    ready = prepare(*scene, forced, &(*ready)->geometry->stage);
  }
  if (forced.boundaries) ready = std::move(ready).and_then(with_boundaries);
  if (!ready) return tl::unexpected(ready.error());
  return Told{*std::move(scene), *std::move(ready)};
}

int run_info(const InfoArguments& arguments, const Streams& streams) {
  if (arguments.layers) {
    streams.out << (arguments.json ? json_text(layers_json()) : layers_text());
    return exit_ok;
  }
  const Result<Told> told = prepared_for_info(arguments);
  if (!told) return fail(streams, told.error());
  const nlohmann::ordered_json info = scene_info_json(told->scene, *told->ready);
  if (arguments.json)
    streams.out << json_text(info);
  else
    streams.out << scene_info_text(
        info, arguments.all ? std::numeric_limits<std::size_t>::max() : most_lines_a_list);
  return exit_ok;
}

}  // namespace

Command add_info_command(CLI::App& program) {
  const auto arguments = std::make_shared<InfoArguments>();
  CLI::App* parser = program.add_subcommand(
      "info", "List contents, unsupported features and skipped work of a scene");
  add_scene_argument(*parser, arguments->scene, true);
  parser->get_option("SCENE")->required(false);  // as --layers needs none
  add_scene_choices(*parser, arguments->scene_of_file, arguments->variant, arguments->asset_root);
  add_clip_options(*parser, arguments->clip);
  add_needs_option(*parser, arguments->render_features);
  parser->add_flag("--json", arguments->json, "Print JSON");
  parser->add_flag(
      "--all", arguments->all,
      fmt::format("List all entries of long lists [the first {} of each; JSON has all]",
                  most_lines_a_list));
  parser->add_flag("--layers", arguments->layers,
                   "List the layers that render writes, with channels, filters and units");
  parser->callback([arguments, parser] {
    if (parser->count("SCENE") == 0 && !arguments->layers) throw CLI::RequiredError("SCENE");
  });
  parser->footer(
      "Examples:\n  asos info model.glb\n  asos info builtin:office --json\n"
      "  asos info model.glb --needs all   # what it takes when nothing is left out");
  return {parser, [arguments](const Streams& streams) { return run_info(*arguments, streams); }};
}

}  // namespace asos
