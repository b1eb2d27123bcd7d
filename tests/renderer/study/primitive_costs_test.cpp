#include "renderer/study/primitive_costs.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace asos {
namespace {

TEST(PrimitiveCosts, AreTheRowsOfTable3) {
  const auto costs = primitive_costs(1);
  // GI'93 table 3, column Factor.
  const std::array<std::pair<const char*, double>, 6> published{{{"sphere", 1.01},
                                                                 {"polygon", 1.42},
                                                                 {"disk", 1.01},
                                                                 {"box", 1.19},
                                                                 {"cone", 2.40},
                                                                 {"cylinder", 5.40}}};
  ASSERT_EQ(costs.size(), published.size());
  for (std::size_t i = 0; i < costs.size(); ++i) {
    EXPECT_EQ(costs[i].name, std::string(published[i].first));
    EXPECT_EQ(costs[i].published, published[i].second);
    EXPECT_GT(costs[i].ray_ns, 0.0) << costs[i].name;
    EXPECT_GT(costs[i].cone_ns, 0.0) << costs[i].name;
    const bool curved =
        costs[i].name != std::string("polygon") && costs[i].name != std::string("box");
    EXPECT_EQ(costs[i].square_ns > 0.0, curved) << costs[i].name;
  }
}

}  // namespace
}  // namespace asos
