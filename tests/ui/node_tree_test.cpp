#include "ui/node_tree.h"

#include "renderer/world/ground.h"
#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace asos::test::node_tree_test {
using namespace ui;
namespace {

/// root - (arm - hand, lamp), and a light without surfaces. Objects: 0 and 3 of the hand, 1 of the
/// lamp, 2 of the arm.
SceneContents contents() {
  return {.nodes = {{"root", -1}, {"arm", 0}, {"sun", 0}, {"hand", 1}, {"lamp", 0}},
          .object_nodes = {3, 4, 1, 3}};
}

std::string names(const NodeTree& tree, const std::set<int>& open) {
  std::string text;
  for (const NodeTree::Row& row : tree.rows(open))
    text += std::string(static_cast<std::size_t>(row.depth), '>') + tree.name(row.node) + " ";
  return text;
}

TEST(NodeTree, ShowsNodesThatHaveObjectsBelow) {
  const NodeTree tree(contents());
  EXPECT_EQ(names(tree, {}), "root ");
  EXPECT_EQ(names(tree, {0}), "root >arm >lamp ");
  EXPECT_EQ(names(tree, {0, 1, 3}), "root >arm >>hand >lamp ");
  EXPECT_EQ(names(tree, tree.open_at_first()), "root >arm >lamp ");
  EXPECT_TRUE(NodeTree(SceneContents{}).empty());
}

TEST(NodeTree, CountsTheObjectsBelowANode) {
  const NodeTree tree(contents());
  EXPECT_EQ(tree.objects(0), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(tree.objects(1), (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(tree.objects(3), (std::vector<int>{0, 3}));
  EXPECT_EQ(tree.object_count(4), 1u);
  EXPECT_EQ(tree.hidden_count(1, std::vector<int>{1, 2, 3}), 2u);
  EXPECT_EQ(tree.above(3), (std::vector<int>{1, 0}));
}

/// Three triangles in two nodes with a common parent.
Scene with_nodes(const std::string& source) {
  Scene scene = two_triangles({1, 0, 0}, source);
  add_triangle(scene, {-1, 1, 0}, {-0.5f, 1, 0}, {-0.7f, 1.3f, 0}, glm::vec3(0.0f, 1.0f, 0.0f));
  scene.contents.nodes = {{"root", -1}, {"left", 0}, {"right", 0}};
  scene.contents.object_nodes = {1, 2, 1};
  for (std::size_t i = 0; i < 3; ++i) scene.instances[i].node = scene.contents.object_nodes[i];
  return scene;
}

class NodeListTest : public testing::Test {
 protected:
  NodeListTest() {
    rig.set_pixel_size(3);
    EXPECT_TRUE(rig.opens("nodes") && rig.settle());
    rig.unfold("Objects");
    (void)rig.control("section/Scene");  // the list is laid out only if it is visible
    rig.frame();
  }
  [[nodiscard]] bool hides(const std::vector<int>& hidden) {
    return rig.frames_until(
        [&] { return rig.scene().hidden() == hidden && !rig.scene().loading(); });
  }

  UiRig rig{[](const std::string& source) -> Result<Scene> { return with_nodes(source); },
            {660, 1000}};
};

TEST_F(NodeListTest, ANodeIsHiddenWithAllBelowItAndShownAgain) {
  rig.click("Node visible/2");
  ASSERT_TRUE(hides({0, 2}));
  EXPECT_EQ(rig.scene()->world().parts.size(), 1u);
  // The other node is the last visible one, so it stays.
  rig.click_each({"Node visible/3"});
  EXPECT_EQ(rig.scene().hidden(), (std::vector<int>{0, 2}));
  EXPECT_FALSE(rig.scene().loading());
  rig.click("Node visible/2");
  ASSERT_TRUE(hides({}));
  EXPECT_EQ(rig.scene()->world().parts.size(), 3u);
}

// The default ground counted as an object, so that everything else could be hidden.
TEST_F(NodeListTest, TheGroundIsNoObject) {
  rig.settings().ground = Ground::on;
  const auto on_ground = [&] {
    return rig.frames_until([&] { return ground_of(rig.scene()->world()) == Ground::on; });
  };
  ASSERT_TRUE(on_ground());
  rig.frame();
  EXPECT_EQ(rig.control("Objects").words, "3");
  rig.click("Node/3");
  rig.click("Isolate");
  ASSERT_TRUE(hides({0, 2}));
  ASSERT_TRUE(on_ground());
  rig.frame();
  EXPECT_EQ(rig.control("Objects").words, "1");
  rig.click_each({"Node visible/3"});
  EXPECT_EQ(rig.scene().hidden(), (std::vector<int>{0, 2}));
  rig.click_each({"List by/Materials"});
  EXPECT_TRUE(rig.controls().contains("Object/1"));
  EXPECT_FALSE(rig.controls().contains("Object/2"));
}

TEST_F(NodeListTest, IsolateShowsOneNode) {
  rig.click("Node/3");
  rig.click("Isolate");
  ASSERT_TRUE(hides({0, 2}));
  rig.click("Show all");
  ASSERT_TRUE(hides({}));
}

TEST_F(NodeListTest, AClickInThePictureChoosesItsNode) {
  const Film& film = rig.film();
  rig.state().picked = glm::ivec2(film.width, film.height) / 2;
  rig.frame();
  EXPECT_EQ(rig.state().outline.node, 1);
  rig.click_each({"List by/Materials"});
  EXPECT_TRUE(rig.controls().contains("Object/1"));
}

}  // namespace
}  // namespace asos::test::node_tree_test
