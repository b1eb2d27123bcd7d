#pragma once

#include "renderer/study/plan.h"

#include <set>
#include <string>

namespace asos {

/// The settings of one scene that exceeded the plan's time limit. Their other repetitions, and the
/// later settings of their curves, need not be tried.
class TimedOutSettings {
 public:
  // Only jobs for points are added or found.
  void add(const Job& job);
  [[nodiscard]] bool holds(const Job& job) const;

 private:
  std::set<std::string> settings_;
  std::set<std::string> curves_;
};

}  // namespace asos
