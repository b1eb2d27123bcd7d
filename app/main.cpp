#include "app/command_line.h"
#include "app/large_blocks.h"
#include "app/streams.h"

#include <iostream>
#include <unistd.h>

int main(int argc, char** argv) {
  asos::give_back_large_blocks();
  const asos::Streams streams{std::cout, std::cerr, isatty(STDERR_FILENO) != 0};
  return asos::run_command_line({argv + (argc > 0 ? 1 : 0), argv + argc}, streams);
}
