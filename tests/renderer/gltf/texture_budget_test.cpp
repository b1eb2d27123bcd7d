#include "renderer/gltf/texture_budget.h"

#include "renderer/film/image_io.h"
#include "renderer/gltf/load.h"
#include "renderer/gltf/pictures/picture.h"
#include "renderer/scene/environment_cube.h"
#include "tests/renderer/gltf/gltf_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace asos::texture_budget_test {
namespace {

using gltf::DecodedImageSize;
using gltf::most_texels;
using gltf::shrinks_of;
using test::GltfBuilder;

std::uint64_t texels_after(const std::vector<DecodedImageSize>& claims) {
  const std::vector<int> shrinks = shrinks_of(claims);
  std::uint64_t texels = 0;
  for (std::size_t i = 0; i < claims.size(); ++i)
    texels += static_cast<std::uint64_t>(shrunk(claims[i].width, shrinks[i])) *
              static_cast<std::uint64_t>(shrunk(claims[i].height, shrinks[i]));
  return texels;
}

TEST(TextureBudget, PicturesOfTheirSizeStayAsTheyAre) {
  EXPECT_EQ(shrinks_of({}), std::vector<int>{});
  EXPECT_EQ(shrinks_of(std::vector<DecodedImageSize>{{4096, 4096, 20'000}}), std::vector<int>{1});
  // Ten textures of 4096 x 4096 from JPEG files.
  const std::vector<DecodedImageSize> rich(10, {4096, 4096, 2'500'000});
  EXPECT_EQ(shrinks_of(rich), std::vector<int>(10, 1));
  EXPECT_EQ(shrinks_of(std::vector<DecodedImageSize>{{8192, 8192, 7'000'000}}),
            std::vector<int>{1});
}

TEST(TextureBudget, TheLargestAreReducedFirst) {
  const std::vector<DecodedImageSize> claims{
      {16384, 16384, 1'000'000}, {512, 512, 1000}, {0, 0, 0}, {2048, 1024, 9000}};
  const std::vector<int> shrinks = shrinks_of(claims);
  EXPECT_EQ(shrinks, (std::vector<int>{4, 1, 1, 1}));
  for (const std::size_t count : {1u, 7u, 300u, 5000u}) {
    const std::vector<DecodedImageSize> many(count, {16384, 16384, 300});
    EXPECT_LE(texels_after(many), most_texels(300 * count)) << count;
  }
}

GltfBuilder with_picture(int width, int height) {
  const test::TemporaryFolder folder;
  const auto bytes = static_cast<std::size_t>(3 * width) * static_cast<std::size_t>(height);
  EXPECT_TRUE(write_png(folder.file("a.png"),
                        RgbImage{width, height, std::vector<std::uint8_t>(bytes, 77), {}}));
  const std::string png = test::content_of(folder.file("a.png"));
  GltfBuilder b = GltfBuilder::square();
  b.json["images"] = {{{"bufferView", b.view(png.data(), png.size())}, {"mimeType", "image/png"}}};
  return b;
}

TEST(TextureBudget, AReducedTextureIsShownAndSaid) {
  GltfBuilder b = with_picture(8192, 4096);
  b.json["textures"] = {{{"source", 0}}};
  b.json["materials"] = {{{"emissiveTexture", {{"index", 0}}}, {"emissiveFactor", {1, 1, 1}}}};
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  const test::TemporaryFolder folder;
  const auto scene = load_scene(folder.write("large.glb", b.glb()));
  ASSERT_TRUE(scene) << scene.error().message();
  ASSERT_EQ(scene->images.size(), 1u);
  EXPECT_EQ(scene->images[0].width, 4096);
  EXPECT_EQ(scene->images[0].height, 2048);
  EXPECT_EQ(scene->images[0].rgba[4], 77);
  const std::vector<std::string>& warnings = scene->notes.warnings;
  EXPECT_EQ(std::count(warnings.begin(), warnings.end(),
                       "image 0 '': the textures are more than a file of this size has use for; it "
                       "is shown with 4096 x 2048 pixels"),
            1);
}

TEST(TextureBudget, ACubeOfMoreThanAFileHasUseForIsLeftOut) {
  GltfBuilder b = with_picture(4096, 4096);
  b.json["extensionsUsed"] = {"EXT_lights_image_based"};
  b.json["extensions"]["EXT_lights_image_based"]["lights"] = {
      {{"specularImageSize", 4096},
       {"specularImages", {std::vector<int>(6, 0)}},
       {"irradianceCoefficients", std::vector<std::vector<double>>(9, {0.1, 0.1, 0.1})}}};
  b.json["scenes"][0]["extensions"] = {{"EXT_lights_image_based", {{"light", 0}}}};
  const test::TemporaryFolder folder;
  const auto scene = load_scene(folder.write("cube.glb", b.glb()));
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(scene->surroundings, nullptr);
  ASSERT_FALSE(scene->notes.warnings.empty());
  EXPECT_NE(scene->notes.warnings[0].find("more than a file of this size has use for"),
            std::string::npos)
      << scene->notes.warnings[0];
}

}  // namespace
}  // namespace asos::texture_budget_test
