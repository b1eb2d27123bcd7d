#pragma once

#include <string>

namespace asos {

/// Describes the machine and program of a measurement, for readers of the report.
struct Machine {
  std::string processor;
  int cores = 0;  ///< that the system shows
  double memory_gb = 0.0;
  std::string system;
  std::string version;   ///< of this program
  std::string commit;    ///< "-dirty" where files differ from it
  std::string compiler;  ///< with the kind of build

  bool operator==(const Machine&) const = default;
};

[[nodiscard]] Machine this_machine();

}  // namespace asos
