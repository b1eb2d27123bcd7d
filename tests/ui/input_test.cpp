#include "ui/input.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <string>

namespace asos {
using namespace ui;
namespace {

class InputTest : public testing::Test {
 protected:
  InputTest() { ImGui::CreateContext(); }
  ~InputTest() override { ImGui::DestroyContext(); }

  ImGuiIO& io() { return ImGui::GetIO(); }
  InputQueue queue;
};

TEST_F(InputTest, AClickShorterThanAFrameIsSeenInTwoFrames) {
  queue.add(MouseChanged{MouseButton::left, true});
  queue.add(MouseChanged{MouseButton::left, false});
  queue.feed(io());
  EXPECT_TRUE(io().MouseDown[0]);
  EXPECT_FALSE(queue.empty());
  queue.feed(io());
  EXPECT_FALSE(io().MouseDown[0]);
  EXPECT_TRUE(queue.empty());
}

TEST_F(InputTest, ManyMovesCostOneFrame) {
  for (int i = 0; i < 100; ++i) queue.add(MouseMoved{{static_cast<float>(i), 5.0f}});
  queue.feed(io());
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(io().MousePos.x, 99.0f);
}

TEST_F(InputTest, APressWaitsForThePointerToArrive) {
  queue.add(MouseMoved{{10.0f, 20.0f}});
  queue.add(MouseChanged{MouseButton::left, true});
  queue.feed(io());
  EXPECT_EQ(io().MousePos.y, 20.0f);
  EXPECT_FALSE(io().MouseDown[0]);
  queue.feed(io());
  EXPECT_TRUE(io().MouseDown[0]);
}

TEST_F(InputTest, ADragKeepsItsOrder) {
  queue.add(MouseChanged{MouseButton::left, true});
  queue.add(MouseMoved{{50.0f, 0.0f}});
  queue.add(MouseChanged{MouseButton::left, false});
  queue.feed(io());
  EXPECT_TRUE(io().MouseDown[0]);
  EXPECT_NE(io().MousePos.x, 50.0f);
  // The last stretch still belongs to the drag.
  queue.feed(io());
  EXPECT_EQ(io().MousePos.x, 50.0f);
  EXPECT_TRUE(io().MouseDown[0]);
  queue.feed(io());
  EXPECT_FALSE(io().MouseDown[0]);
  EXPECT_TRUE(queue.empty());
}

TEST_F(InputTest, ModifiersFollowTheirKeys) {
  queue.add(KeyChanged{Key::ctrl, true});
  queue.feed(io());
  EXPECT_TRUE(io().KeyCtrl);
  queue.add(WheelTurned{{0.0f, 2.0f}});
  queue.feed(io());
  EXPECT_EQ(io().MouseWheel, 2.0f);
  EXPECT_TRUE(io().KeyCtrl);
}

TEST_F(InputTest, FastTypingFitsIntoOneFrame) {
  for (const char c : std::string("path")) {
    queue.add(KeyChanged{c == 'a' ? Key::a : c == 'p' ? Key::p : Key::none, true});
    queue.add(TextTyped{static_cast<char32_t>(c)});
  }
  queue.feed(io());
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(io().InputQueueCharacters.Size, 4);
}

TEST_F(InputTest, EnterWaitsForTheTextBeforeIt) {
  queue.add(TextTyped{U'x'});
  queue.add(KeyChanged{Key::enter, true});
  queue.feed(io());
  EXPECT_FALSE(io().KeysDown[static_cast<int>(Key::enter)]);
  queue.feed(io());
  EXPECT_TRUE(io().KeysDown[static_cast<int>(Key::enter)]);
}

TEST_F(InputTest, AWheelTurnKeepsItsModifier) {
  queue.add(KeyChanged{Key::ctrl, true});
  queue.add(WheelTurned{{0.0f, 1.0f}});
  queue.add(KeyChanged{Key::ctrl, false});
  queue.feed(io());
  EXPECT_TRUE(io().KeyCtrl);
  EXPECT_EQ(io().MouseWheel, 1.0f);
  queue.feed(io());
  EXPECT_FALSE(io().KeyCtrl);
}

TEST_F(InputTest, LosingTheFocusReleasesEverything) {
  queue.add(KeyChanged{Key::ctrl, true});
  queue.add(MouseChanged{MouseButton::middle, true});
  queue.feed(io());
  queue.add(FocusLost{});
  queue.feed(io());
  EXPECT_FALSE(io().KeyCtrl);
  EXPECT_FALSE(io().MouseDown[2]);
  EXPECT_FALSE(io().KeysDown[static_cast<int>(Key::ctrl)]);
}

TEST_F(InputTest, UnknownKeysPassWithoutEffect) {
  queue.add(KeyChanged{Key::none, true});
  queue.feed(io());
  EXPECT_TRUE(queue.empty());
  for (const bool down : io().KeysDown) EXPECT_FALSE(down);
}

}  // namespace
}  // namespace asos
