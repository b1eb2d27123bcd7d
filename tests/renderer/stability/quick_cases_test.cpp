#include "renderer/stability/case.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <map>
#include <ostream>
#include <string>

namespace asos::stability {

// The text that GoogleTest prints for a parameter.
static void PrintTo(const Case& item, std::ostream* stream) {
  *stream << item.group << ": " << item.name;
}

namespace {

/// What cases tell that tell less than a fiftieth, as shares of what they expect.
const std::map<std::string, double>& coarse_cases() {
  static const std::map<std::string, double> cases{
      {"a ball of 131,072 triangles in one pixel", 0.07},
      {"two cards through each other at 1e-4 radians", 0.36},
      {"the same with jittered samples", 0.07},
      {"the built-in boxes inside one pixel", 0.08},
      {"the published rule and point leaves at MAX 6, EPS 0", 0.11},
      {"an object that is in and out 1024 times, MAX 3", 0.29},
      {"TR 8 on a texture 16384 wide, at points", 0.07},
      {"coordinates moved by 1024 repeats", 0.15},
      {"rays are spared where nothing is left", 0.13},
  };
  return cases;
}

/// The finding with its figure larger by this share: as when a light was, or what a pixel shows.
Finding larger(Finding finding, double share) {
  Outcome& o = finding.outcome;
  o.got *= 1.0 + share;
  o.error = std::abs(o.got - o.expected);
  return finding;
}

// A bound as wide as what it is the bound of would hold whatever was rendered.
void expect_that_it_tells(const Finding& finding) {
  constexpr double usual = 0.02;
  const Outcome& o = finding.outcome;
  if (o.expected == 0.0) {
    EXPECT_LE(o.bound, 1e-3);
    return;
  }
  const auto coarse = coarse_cases().find(finding.name);
  const double share = coarse == coarse_cases().end() ? usual : coarse->second;
  EXPECT_FALSE(holds(larger(finding, share))) << o.got << ", bound " << o.bound;
  const bool excused = coarse != coarse_cases().end();
  EXPECT_EQ(holds(larger(finding, usual)), excused) << "an exception that is none any more";
}

class StabilityQuick : public testing::TestWithParam<Case> {};

TEST_P(StabilityQuick, HoldsAndTellsTwoPerCent) {
  const Finding finding = run_case(GetParam());
  ASSERT_EQ(finding.fault, "");
  const Outcome& o = finding.outcome;
  EXPECT_FALSE(o.quantity.empty());
  EXPECT_FALSE(o.reason.empty());
  EXPECT_TRUE(holds(finding)) << o.quantity << ": expected " << o.expected << ", got " << o.got
                              << ", error " << o.error << ", bound " << o.bound << " (" << o.reason
                              << "), pixels not finite " << o.bad_pixels;
  expect_that_it_tells(finding);
}

std::string test_name(const testing::TestParamInfo<Case>& info) {
  std::string name;
  for (const char c : info.param.group + " " + info.param.name)
    name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name + "_" + std::to_string(info.index);
}

INSTANTIATE_TEST_SUITE_P(All, StabilityQuick, testing::ValuesIn(all_cases(true)), test_name);

}  // namespace
}  // namespace asos::stability
