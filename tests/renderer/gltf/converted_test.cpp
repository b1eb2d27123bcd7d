#include "renderer/gltf/converted.h"

#include "renderer/files/helper_program.h"
#include "renderer/scene/source_files.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace asos {
namespace {

// A quad with a material whose colour is red, as two files.
constexpr const char* quad_obj =
    "mtllib quad.mtl\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nusemtl red\nf 1 2 3 4\n";
constexpr const char* quad_mtl = "newmtl red\nKd 1 0 0\n";
constexpr const char* triangle_stl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
    "endloop\nendfacet\nendsolid a\n";
constexpr const char* triangle_ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
constexpr const char* triangle_off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

class ConvertedTest : public testing::Test {
 protected:
  void SetUp() override {
    if (find_program("assimp").empty()) GTEST_SKIP() << "assimp is not installed";
  }
  [[nodiscard]] static std::size_t triangles(const Scene& scene) {
    std::size_t count = 0;
    for (const Mesh& mesh : scene.meshes) count += mesh.triangles.size();
    return count;
  }
  test::TemporaryFolder folder;
};

TEST_F(ConvertedTest, OtherFormatsOpenWithAWarning) {
  folder.write("quad.mtl", quad_mtl);
  const struct {
    const char* name;
    const char* text;
    std::size_t triangles;
  } files[]{{"quad.obj", quad_obj, 2},
            {"a.stl", triangle_stl, 1},
            {"A.PLY", triangle_ply, 1},
            {"a.off", triangle_off, 1}};
  for (const auto& [name, text, expected] : files) {
    const std::string path = folder.write(name, text);
    const Result<Scene> scene = load_scene(path);
    ASSERT_TRUE(scene) << scene.error().message();
    EXPECT_EQ(triangles(*scene), expected) << name;
    EXPECT_EQ(scene->source, path);
    ASSERT_FALSE(scene->notes.warnings.empty());
    EXPECT_NE(scene->notes.warnings.back().find("assimp"), std::string::npos);
  }
  const Result<Scene> quad = load_scene(folder.file("quad.obj"));
  ASSERT_TRUE(quad);
  ASSERT_FALSE(quad->materials.empty());
  EXPECT_GT(quad->materials.back().base_color.x, 0.9f);
  EXPECT_LT(quad->materials.back().base_color.y, 0.1f);
}

// A TGA of one pixel, blue, and a BMP of one pixel, green.
const std::string blue_tga =
    std::string("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\30\0", 18) + "\xff" + std::string(2, '\0');
const std::string green_bmp =
    std::string("BM\72\0\0\0\0\0\0\0\66\0\0\0\50\0\0\0\1\0\0\0\1\0\0\0\1\0\30\0", 30) +
    std::string(24, '\0') + std::string("\0\xff\0\0", 4);

TEST_F(ConvertedTest, OldPicturesAreTextures) {
  folder.write("blue.tga", blue_tga);
  folder.write("green.bmp", green_bmp);
  folder.write("unused.tga", blue_tga);
  for (const char* name : {"blue.tga", "green.bmp"}) {
    folder.write("quad.mtl", std::string(quad_mtl) + "map_Kd " + name + "\n");
    const std::string path = folder.write(
        "quad.obj",
        "mtllib quad.mtl\nv 0 0 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl red\n"
        "f 1/1 2/2 3/3\n");
    const Result<Scene> scene = load_scene(path);
    ASSERT_TRUE(scene) << scene.error().message();
    EXPECT_EQ(scene->notes.warnings.size(), 1u) << name << ": " << scene->notes.warnings.front();
    ASSERT_EQ(scene->images.size(), 1u) << name;
    const Image& image = scene->images.front();
    ASSERT_EQ(image.rgba.get().size(), 4u) << name;
    EXPECT_EQ(image.rgba.get()[1], name[0] == 'g' ? 255 : 0);
    EXPECT_EQ(image.rgba.get()[2], name[0] == 'b' ? 255 : 0);
    EXPECT_EQ(source_files(path),
              (std::vector<std::string>{path, folder.file(name), folder.file("quad.mtl")}));
  }
}

TEST_F(ConvertedTest, NamesMayHaveAnotherEncoding) {
  folder.write("quad.mtl", "newmtl gr\xfcn\nKd 1 0 0\n");
  const Result<Scene> scene = load_scene(folder.write(
      "quad.obj", "mtllib quad.mtl\nv 0 0 0\nv 2 0 0\nv 2 1 0\nusemtl gr\xfcn\nf 1 2 3\n"));
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(scene->materials.back().name, "gr_n");
  EXPECT_EQ(scene->materials.back().base_color.x, 1.0f);
}

TEST_F(ConvertedTest, BrokenFilesAreErrorsThatNameTheFile) {
  for (const char* name :
       {"a.obj", "a.stl", "a.ply", "a.fbx", "a.dae", "a.3mf", "a.3ds", "a.x3d"}) {
    for (const std::string& bytes :
         {std::string(), std::string("rubbish\n"), std::string(5000, '\xff')}) {
      const Result<Scene> scene = load_scene(folder.write(name, bytes));
      ASSERT_FALSE(scene) << name;
      EXPECT_EQ(scene.error().subject, folder.file(name));
      EXPECT_FALSE(scene.error().reason.empty());
      EXPECT_EQ(scene.error().reason.find("asos-converted"), std::string::npos)
          << scene.error().reason;
    }
  }
  const Result<Scene> missing = load_scene(folder.file("none.obj"));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().reason, "there is no such file");
}

TEST_F(ConvertedTest, WithoutAssimpTheErrorSaysHowToInstallIt) {
  const std::string path = folder.write("a.stl", triangle_stl);
  const std::string before = std::getenv("PATH");
  setenv("PATH", folder.path().c_str(), 1);
  const Result<Scene> scene = load_scene(path);
  setenv("PATH", before.c_str(), 1);
  ASSERT_FALSE(scene);
  EXPECT_NE(scene.error().reason.find("apt-get install assimp-utils"), std::string::npos);
}

// A program that waits, computes or writes without end is ended by its limits.
TEST(HelperProgram, LimitsEndIt) {
  const Result<void> busy =
      run_program({"/bin/sh", "-c", "while :; do :; done"}, "", {}, {.processor_seconds = 1});
  EXPECT_FALSE(busy);
  const test::TemporaryFolder folder;
  const Result<void> big =
      run_program({"/bin/sh", "-c", "head -c 100000 /dev/zero >" + folder.file("big")}, "", {},
                  {.file_bytes = 4096});
  EXPECT_FALSE(big);
  EXPECT_LE(std::filesystem::file_size(folder.file("big")), 4096u);
  const Result<void> told =
      run_program({"/bin/sh", "-c", "echo out; exit 3"}, "", {}, {}, QuotedOutput::all);
  ASSERT_FALSE(told);
  EXPECT_NE(told.error().message().find("out"), std::string::npos);
}

}  // namespace
}  // namespace asos
