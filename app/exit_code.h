#pragma once

namespace asos {

/// The exit status that the program returns to the shell.
enum ExitCode : int {
  exit_ok = 0,
  exit_bad_input = 1,      ///< a scene that cannot be opened, a file that cannot be written
  exit_usage = 2,          ///< an invalid command line
  exit_interrupted = 130,  ///< interrupted: 128 + SIGINT, also for SIGTERM
};

}  // namespace asos
