#pragma once

#include "renderer/result.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace asos {

/// The path of a program found in $PATH; empty: it is not installed.
[[nodiscard]] std::string find_program(const std::string& name);

/// Limits of the system on a program: it is ended, or its calls fail, beyond them. 0: none.
struct ProgramLimits {
  std::uint64_t processor_seconds = 0;
  std::uint64_t memory_bytes = 0;  ///< of its address space
  std::uint64_t file_bytes = 0;    ///< of each file that it writes
};

/// Runs a program without a shell and waits for its end. The first argument is its path.
/// `input_file` is its standard input; empty: none. `stop` is called dozens of times a second; the
/// program is killed once it returns true. Errors name the program and quote its last line of error
/// output, or of all output, as `quoted` asks.
enum class QuotedOutput { errors, all };
[[nodiscard]] Result<void> run_program(const std::vector<std::string>& arguments,
                                       const std::string& input_file,
                                       const std::function<bool()>& stop,
                                       const ProgramLimits& limits = {},
                                       QuotedOutput quoted = QuotedOutput::errors);

}  // namespace asos
