#include "tests/fuzz/harness.h"

#include "tests/support/temporary_folder.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace asos::fuzz {

void require(bool holds, const std::string& promise) {
  if (holds) return;
  std::fprintf(stderr, "a promise is broken: %s\n", promise.c_str());
  std::abort();
}

std::string input_file(const std::string& name, const std::uint8_t* data, std::size_t size) {
  static const test::TemporaryFolder folder;
  return folder.write(name, std::string(reinterpret_cast<const char*>(data), size));
}

std::size_t mutated(std::string_view made, std::uint8_t* data, std::size_t size,
                    std::size_t most_bytes) {
  if (made.empty() || made.size() > most_bytes) return LLVMFuzzerMutate(data, size, most_bytes);
  std::memcpy(data, made.data(), made.size());
  return made.size();
}

}  // namespace asos::fuzz
