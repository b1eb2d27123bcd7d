#include "ui/equal_time.h"

#include "renderer/comparison/method.h"
#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

#include <string>

namespace asos {
using namespace ui;
namespace {

using EqualTimeTest = test::PanelsTest;

TEST_F(EqualTimeTest, ShowsTheRivalBesideThePicture) {
  ASSERT_TRUE(rig.opens("point light") && rig.settle());
  const UiState& state = rig.state();
  rig.unfold("Compare");
  rig.click_each({"With/Method"});
  const auto& all = rig.controls();
  for (const MethodRow& row : method_table())
    EXPECT_EQ(all.contains(std::string("Other method/") + row.title), can_be_timed(row))
        << row.name;
  rig.click("Other method/Stochastic");
  rig.click("Render and compare");
  ASSERT_TRUE(rig.frames_until([&] { return state.frames.stored.size() == 1; }));
  EXPECT_EQ(state.frames.comparison, Comparison::wipe);
  EXPECT_NE(state.frames.stored[0].summary.find("tochastic"), std::string::npos)
      << state.frames.stored[0].summary;
  rig.frame();
  EXPECT_FALSE(all.contains("Cancel comparison"));
  EXPECT_TRUE(all.contains("Render and compare"));
}

TEST_F(EqualTimeTest, ARivalCanBeStopped) {
  ASSERT_TRUE(rig.opens("point light") && rig.settle());
  rig.unfold("Compare");
  rig.click("With/Method");
  rig.click("Render and compare");
  const auto& all = rig.controls();
  ASSERT_TRUE(rig.frames_until(
      [&] { return all.contains("Cancel comparison") || !rig.state().frames.stored.empty(); }));
  if (!all.contains("Cancel comparison"))
    GTEST_SKIP() << "the rival was done before it could be stopped";
  rig.click("Cancel comparison");
  ASSERT_TRUE(rig.frames_until([&] { return !all.contains("Cancel comparison"); }));
  EXPECT_TRUE(rig.state().frames.stored.empty());
}

}  // namespace
}  // namespace asos
