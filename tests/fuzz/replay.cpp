#include "tests/fuzz/harness.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>

// Replaces libFuzzer where it is missing: runs a harness on files, and on mutations of them,
// reproducibly. Usage: fuzz_NAME FOLDER_OR_FILE... [--mutations COUNT]; COUNT is per file. An input
// that crashes the program is kept as fuzz-failure.

namespace asos::fuzz {
namespace {

std::mt19937 random_bytes;
std::vector<std::uint8_t> current;
std::string current_name;

void keep_input(int signal) {
  const int file = ::creat("fuzz-failure", 0600);
  const bool kept = file >= 0 && ::write(file, current.data(), current.size()) >= 0;
  const std::string said =
      "fuzz: signal on " + current_name + (kept ? "; the input is kept as fuzz-failure\n" : "\n");
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, said.data(), said.size());
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

void run_current() {
  // A copy of exact size, so that reading past its end is detected.
  const std::vector<std::uint8_t> input(current);
  LLVMFuzzerTestOneInput(input.data(), input.size());
}

void run(const std::filesystem::path& file, unsigned mutations) {
  const std::string bytes = test::content_of(file);
  for (unsigned i = 0; i <= mutations; ++i) {
    constexpr std::size_t most_bytes = std::size_t{1} << 20;
    current.assign(bytes.begin(), bytes.end());
    current_name = file.string() + (i > 0 ? ", mutation " + std::to_string(i) : "");
    if (i > 0) {
      random_bytes.seed(i);
      const std::size_t size = current.size();
      current.resize(std::max(most_bytes, size));
      current.resize(LLVMFuzzerCustomMutator(current.data(), size, current.size(), i));
    }
    run_current();
  }
}

std::vector<std::filesystem::path> files_of(const std::filesystem::path& place) {
  if (!std::filesystem::is_directory(place)) return {place};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(place))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

int replay(const std::vector<std::string>& arguments) {
  unsigned mutations = 0;
  std::vector<std::filesystem::path> files;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--mutations" && i + 1 < arguments.size()) {
      mutations = static_cast<unsigned>(std::strtoul(arguments[++i].c_str(), nullptr, 10));
      continue;
    }
    const auto found = files_of(arguments[i]);
    files.insert(files.end(), found.begin(), found.end());
  }
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM})
    ::signal(signal, keep_input);
  for (const auto& file : files) run(file, mutations);
  std::printf("%zu files, %u mutations of each\n", files.size(), mutations);
  return files.empty() ? 1 : 0;
}

}  // namespace
}  // namespace asos::fuzz

// Flips bytes, like the simplest mutations of libFuzzer.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                        std::size_t most_bytes) {
  using asos::fuzz::random_bytes;
  if (size == 0 && most_bytes > 0) data[size++] = 0;
  for (unsigned flips = 1 + random_bytes() % 4; flips > 0 && size > 0; --flips)
    data[random_bytes() % size] = static_cast<std::uint8_t>(random_bytes());
  if (random_bytes() % 8 == 0) size = random_bytes() % size;
  return size;
}

int main(int count, char** words) {
  return asos::fuzz::replay({words + 1, words + count});
}
