#pragma once

#include "renderer/result.h"

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace asos {

/// The path of a program on $PATH; empty: it is not installed.
[[nodiscard]] std::string find_program(const std::string& name);

/// Runs a program by its arguments, of which the first is its path, without a shell, and waits
/// until it ends. It reads `input_file`, or nothing where that is empty. `stop` is asked some
/// dozens of times a second; once it says so, the program is ended. Errors name the program, and
/// what it wrote last.
[[nodiscard]] Result<void> run_program(const std::vector<std::string>& arguments,
                                       const std::string& input_file,
                                       const std::function<bool()>& stop);

}  // namespace asos
