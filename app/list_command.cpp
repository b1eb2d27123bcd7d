#include "app/command.h"
#include "app/exit_code.h"
#include "renderer/scene/builtin.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <ostream>

namespace asos {

Command add_list_command(CLI::App& program) {
  CLI::App* parser = program.add_subcommand("list-scenes", "List the built-in scenes");
  parser->footer("Example:\n  asos list-scenes");
  return {parser, [](const Streams& streams) -> int {
            for (const BuiltinScene& scene : builtin_scenes())
              streams.out << fmt::format("builtin:{:<20} {}\n", scene.name, scene.summary);
            return exit_ok;
          }};
}

}  // namespace asos
