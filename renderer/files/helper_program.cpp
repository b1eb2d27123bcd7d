#include "renderer/files/helper_program.h"

#include "renderer/files/printable.h"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace asos {

namespace {

constexpr std::chrono::milliseconds look_interval{20};

/// A temporary file for a program's error output.
class Complaints {
 public:
  Complaints() {
    std::error_code ignored;
    path_ = (std::filesystem::temp_directory_path(ignored) / "asos-helper-XXXXXX").string();
    file_ = mkstemp(path_.data());
  }
  ~Complaints() {
    if (file_ < 0) return;
    close(file_);
    unlink(path_.c_str());
  }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;

  [[nodiscard]] int file() const { return file_; }
  /// The last non-empty line.
  [[nodiscard]] std::string last_line() const {
    std::ifstream file(path_);
    std::string last;
    for (std::string line; std::getline(file, line);)
      if (!line.empty()) last = line;
    return printable(last);
  }

 private:
  std::string path_;
  int file_ = -1;
};

class Actions {
 public:
  Actions(const std::string& input, int complaints, QuotedOutput quoted) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO,
                                     input.empty() ? "/dev/null" : input.c_str(), O_RDONLY, 0);
    if (quoted == QuotedOutput::all && complaints >= 0)
      posix_spawn_file_actions_adddup2(&actions_, complaints, STDOUT_FILENO);
    else
      posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    if (complaints >= 0) posix_spawn_file_actions_adddup2(&actions_, complaints, STDERR_FILENO);
  }
  ~Actions() { posix_spawn_file_actions_destroy(&actions_); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

// Asks the program to end, and kills it if it has not ended after a second.
void end(pid_t child) {
  kill(child, SIGTERM);
  constexpr std::chrono::milliseconds patience{1000};
  for (std::chrono::milliseconds waited{0}; waited < patience; waited += look_interval) {
    if (waitpid(child, nullptr, WNOHANG) != 0) return;
    std::this_thread::sleep_for(look_interval);
  }
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

// Waits for the program and returns its status. Error: it was stopped.
Result<int> wait_for(pid_t child, const std::string& name, const std::function<bool()>& stop) {
  int status = 0;
  while (true) {
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child) return status;
    if (ended < 0 && errno != EINTR) return unexpected(Error{name, std::strerror(errno)});
    if (stop && stop()) {
      end(child);
      return unexpected(Error{name, "stopped"});
    }
    std::this_thread::sleep_for(look_interval);
  }
}

// Returns the command that starts a program within limits: prlimit of util-linux, which each Debian
// has, sets them and becomes the program.
Result<std::vector<std::string>> within(const ProgramLimits& limits,
                                        const std::vector<std::string>& command) {
  std::vector<std::string> all;
  const auto add = [&](const char* option, std::uint64_t most) {
    if (most > 0) all.push_back(fmt::format("--{}={}", option, most));
  };
  add("cpu", limits.processor_seconds);
  add("as", limits.memory_bytes);
  add("fsize", limits.file_bytes);
  if (all.empty()) return command;
  const std::string prlimit = find_program("prlimit");
  if (prlimit.empty()) return unexpected(Error{"prlimit", "is not installed (util-linux)"});
  all.insert(all.begin(), prlimit);
  all.emplace_back("--");
  all.insert(all.end(), command.begin(), command.end());
  return all;
}

}  // namespace

std::string find_program(const std::string& name) {
  const char* paths = std::getenv("PATH");
  std::istringstream folders(paths ? paths : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    std::error_code ignored;
    if (!folder.empty() && std::filesystem::is_regular_file(path, ignored) &&
        access(path.c_str(), X_OK) == 0)
      return path.string();
  }
  return {};
}

Result<void> run_program(const std::vector<std::string>& arguments, const std::string& input_file,
                         const std::function<bool()>& stop, const ProgramLimits& limits,
                         QuotedOutput quoted) {
  const std::string name = std::filesystem::path(arguments.front()).filename().string();
  Result<std::vector<std::string>> copies = within(limits, arguments);
  if (!copies) return unexpected(copies.error());
  std::vector<char*> list;
  for (std::string& argument : *copies) list.push_back(argument.data());
  list.push_back(nullptr);
  const Complaints complaints;
  const Actions actions(input_file, complaints.file(), quoted);
  pid_t child = 0;
  if (const int fault =
          posix_spawn(&child, list.front(), actions.get(), nullptr, list.data(), environ);
      fault != 0)
    return unexpected(Error{name, std::strerror(fault)});
  const Result<int> status = wait_for(child, name, stop);
  if (!status) return unexpected(status.error());
  if (WIFEXITED(*status) && WEXITSTATUS(*status) == 0) return {};
  const std::string how = WIFEXITED(*status)
                              ? fmt::format("ended with code {}", WEXITSTATUS(*status))
                              : fmt::format("was ended by signal {}", WTERMSIG(*status));
  const std::string why = complaints.last_line();
  return unexpected(Error{name, why.empty() ? how : fmt::format("{}: {}", how, why)});
}

}  // namespace asos
