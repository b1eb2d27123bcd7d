#include "renderer/gltf/load.h"
#include "renderer/picture/picture_text.h"
#include "tests/ui/choice_fixture.h"
#include "tests/ui/test_scenes.h"

#include <gtest/gtest.h>

#include <string>

namespace asos::test::scenes_test {
using namespace ui;
namespace {

/// A scene of one square, and one of two distant squares; the second is the file's default.
GltfBuilder two_scenes() {
  GltfBuilder b = GltfBuilder::square();
  b.json["nodes"].push_back({{"mesh", 0}, {"translation", {30, 0, 0}}});
  b.json["scenes"] = {{{"nodes", {0}}, {"name", "One\n"}}, {{"nodes", {0, 1}}}};
  b.json["scene"] = 1;
  return b;
}

class Scenes : public ChoiceTest {
 protected:
  Scenes() : ChoiceTest("Scene", two_scenes()) {}
  [[nodiscard]] std::size_t triangles() { return scene()->world().triangles.size(); }
  [[nodiscard]] double distance() { return rig.camera().distance(); }
};

TEST_F(Scenes, AreChosenFromAList) {
  EXPECT_EQ(triangles(), 4u);
  const double far = distance();
  choose("0: One\\n");
  EXPECT_EQ(triangles(), 2u);
  EXPECT_LT(distance(), 0.2 * far) << "it is framed anew, not with the previous camera";
  choose("1");
  EXPECT_EQ(triangles(), 4u);
}

TEST_F(Scenes, StayWhereTheFileIsLoadedAgain) {
  choose("0: One\\n");
  const std::uint64_t opened = scene().times_opened();
  scene().reload();
  arrive(opened);
  EXPECT_EQ(triangles(), 2u);
}

TEST_F(Scenes, ComeBackWithSavedPictures) {
  EXPECT_EQ(rig.render().description({}).scene_number, -1) << "the file's own";
  choose("0: One\\n");
  const PictureDescription said = rig.render().description({});
  EXPECT_EQ(said.scene_number, 0);
  const std::string picture = folder_.file("one.png");
  ASSERT_TRUE(write_png(picture, rig.film(), {}, picture_text(said)));
  open("builtin:boxes");
  EXPECT_FALSE(rig.controls().contains("Scene"));
  open(picture);
  EXPECT_EQ(triangles(), 2u);
}

}  // namespace
}  // namespace asos::test::scenes_test
