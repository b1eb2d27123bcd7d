#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/ui_rig.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

// Files outside a scene's asset root are read only after a button allowed it.

namespace asos::test::asset_root_test {
using namespace ui;
namespace {

class AssetRootTest : public testing::Test {
 protected:
  AssetRootTest() {
    rig.set_pixel_size(3);
    std::filesystem::create_directories(folder.path() / "a/b/c/d/e");
  }
  /// Opens a file in a/b/c/d/e; returns true once loading has ended.
  bool open(const std::string& gltf) {
    OpenScene& scene = rig.scene();
    scene.open(folder.write("a/b/c/d/e/s.gltf", gltf));
    return loaded();
  }
  bool loaded() {
    OpenScene& scene = rig.scene();
    if (!rig.frames_until([&] { return !scene.loading() && (scene.get() || scene.error()); }))
      return false;
    rig.frame();
    return !scene.get() || rig.settle();
  }
  std::string outer() const { return std::filesystem::canonical(folder.path() / "a").string(); }

  TemporaryFolder folder;
  UiRig rig{LoadFunction(), {660, 1000}};
};

TEST_F(AssetRootTest, ABufferOutsideIsAllowedFromTheMessage) {
  const GltfBuilder square = GltfBuilder::square();
  folder.write("a/square.bin", square.bin);
  ASSERT_TRUE(open(square.gltf("../../../../square.bin")));
  OpenScene& scene = rig.scene();
  ASSERT_TRUE(scene.error());
  EXPECT_EQ(scene.outer_root(), outer());
  rig.click("Allow folder");
  ASSERT_TRUE(loaded());
  EXPECT_FALSE(scene.error());
  ASSERT_NE(scene.get(), nullptr);
  EXPECT_EQ(scene->world().triangles.size(), 2u);
  EXPECT_EQ(scene.outer_root(), "");
  // The folder stays allowed.
  scene.reload();
  ASSERT_TRUE(rig.frames_until([&] { return !scene.loading(); }));
  EXPECT_FALSE(scene.error());
}

TEST_F(AssetRootTest, ATextureOutsideIsAllowedFromTheWarnings) {
  GltfBuilder square = GltfBuilder::square();
  folder.write("a/gone_later.png", "no picture");
  square.json["images"] = {{{"uri", "../../../../gone_later.png"}}};
  square.json["textures"] = {{{"source", 0}}};
  square.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  square.json["meshes"][0]["primitives"][0]["material"] = 0;
  ASSERT_TRUE(open(square.gltf()));
  OpenScene& scene = rig.scene();
  ASSERT_NE(scene.get(), nullptr);
  EXPECT_EQ(scene.outer_root(), outer());
  const std::uint64_t before = scene.times_opened();
  rig.unfold("Warnings");
  rig.click("Allow folder");
  ASSERT_TRUE(rig.frames_until([&] { return scene.times_opened() > before; }));
  EXPECT_EQ(scene.outer_root(), "") << "it was read, though it is no picture";
  rig.frame();
  EXPECT_FALSE(rig.controls().contains("Allow folder"));
}

}  // namespace
}  // namespace asos::test::asset_root_test
