#pragma once

#include "app/streams.h"
#include "renderer/stability/case.h"

#include <string>
#include <vector>

namespace asos {

struct StabilityArguments {
  std::string folder;  ///< made if need be
  bool quick = false;  ///< the page notes that only the quick cases were run
};

/// Runs the cases, writes stability.html and stability.csv into the folder, and returns the exit
/// code: 1 if a case fails.
int run_stability(const StabilityArguments& arguments, const std::vector<stability::Case>& cases,
                  const Streams& streams);

}  // namespace asos
