#include "renderer/prepared/rebuilt_geometry.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace asos::test::rebuilt_geometry_test {
namespace {

TEST(CopyDescription, CopiesNamesNotesContentsAndTime) {
  Scene scene;
  scene.name = "office";
  scene.source = "office.glb";
  scene.notes.warnings = {"a texture is missing"};
  scene.contents.variants = {"dark"};
  scene.time = ClipTime{1, 0.5};
  Geometry built, rebuilt;
  copy_description(scene, built);
  copy_description(built, rebuilt);
  EXPECT_EQ(rebuilt.name, "office");
  EXPECT_EQ(rebuilt.source, "office.glb");
  EXPECT_EQ(rebuilt.notes.warnings, std::vector<std::string>{"a texture is missing"});
  EXPECT_EQ(rebuilt.contents.variants, std::vector<std::string>{"dark"});
  ASSERT_TRUE(rebuilt.time);
  EXPECT_EQ(rebuilt.time->seconds, 0.5);
}

}  // namespace
}  // namespace asos::test::rebuilt_geometry_test
