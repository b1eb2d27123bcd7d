#pragma once

#include "app/command_line.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace asos::test {

struct AsosRun {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs the program within the test, with standard streams that are no terminal.
inline AsosRun run_asos(std::vector<std::string> words) {
  std::ostringstream out;
  std::ostringstream err;
  const int exit_code = run_command_line(std::move(words), {out, err, false});
  return {exit_code, out.str(), err.str()};
}

/// Concatenates two lists of arguments.
inline std::vector<std::string> operator+(std::vector<std::string> a,
                                          const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Whether `text` contains `part`; the failure message shows the text.
inline testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "no \"" << part << "\" in:\n" << text;
}

}  // namespace asos::test
