#include "renderer/stability/case.h"

#include <gtest/gtest.h>

#include <limits>
#include <new>
#include <set>
#include <utility>

namespace asos::stability {
namespace {

Finding finding_of(double error, double bound) {
  Finding finding;
  finding.outcome.error = error;
  finding.outcome.bound = bound;
  return finding;
}

TEST(StabilityCase, HoldsUpToItsBound) {
  EXPECT_TRUE(holds(finding_of(0.0, 0.0)));
  EXPECT_TRUE(holds(finding_of(0.1, 0.1)));
  EXPECT_FALSE(holds(finding_of(0.1000001, 0.1)));
}

TEST(StabilityCase, FailsForNaN) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(holds(finding_of(nan, 1.0)));
  EXPECT_FALSE(holds(finding_of(0.0, nan)));
  Finding without = finding_of(0.0, 1.0);
  without.fault = "no picture";
  EXPECT_FALSE(holds(without));
}

TEST(StabilityCase, IsBrokenByAPixelThatIsNotFinite) {
  Finding finding = finding_of(0.0, 1.0);
  finding.outcome.bad_pixels = 1;
  EXPECT_FALSE(holds(finding));
  finding.outcome.bad_pixels = 0;
  finding.outcome.rejected_samples = 1;  // rejected and reported, as it should be
  EXPECT_TRUE(holds(finding));
}

TEST(StabilityCase, FaultsAreTold) {
  const Finding refused = run_case({"name", "group", true, []() -> Result<Outcome> {
                                      return unexpected(Error{"scene", "has no camera"});
                                    }});
  EXPECT_EQ(refused.name, "name");
  EXPECT_EQ(refused.group, "group");
  EXPECT_EQ(refused.fault, "scene: has no camera");
  const Finding large =
      run_case({"", "", true, []() -> Result<Outcome> { throw std::bad_alloc(); }});
  EXPECT_EQ(large.fault, "not enough memory");
}

TEST(StabilityCases, AreAtLeastSixtyAndHaveNamesOfTheirOwn) {
  std::set<std::pair<std::string, std::string>> names;
  const auto all = all_cases(false);
  for (const Case& item : all) {
    EXPECT_FALSE(item.name.empty());
    names.emplace(item.group, item.name);
  }
  EXPECT_EQ(names.size(), all.size());
  const auto quick = all_cases(true);
  EXPECT_GE(quick.size(), 60u);
  EXPECT_LT(quick.size(), all.size());
  for (const Case& item : quick) EXPECT_TRUE(item.quick) << item.name;
}

}  // namespace
}  // namespace asos::stability
