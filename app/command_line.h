#pragma once

#include "app/streams.h"

#include <string>
#include <vector>

namespace asos {

/// Runs the program with the words after its name and returns its exit code (exit_code.h). Without
/// a subcommand the words are the window's: `asos SCENE` is `asos view SCENE`.
[[nodiscard]] int run_command_line(std::vector<std::string> words, const Streams& streams);

}  // namespace asos
