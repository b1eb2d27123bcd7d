#include "renderer/stability/case.h"

#include <gtest/gtest.h>

#include <cctype>
#include <ostream>
#include <string>

namespace asos::stability {

// The text that GoogleTest prints for a parameter.
static void PrintTo(const Case& item, std::ostream* stream) {
  *stream << item.group << ": " << item.name;
}

namespace {

class StabilityQuick : public testing::TestWithParam<Case> {};

TEST_P(StabilityQuick, Holds) {
  const Finding finding = run_case(GetParam());
  ASSERT_EQ(finding.fault, "");
  const Outcome& o = finding.outcome;
  EXPECT_FALSE(o.quantity.empty());
  EXPECT_FALSE(o.reason.empty());
  EXPECT_TRUE(holds(finding)) << o.quantity << ": expected " << o.expected << ", got " << o.got
                              << ", error " << o.error << ", bound " << o.bound << " (" << o.reason
                              << "), pixels not finite " << o.bad_pixels;
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
