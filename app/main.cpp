#include "app/command_line.h"
#include "app/exit_code.h"
#include "app/large_blocks.h"
#include "app/streams.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <new>
#include <sys/mman.h>
#include <unistd.h>

#ifndef ASOS_SANITIZED
// Large blocks (pictures, their levels, arrays of vertices) consist of huge pages where the system
// allows it, since the first access to each page costs as much as reading it several times.
void* operator new(std::size_t size) {
  constexpr std::size_t page = std::size_t{2} << 20;
  if (size < 2 * page) {
    if (void* const block = std::malloc(size > 0 ? size : 1)) return block;
  } else if (size <= static_cast<std::size_t>(-1) - page) {
    const std::size_t whole = (size + page - 1) / page * page;
    if (void* const block = std::aligned_alloc(page, whole)) {
      (void)madvise(block, whole, MADV_HUGEPAGE);  // without them, it is slower
      return block;
    }
  }
  throw std::bad_alloc();
}

void operator delete(void* block) noexcept {
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept {
  std::free(block);
}
#endif

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
