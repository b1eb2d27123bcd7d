#include "app/report/machine.h"

#include "asos_commit.h"

#include <fmt/format.h>

#include <fstream>
#include <string>
#include <sys/utsname.h>
#include <thread>
#include <unistd.h>

namespace asos {
namespace {

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

std::string system_name() {
  utsname names{};
  if (uname(&names) != 0) return "unknown system";
  return fmt::format("{} {} {}", names.sysname, names.release, names.machine);
}

}  // namespace

Machine this_machine() {
  Machine machine;
  machine.processor = processor_name();
  machine.cores = static_cast<int>(std::thread::hardware_concurrency());
  machine.memory_gb = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                      static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e9;
  machine.system = system_name();
  machine.version = ASOS_VERSION;
  machine.commit = ASOS_COMMIT;
  machine.compiler = fmt::format("{} {}, {}",
#ifdef __clang__
                                 "Clang",
#else
                                 "GCC",
#endif
                                 __VERSION__, ASOS_BUILD_TYPE);
  return machine;
}

}  // namespace asos
