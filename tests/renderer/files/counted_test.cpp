#include "renderer/files/counted.h"

#include <gtest/gtest.h>

namespace asos {
namespace {

TEST(Counted, OnlyOneIsSingular) {
  EXPECT_EQ(counted(0, "edge"), "0 edges");
  EXPECT_EQ(counted(1, "edge"), "1 edge");
  EXPECT_EQ(counted(2, "edge"), "2 edges");
  EXPECT_EQ(counted(1, "mesh", "meshes"), "1 mesh");
  EXPECT_EQ(counted(12'345, "mesh", "meshes"), "12345 meshes");
}

}  // namespace
}  // namespace asos
