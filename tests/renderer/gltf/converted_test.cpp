#include "renderer/gltf/converted.h"

#include "renderer/files/helper_program.h"
#include "renderer/load_progress.h"
#include "renderer/scene/source_files.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
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

// The beginning of a file of each kind, which broken ones continue.
const std::pair<const char*, std::string> beginnings[]{
    {"a.obj", quad_obj},
    {"a.stl", triangle_stl},
    {"a.ply", triangle_ply},
    {"a.off", triangle_off},
    {"a.fbx", std::string("Kaydara FBX Binary  \0\x1a\0\xe8\x1c\0\0", 27)},
    {"a.dae",
     "<COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'>"
     "<library_geometries><geometry id='g'><mesh/></geometry></library_geometries></COLLADA>"},
    {"a.3mf", std::string("PK\3\4\24\0\0\0\10\0", 10)},
    {"a.3ds", std::string("MM\40\0\0\0\2\0\12\0\0\0\3\0\0\0", 16)},
    {"a.x3d", "<X3D version='3.3'><Scene><Shape><IndexedFaceSet coordIndex='0 1 2 -1'/></Shape>"}};

std::vector<std::string> broken(const std::string& whole) {
  std::string zeros = whole, flipped = whole, numbers = whole;
  std::fill(zeros.begin() + static_cast<std::ptrdiff_t>(whole.size() / 2), zeros.end(), '\0');
  for (std::size_t i = 5; i < whole.size(); i += 7) flipped[i] = static_cast<char>(~flipped[i]);
  std::replace(numbers.begin(), numbers.end(), '1', 'x');
  return {"",
          "rubbish\n",
          std::string(5000, '\xff'),
          std::string(5000, '\0'),
          whole.substr(0, whole.size() - 8),  // shorter PLYs keep assimp busy to its limit of time
          whole.substr(0, whole.size() - 5),
          whole.substr(0, whole.size() - 2),
          zeros,
          flipped,
          numbers};
}

// Ten broken files of each kind. Some show a part; all others are errors that name the file.
TEST_F(ConvertedTest, BrokenFilesAreErrorsThatNameTheFile) {
  const auto leftovers = [] {
    std::size_t folders = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::temp_directory_path()))
      folders += entry.path().filename().string().starts_with("asos-converted-");
    return folders;
  };
  const test::TemporaryFolder temporary;
  setenv("TMPDIR", temporary.path().c_str(), 1);
  int errors = 0;
  for (const auto& [name, whole] : beginnings) {
    int number = 0;
    for (const std::string& bytes : broken(whole)) {
      const Result<Scene> scene = load_scene(folder.write(name, bytes));
      const bool rubbish = number++ < 4;
      EXPECT_FALSE(rubbish && scene) << name << " " << number;
      if (scene) {
        EXPECT_GT(scene->meshes.size(), 0u) << name << " " << number;
        continue;
      }
      ++errors;
      EXPECT_EQ(scene.error().subject, folder.file(name));
      EXPECT_FALSE(scene.error().reason.empty());
      EXPECT_EQ(scene.error().reason.find("asos-converted"), std::string::npos)
          << scene.error().reason;
    }
  }
  EXPECT_GE(errors, 60);
  EXPECT_EQ(leftovers(), 0u);
  unsetenv("TMPDIR");
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

// Another file was opened while assimp works: its process ends.
TEST(ConvertedLoad, StopsWhileTheProgramWorks) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.stl", triangle_stl);
  const std::string program =
      folder.write("assimp", "#!/bin/sh\ntouch " + folder.file("begun") + "\nexec sleep 1000\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const std::string before = std::getenv("PATH");
  setenv("PATH", (folder.path().string() + ":" + before).c_str(), 1);
  LoadProgress progress;
  std::thread other([&] {
    while (!std::filesystem::exists(folder.file("begun"))) std::this_thread::yield();
    progress.stop();
  });
  {
    const LoadProgress::Scope scope(&progress);
    EXPECT_THROW((void)load_scene(path), LoadStopped);
  }
  other.join();
  setenv("PATH", before.c_str(), 1);
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
