#include "renderer/pyray/square.h"

#include <gtest/gtest.h>

namespace asos {
namespace {

TEST(Square, PartsRunFromLeftToRightThenDown) {
  const Square square{1.0f, 2.0f, 3.0f};
  const Square last_of_row = square.part(3, 2), first_of_next = square.part(3, 3);
  EXPECT_EQ(last_of_row.u, 3.0f);
  EXPECT_EQ(last_of_row.v, 2.0f);
  EXPECT_EQ(last_of_row.side, 1.0f);
  EXPECT_EQ(first_of_next.u, 1.0f);
  EXPECT_EQ(first_of_next.v, 3.0f);
}

TEST(Square, QuartersAreItsFourParts) {
  const Square square{-0.5f, 0.25f, 0.5f};
  for (int i = 0; i < 4; ++i) {
    const Square part = square.part(2, i), quarter = square.quarter(i);
    EXPECT_EQ(part.u, quarter.u) << i;
    EXPECT_EQ(part.v, quarter.v) << i;
    EXPECT_EQ(part.side, quarter.side) << i;
  }
}

}  // namespace
}  // namespace asos
