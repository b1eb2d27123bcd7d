#pragma once

#include "renderer/result.h"

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace asos::ui {

/// The path of a program found in $PATH; empty: it is not installed.
[[nodiscard]] std::string find_program(const std::string& name);

/// Runs a program without a shell and waits for its end. The first argument is its path.
/// `input_file` is its standard input; empty: none. `stop` is called dozens of times a second; the
/// program is killed once it returns true. Errors name the program and quote its last line of error
/// output.
[[nodiscard]] Result<void> run_program(const std::vector<std::string>& arguments,
                                       const std::string& input_file,
                                       const std::function<bool()>& stop);

}  // namespace asos::ui
