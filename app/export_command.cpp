#include "app/command.h"
#include "app/exit_code.h"
#include "app/output_file.h"
#include "app/scene_argument.h"
#include "renderer/files/counted.h"
#include "renderer/gltf/load.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <ostream>

namespace asos {
namespace {

struct ExportArguments {
  std::string name;
  std::string output;
};

int run_export(const ExportArguments& arguments, const Streams& streams) {
  const Result<OutputFile> file = OutputFile::plan(arguments.output);
  if (!file) return fail(streams, file.error());
  const Result<Scene> scene = make_builtin_scene(arguments.name);
  if (!scene) return fail(streams, scene.error());
  const Result<void> written =
      file->commit([&](const std::string& path) { return export_gltf(*scene, path); });
  if (!written) return fail(streams, written.error());
  streams.out << fmt::format("Wrote {} ({}).\n", printable(file->path()),
                             counted(scene->instanced_triangles(), "triangle"));
  return exit_ok;
}

}  // namespace

Command add_export_command(CLI::App& program) {
  const auto arguments = std::make_shared<ExportArguments>();
  CLI::App* parser = program.add_subcommand("export-scene", "Write a built-in scene as glTF 2.0");
  parser->add_option("NAME", arguments->name, "Name of a built-in scene; see `asos list-scenes`")
      ->type_name("")
      ->required();
  parser
      ->add_option("-o,--output", arguments->output,
                   "File to write: .glb, or .gltf with embedded data")
      ->type_name("FILE.(glb|gltf)")
      ->required();
  parser->footer("Example:\n  asos export-scene office -o office.glb");
  parser->callback([arguments] {
    if (!has_extension(arguments->output, ".glb") && !has_extension(arguments->output, ".gltf"))
      throw CLI::ValidationError("-o",
                                 "\"" + arguments->output + "\": has to end in .glb or .gltf");
  });
  return {parser, [arguments](const Streams& streams) { return run_export(*arguments, streams); }};
}

}  // namespace asos
