#include "renderer/stability/case.h"
#include "renderer/stability/picture.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <map>
#include <ostream>
#include <string>

namespace asos::stability {

// Printed by GoogleTest as the parameter.
static void PrintTo(const Case& item, std::ostream* stream) {
  *stream << item.group << ": " << item.name;
}

namespace {

/// Cases that need more than a hundredth of additional light to fail, with that amount.
const std::map<std::string, double>& coarse_cases() {
  static const std::map<std::string, double> cases{
      {"a card whose vertices themselves lie 1000 away", 0.015},
      {"a ball of 131,072 triangles in one pixel", 0.07},
      {"two cards through each other at 1e-4 radians", 0.36},
      {"24x24 of a picture of 16384x16384", 0.015},
      {"the same with jittered samples", 0.07},
      {"the built-in boxes inside one pixel", 0.08},
      {"the published rule and point leaves at MAX 6, EPS 0", 0.11},
      {"an object that is in and out 1024 times, MAX 3", 0.2},
      {"65536 Sobol points in one pixel", 0.014},
      {"one texel of 10000 in the dark, on a wall that faces it", 0.014},
      {"one texel of 1e+10 in the dark, on a wall that faces it", 0.014},
      {"one texel of 1e+30 in the dark, on a wall that faces it", 0.014},
      {"rays are spared where nothing is left", 0.13},
  };
  return cases;
}

/// The case with the lights of its first picture brighter by this fraction.
Finding brighter(const Case& item, double share) {
  const ErrorInjection first(InjectedError{1.0 + share, {}});
  return run_case(item);
}
/// The case with everything shifted by a hundredth of a pixel.
Finding aside(const Case& item) {
  const ErrorInjection first(InjectedError{1.0, {0.01, 0.007}});
  return run_case(item);
}
/// The finding with its value increased by this fraction.
Finding larger(Finding finding, double share) {
  Outcome& o = finding.outcome;
  o.got *= 1.0 + share;
  o.error = std::abs(o.got - o.expected);
  return finding;
}

// A bound as large as the bounded value would hold for any picture.
void expect_that_it_tells(const Case& item, const Finding& finding) {
  constexpr double usual = 0.01;
  const auto coarse = coarse_cases().find(item.name);
  const double share = coarse == coarse_cases().end() ? usual : coarse->second;
  const auto tells = [&](double more) {
    const Finding lit = brighter(item, more);
    // For darkness, counts and yes-no answers, brighter lights change nothing.
    return !holds(lit.outcome.got == finding.outcome.got ? larger(finding, more) : lit);
  };
  const bool tells_usual = tells(usual) || !holds(aside(item));
  if (finding.outcome.expected == 0.0) {
    EXPECT_LE(finding.outcome.bound, 1e-3);
    return;
  }
  EXPECT_TRUE(tells_usual || tells(share))
      << finding.outcome.got << ", bound " << finding.outcome.bound;
  const bool excused = coarse != coarse_cases().end();
  EXPECT_EQ(tells_usual, !excused) << "this exception is no longer needed";
}

class StabilityQuick : public testing::TestWithParam<Case> {};

TEST_P(StabilityQuick, HoldsAndTellsAHundredth) {
  const Finding finding = run_case(GetParam());
  ASSERT_EQ(finding.fault, "");
  const Outcome& o = finding.outcome;
  EXPECT_FALSE(o.quantity.empty());
  EXPECT_FALSE(o.reason.empty());
  EXPECT_TRUE(holds(finding)) << o.quantity << ": expected " << o.expected << ", got " << o.got
                              << ", error " << o.error << ", bound " << o.bound << " (" << o.reason
                              << "), pixels not finite " << o.bad_pixels;
  expect_that_it_tells(GetParam(), finding);
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
