#include "renderer/shadows/light_view.h"

#include <gtest/gtest.h>

namespace asos::test::light_view_test {
namespace {

TEST(LightViews, KeepWhatIsWorthNoting) {
  LightViews views;
  views.add({0, false});
  EXPECT_TRUE(views.empty());
  views.add({5, true});
  EXPECT_FALSE(views.empty());
  EXPECT_TRUE(views.of(5).too_detailed);
  EXPECT_EQ(views.of(3).light, 3u);
  EXPECT_FALSE(views.of(3).too_detailed);
  EXPECT_FALSE(views.of(0).too_detailed);
  views.clear();
  EXPECT_TRUE(views.empty());
}

}  // namespace
}  // namespace asos::test::light_view_test
