#include "tests/ui/previewer_fixture.h"

// Scenes replace each other; scenes that cannot be opened leave the old one.

namespace asos::test::opening_test {
using namespace ui;
namespace {

class OpeningTest : public PreviewerTest {};

TEST_F(OpeningTest, TheOpenSceneStaysWhenAnotherFails) {
  previewer.viewpoint().set_picture_size(48, 32, now);
  previewer.scene().open("red");
  ASSERT_TRUE(opened("red"));
  previewer.scene().open("/no/such.glb");
  ASSERT_TRUE(update_until([&] { return previewer.scene().error().has_value(); }));
  EXPECT_EQ(previewer.scene().error()->message(), "/no/such.glb: there is no such file");
  EXPECT_EQ(previewer.scene()->geometry->source, "red");
  EXPECT_FALSE(previewer.scene().loading().has_value());
  ASSERT_TRUE(finished());

  // The next scene removes the message.
  previewer.scene().open("green");
  ASSERT_TRUE(opened("green"));
  EXPECT_FALSE(previewer.scene().error().has_value());
}

TEST_F(OpeningTest, ExceptionsOfTheLoaderAreErrors) {
  previewer.scene().open("huge");
  ASSERT_TRUE(update_until([&] { return previewer.scene().error().has_value(); }));
  EXPECT_EQ(previewer.scene().error()->reason, "not enough memory to load this scene");
  previewer.scene().open("odd");
  ASSERT_TRUE(update_until([&] { return previewer.scene().error().has_value(); }));
  EXPECT_EQ(previewer.scene().error()->message(), "odd: an odd thing");
}

TEST_F(OpeningTest, ANewerSceneReplacesOneThatLoads) {
  previewer.viewpoint().set_picture_size(48, 32, now);
  previewer.scene().open("slow");
  ASSERT_TRUE(update_until([&] { return loader.calls == 1; }));
  previewer.scene().open("green");
  previewer.scene().open("red");
  ASSERT_TRUE(previewer.scene().loading().has_value());
  EXPECT_EQ(previewer.scene().loading()->source, "red");
  loader.released = true;
  std::vector<std::string> seen;
  ASSERT_TRUE(update_until([&] {
    if (const RenderScene* scene = previewer.scene().get()) {
      if (seen.empty() || seen.back() != scene->geometry->source)
        seen.push_back(scene->geometry->source);
    }
    return !seen.empty() && seen.back() == "red";
  }));
  EXPECT_EQ(seen, std::vector<std::string>{"red"});
  EXPECT_EQ(loader.calls, 2) << "requests that were replaced early need not be loaded";
}

TEST_F(OpeningTest, ReplacingScenesWhileTheyRenderIsSafe) {
  previewer.viewpoint().set_picture_size(160, 120, now);
  for (int i = 0; i < 20; ++i) {
    const std::string source = i % 2 == 0 ? "red" : "green";
    previewer.scene().open(source);
    ASSERT_TRUE(opened(source)) << "scene " << i;
  }
  ASSERT_TRUE(finished());
  previewer.update(now);
  EXPECT_EQ(previewer.render().film().radiance[previewer.render().film().index(80, 60)],
            glm::vec3(0, 1, 0));
}

TEST_F(OpeningTest, ReplacingASceneWhoseBoundariesAreLookedForIsSafe) {
  previewer.viewpoint().set_picture_size(64, 48, 0.0);
  std::weak_ptr<const Geometry> before;
  for (const char* source : {"many", "green", "many"}) {
    previewer.scene().open(source);
    ASSERT_TRUE(opened(source));
    // Waits for the coarse picture only.
    ASSERT_TRUE(update_until([&] { return !previewer.render().first_picture_pending(); }));
    EXPECT_TRUE(before.expired()) << "the scene before " << source;
    before = previewer.scene()->geometry;
  }
  // The previewer is destroyed while it searches the edges of the last scene.
}

TEST_F(OpeningTest, EndsWhileALoadIsWaiting) {
  previewer.scene().open("slow");
  ASSERT_TRUE(update_until([&] { return loader.calls == 1; }));
  previewer.scene().open("red");
  loader.released = true;
}

}  // namespace
}  // namespace asos::test::opening_test
