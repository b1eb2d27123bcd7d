#include "app/command_line.h"

#include "app/command.h"
#include "app/exit_code.h"
#include "app/report/machine.h"
#include "renderer/kernels/instruction_set.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>
#include <ostream>
#include <string>

namespace asos {
namespace {

// Returns the lines that `asos --version` prints: version, commit, compiler and features.
std::string version_text() {
  const Machine machine = this_machine();
  return fmt::format(
      "asos {}\n"
      "commit: {}\n"
      "compiler: {}\n"
      "instruction set: {}\n"
      "scenes: glTF 2.0 (.gltf, .glb), Draco, meshopt; others by assimp\n"
      "textures: PNG, JPEG, WebP\n"
      "skies: .hdr, .exr\n"
      "pictures: PNG, EXR",
      machine.version, machine.commit, machine.compiler, instruction_set());
}

constexpr const char* program_footer =
    "`asos [SCENE] [options]` is short for `asos view [SCENE] [options]`. SCENE is the path of a\n"
    ".gltf or .glb file, of a model that assimp converts (.obj, .stl, .ply, .fbx, .dae, ...), or\n"
    "builtin:NAME (`asos list-scenes` has the names).\n"
    "`asos COMMAND --help` lists a command's options with their units and defaults.\n"
    "\n"
    "Examples:\n"
    "  asos                                     open the built-in office in a window\n"
    "  asos model.glb --max 2                   open a model, with cells of 1/4 pixel or more\n"
    "  asos render builtin:house -o house.png   render to a file\n"
    "  asos info model.glb                      list contents and problems of a file\n"
    "\n"
    "Exit codes: 0 done, 1 bad input (scene or file), 2 bad command line, 130 interrupted.";

// Returns whether the first word is a subcommand or an option of the program itself. Any other word
// is for the window (`asos view`).
bool is_for_program(const CLI::App& program, const std::string& word) {
  constexpr std::array<const char*, 4> questions{"-h", "--help", "--help-all", "--version"};
  if (std::find(questions.begin(), questions.end(), word) != questions.end()) return true;
  const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
  return std::any_of(commands.begin(), commands.end(),
                     [&](const CLI::App* c) { return c->get_name() == word; });
}

int explain(const CLI::App& program, const CLI::ParseError& error, const Streams& streams) {
  std::string command = "asos";
  for (const CLI::App* used : program.get_subcommands()) command += " " + used->get_name();
  streams.err << fmt::format("{}: {}\nTry `{} --help`.\n", command, printable(error.what()),
                             command);
  return exit_usage;
}

int run_guarded(const Command& command, const Streams& streams) {
  try {
    return command.run(streams);
  } catch (const std::bad_alloc&) {
    streams.err << "asos: not enough memory for this scene and picture\n";
    return exit_bad_input;
  }
}

}  // namespace

int fail(const Streams& streams, const Error& error) {
  streams.err << "asos: " << error.message() << "\n";
  return exit_bad_input;
}

int run_command_line(std::vector<std::string> words, const Streams& streams) {
  CLI::App program(
      "ASOS: adaptive supersampling in object space. Previews and renders glTF 2.0 scenes; "
      "splits\npixels only where edges of objects cross them.",
      "asos");
  program.set_version_flag("--version", version_text,
                           "Print version, commit and features and exit");
  program.set_help_all_flag("--help-all", "Print the help of every command and exit");
  program.require_subcommand(1);
  program.footer(program_footer);
  const std::array commands{add_view_command(program),      add_render_command(program),
                            add_trace_command(program),     add_report_command(program),
                            add_stability_command(program), add_info_command(program),
                            add_export_command(program),    add_list_command(program)};

  // Subcommands inherit --help-all, and have no subcommands of their own to list.
  for (const Command& command : commands) command.parser->set_help_all_flag();

  if (words.empty() || !is_for_program(program, words.front())) words.insert(words.begin(), "view");
  std::reverse(words.begin(), words.end());  // CLI11 takes the words in reverse order
  try {
    program.parse(std::move(words));
  } catch (const CLI::Success& question) {  // help and version
    program.exit(question, streams.out, streams.err);
    return exit_ok;
  } catch (const CLI::ParseError& error) {
    return explain(program, error, streams);
  }
  for (const Command& command : commands)
    if (command.parser->parsed()) return run_guarded(command, streams);
  return exit_usage;
}

}  // namespace asos
