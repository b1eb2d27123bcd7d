#pragma once

#include "renderer/study/plan.h"

#include <set>
#include <string>

namespace asos {

/// The settings of one scene that took longer than the plan allows: their other repetitions, and
/// what comes after them on their curves, need not be tried.
class GivenUp {
 public:
  // Other jobs than points are neither added nor held.
  void add(const Job& job);
  [[nodiscard]] bool holds(const Job& job) const;

 private:
  std::set<std::string> settings_;
  std::set<std::string> curves_;
};

}  // namespace asos
