#include "ui/panels/whole_words.h"

#include <gtest/gtest.h>

namespace asos::test::whole_words_test {
using namespace ui;
namespace {

std::string in_letters(std::string_view text, float room) {
  return in_whole_words(text, room,
                        [](const std::string& s) { return static_cast<float>(s.size()); });
}

TEST(WholeWords, ANumberIsNeverBroken) {
  EXPECT_EQ(in_letters("0.6259  0.5646  0.4481", 20.0f), "0.6259  0.5646 \n0.4481");
  EXPECT_EQ(in_letters("0.6259  0.5646  0.4481", 22.0f), "0.6259  0.5646  0.4481");
  EXPECT_EQ(in_letters("0.6259  0.5646  0.4481", 8.0f), "0.6259 \n0.5646 \n0.4481");
}

TEST(WholeWords, WhatIsWiderStaysWholeAndNothingIsLost) {
  EXPECT_EQ(in_letters("/a/long/path/of.glb", 5.0f), "/a/long/path/of.glb");
  EXPECT_EQ(in_letters("in /a/long/path.glb now", 5.0f), "in\n/a/long/path.glb\nnow");
  EXPECT_EQ(in_letters("", 5.0f), "");
  EXPECT_EQ(in_letters(" one", 9.0f), " one");
  EXPECT_EQ(in_letters("one ", 9.0f), "one ");
}

}  // namespace
}  // namespace asos::test::whole_words_test
