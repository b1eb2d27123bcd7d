#include "app/command_line.h"
#include "app/exit_code.h"
#include "app/large_blocks.h"
#include "app/streams.h"

#include <cerrno>
#include <cstring>
#include <iostream>
#include <unistd.h>

int main(int argc, char** argv) {
  asos::give_back_large_blocks();
  const asos::Streams streams{std::cout, std::cerr, isatty(STDERR_FILENO) != 0};
  const int code = asos::run_command_line({argv + (argc > 0 ? 1 : 0), argv + argc}, streams);
  // Output that could not be written, as on a full disk, is a failure.
  errno = 0;
  if (std::cout.flush()) return code;
  std::cerr << "asos: the answer cannot be written"
            << (errno != 0 ? std::string(": ") + std::strerror(errno) : "") << "\n";
  return code == asos::exit_ok ? asos::exit_bad_input : code;
}
