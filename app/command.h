#pragma once

#include "app/streams.h"
#include "renderer/result.h"

#include <functional>

namespace CLI {
class App;
}

namespace asos {

/// A subcommand: its parser, and the function to call after parsing. `run` returns the exit code.
struct Command {
  CLI::App* parser = nullptr;
  std::function<int(const Streams&)> run;
};

/// Prints the error and returns the exit code for bad input.
int fail(const Streams& streams, const Error& error);

/// Each function adds its subcommand to the program's parser.
[[nodiscard]] Command add_view_command(CLI::App& program);
[[nodiscard]] Command add_render_command(CLI::App& program);
[[nodiscard]] Command add_trace_command(CLI::App& program);
[[nodiscard]] Command add_report_command(CLI::App& program);
[[nodiscard]] Command add_info_command(CLI::App& program);
[[nodiscard]] Command add_export_command(CLI::App& program);
[[nodiscard]] Command add_list_command(CLI::App& program);
[[nodiscard]] Command add_stability_command(CLI::App& program);

}  // namespace asos
