#include "renderer/gltf/asset_root.h"
#include "renderer/gltf/data_uri.h"
#include "renderer/gltf/files.h"
#include "renderer/scene/source_files.h"
#include "tests/renderer/gltf/load_timer.h"
#include "tests/support/shared_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// Files referenced by URIs, and the folders that they may be in.

namespace asos {
namespace {

namespace fs = std::filesystem;

using test::GltfBuilder;
using test::load_in_time;
using test::TemporaryFolder;

/// Sets HOME during its lifetime.
class HomeFolder {
 public:
  explicit HomeFolder(const fs::path& path) {
    if (const char* before = std::getenv("HOME")) before_ = before;
    ::setenv("HOME", path.c_str(), 1);
  }
  ~HomeFolder() { before_ ? ::setenv("HOME", before_->c_str(), 1) : ::unsetenv("HOME"); }
  HomeFolder(const HomeFolder&) = delete;
  HomeFolder& operator=(const HomeFolder&) = delete;

 private:
  std::optional<std::string> before_;
};

/// a/b/c/d/e in a temporary folder, with a file x.bin in each folder; the model is in e.
class AssetFiles : public testing::Test {
 protected:
  AssetFiles() {
    fs::create_directories(model_);
    for (const char* name : {".", "a", "a/b", "a/b/c", "a/b/c/d", "a/b/c/d/e"})
      folder_.write(std::string(name) + "/x.bin", name);
  }
  [[nodiscard]] fs::path root() const { return gltf::asset_folders(model_, {}).value().root; }
  [[nodiscard]] fs::path at(const std::string& name) const {
    return fs::canonical(folder_.path()) / name;
  }
  /// The content of the file that a URI of the model names, or the error; followed by a warning, if
  /// any.
  [[nodiscard]] std::string read(const std::string& uri, const fs::path& asset_root = {}) const {
    gltf::ModelFiles files(gltf::asset_folders(model_, asset_root).value());
    const auto bytes = files.read(uri);
    if (!bytes) return bytes.error();
    const std::string text(bytes->bytes.begin(), bytes->bytes.end());
    return bytes->remark.empty() ? text : text + ": " + bytes->remark;
  }

  TemporaryFolder folder_;
  fs::path model_ = folder_.path() / "a/b/c/d/e";
};

TEST_F(AssetFiles, DefaultRootIsThreeLevelsUp) {
  EXPECT_EQ(root(), at("a/b"));
  EXPECT_EQ(read("x.bin"), "a/b/c/d/e");
  EXPECT_EQ(read("../x.bin"), "a/b/c/d");
  EXPECT_EQ(read("../../x.bin"), "a/b/c");
  EXPECT_EQ(read("%2e%2e/../../x.bin"), "a/b");
  EXPECT_EQ(read("../../../../x.bin"),
            "'../../../../x.bin' is refused: it leads out of the asset "
            "root '" +
                at("a/b").string() + "'; another one can be chosen (--asset-root)");
  EXPECT_NE(read("../../../../gone.bin").find("leads out of the asset root"), std::string::npos);
}

TEST_F(AssetFiles, DefaultRootIsBelowHomeAndFileSystem) {
  {
    const HomeFolder home(at("a/b"));
    EXPECT_EQ(root(), at("a/b/c"));
  }
  {
    // A model in the home folder itself may read only its own folder.
    const HomeFolder home(at("a/b/c/d/e"));
    EXPECT_EQ(root(), at("a/b/c/d/e"));
  }
  {
    const HomeFolder home(at("a/b/c/other"));
    EXPECT_EQ(root(), at("a/b/c/d")) << "c holds the home folder";
  }
  EXPECT_EQ(gltf::asset_folders("/usr", {}).value().root, "/usr");
  EXPECT_EQ(gltf::asset_folders("/", {}).value().root, "/");
}

TEST_F(AssetFiles, DefaultRootStaysOnItsDevice) {
  if (!fs::is_directory("/proc/self/fd")) GTEST_SKIP() << "no other file system is mounted";
  EXPECT_NE(gltf::asset_folders("/proc/self", {}).value().root, "/");
  EXPECT_EQ(gltf::asset_folders("/dev/shm", {}).value().root, "/dev/shm");
}

TEST_F(AssetFiles, ChosenRootReplacesTheDefault) {
  EXPECT_EQ(read("../../../../x.bin", at("a")), "a");
  EXPECT_NE(read("../../../../../x.bin", at("a")).find("asset root '" + at("a").string() + "'"),
            std::string::npos);
  // The model's own folder stays readable with another root.
  fs::create_directory(folder_.path() / "apart");
  folder_.write("apart/x.bin", "apart");
  EXPECT_EQ(read("../../../../../apart/x.bin", at("apart")), "apart");
  EXPECT_EQ(read("x.bin", at("apart")), "a/b/c/d/e");
  EXPECT_NE(read("../x.bin", at("apart")).find("leads out"), std::string::npos);
  EXPECT_EQ(
      gltf::asset_folders(model_, at("gone")).error(),
      "the asset root '" + at("gone").string() + "' cannot be read (No such file or directory)");
  EXPECT_EQ(gltf::asset_folders(model_, at("x.bin")).error(),
            "the asset root '" + at("x.bin").string() + "' is not a folder");
}

TEST_F(AssetFiles, DotSegmentsNeedNoFolder) {
  EXPECT_EQ(read("none/../x.bin"), "a/b/c/d/e");
  EXPECT_EQ(read("./none/.././../x.bin"), "a/b/c/d");
}

TEST_F(AssetFiles, LinksAreFollowedBelowTheRoot) {
  fs::create_symlink(at("a/b/x.bin"), model_ / "near.bin");
  fs::create_symlink(at("a/x.bin"), model_ / "far.bin");
  fs::create_directory_symlink(at("a"), model_ / "out");
  EXPECT_EQ(read("near.bin"), "a/b");
  EXPECT_NE(read("far.bin").find("a symbolic link leads out of the asset root"), std::string::npos);
  EXPECT_NE(read("out/x.bin").find("a symbolic link leads out"), std::string::npos);
  EXPECT_NE(read("out/X.BIN").find("a symbolic link leads out"), std::string::npos);
  EXPECT_EQ(read("far.bin", at("a")), "a");
}

TEST_F(AssetFiles, OtherSpellingsAreOpenedWithARemark) {
  EXPECT_EQ(read("..\\x.bin"), "a/b/c/d: backslashes are read as slashes, which glTF asks for");
  EXPECT_EQ(read("..%5Cx.bin"), "a/b/c/d: backslashes are read as slashes, which glTF asks for");
  EXPECT_EQ(read("x.bin?v=3:4"), "a/b/c/d/e: '?v=3:4' is ignored: it is no part of a file's name");
  EXPECT_EQ(read("x.bin#part"), "a/b/c/d/e: '#part' is ignored: it is no part of a file's name");
  EXPECT_EQ(read("../X.Bin"), "a/b/c/d: '../x.bin' is opened, whose name differs in case");
  EXPECT_EQ(read("..\\X.BIN"),
            "a/b/c/d: '../x.bin' is opened, whose name differs in case; "
            "backslashes are read as slashes, which glTF asks for");
  EXPECT_NE(read("..\\..\\..\\..\\x.bin").find("leads out"), std::string::npos);
  EXPECT_NE(read("\\etc\\passwd").find("absolute path"), std::string::npos);
  // A file with the literal name is preferred.
  folder_.write("a/b/c/d/e/q?v.bin", "question");
  folder_.write("a/b/c/d/e/back\\slash.bin", "back");
  EXPECT_EQ(read("q?v.bin"), "question");
  EXPECT_EQ(read("back\\slash.bin"), "back");
}

TEST_F(AssetFiles, OtherCaseIsOpenedWhereOneFileMatches) {
  fs::create_directories(model_ / "Maps");
  fs::create_directories(model_ / "MAPS");
  folder_.write("a/b/c/d/e/Maps/Wood.png", "wood");
  EXPECT_EQ(read("maps/wood.PNG"), "wood: 'Maps/Wood.png' is opened, whose name differs in case");
  folder_.write("a/b/c/d/e/MAPS/wood.png", "another");
  EXPECT_EQ(read("maps/wood.PNG"),
            "'maps/wood.PNG' cannot be read: no file has this name; 2 have it in other case");
  EXPECT_EQ(read("Maps/Wood.png"), "wood");
  EXPECT_EQ(read("maps/gone.png"),
            "'maps/gone.png' cannot be read: cannot be opened (No such file or directory)");
}

TEST_F(AssetFiles, WhiteSpaceInBase64IsSkippedWithARemark) {
  const std::string remark = ": white space in its base64 data is skipped";
  EXPECT_EQ(read("data:;base64,aGVsbG8="), "hello");
  EXPECT_EQ(read("DATA:;BASE64,aGVsbG8="), "hello");
  EXPECT_EQ(read("data:;base64,aGVs\r\nbG8=\n"), "hello" + remark);
  EXPECT_EQ(read("data:;base64,\n a G V s b G 8 = "), "hello" + remark);
  EXPECT_EQ(read("data:;base64,aGVsbG8%3D"), "hello");
  EXPECT_EQ(read("data:;base64,a\n"), "the base64 data is cut off");
  EXPECT_EQ(read("data:;base64,aG*s"), "the base64 data has a character that is not base64");
}

TEST_F(AssetFiles, SceneIsReadFromAboveItsFolder) {
  const GltfBuilder square = GltfBuilder::square();
  folder_.write("a/square.bin", square.bin);
  const std::string path = folder_.write("a/b/c/d/e/s.gltf", square.gltf("../../../../square.bin"));
  const Result<Scene> refused = load_in_time(path);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().reason.find("--asset-root"), std::string::npos);
  const Result<Scene> opened = load_in_time(path, {.asset_root = at("a").string()});
  ASSERT_TRUE(opened) << opened.error().message();
  EXPECT_EQ(opened->instanced_triangles(), 2u);
  EXPECT_EQ(source_files(path), std::vector{path}) << "what is refused is no source";
  EXPECT_EQ(source_files(path, at("a").string()),
            (std::vector{path, folder_.file("a/square.bin")}));
  EXPECT_FALSE(may_be_source_file(folder_.file("a/square.bin"), path));
  EXPECT_TRUE(may_be_source_file(folder_.file("a/square.bin"), path, at("a").string()));
}

TEST_F(AssetFiles, OuterRootHoldsTheRefusedFiles) {
  const auto outer = [&](const std::vector<std::string>& uris, const std::string& root = {}) {
    GltfBuilder b = GltfBuilder::square();
    for (const std::string& uri : uris) b.json["images"].push_back({{"uri", uri}});
    return outer_asset_root(folder_.write("a/b/c/d/e/s.gltf", b.gltf()), root);
  };
  EXPECT_EQ(outer({"x.bin", "../x.bin", "../../../x.bin"}), "") << "none is refused";
  EXPECT_EQ(outer({"../../../../x.bin"}), at("a").string());
  EXPECT_EQ(outer({"../../../../x.bin", "../x.bin"}), at("a").string());
  EXPECT_EQ(outer({"../../../../x.bin", "../../../../../x.bin"}), at("").parent_path().string());
  EXPECT_EQ(outer({"../../../../gone.bin"}), "") << "there is no such file";
  EXPECT_EQ(outer({"../../../../x.bin"}, at("a").string()), "") << "it is allowed";
  EXPECT_EQ(outer({"../x.bin"}, at("a/b/c/d/e").string()), at("a/b/c/d").string());
  // Only the file system's root contains both files.
  EXPECT_EQ(outer({"../../../../x.bin", "../../../../../../../../../../../proc/self/status"}), "");
  EXPECT_EQ(outer_asset_root("builtin:boxes"), "");
  EXPECT_EQ(outer_asset_root(at("gone.gltf").string()), "");
}

TEST(ReportedUris, ShowTheRedSquare) {
  const auto shared = test::shared_dir();
  if (!shared || !fs::is_directory(*shared / "reported/uri"))
    GTEST_SKIP() << "no files: set ASOS_SHARED to a folder with reported/uri";
  const std::vector<std::string> legal{"dot-dot-that-stays-inside", "parent-folder-buffer",
                                       "parent-folder-uri", "symlinked-texture"};
  for (const auto& entry : fs::directory_iterator(*shared / "reported/uri/models")) {
    if (entry.path().extension() != ".gltf") continue;
    const bool linked = entry.path().stem() == "symlinked-texture";
    if (linked && !fs::is_symlink(entry.path().parent_path() / "linked.png")) continue;
    SCOPED_TRACE(entry.path().filename());
    const Result<Scene> scene = load_in_time(entry.path().string());
    ASSERT_TRUE(scene) << scene.error().message();
    EXPECT_EQ(scene->instanced_triangles(), 2u);
    const Material& material = scene->materials.at(0);
    if (scene->images.empty())
      EXPECT_EQ(glm::vec3(material.base_color), glm::vec3(1, 0, 0));
    else
      EXPECT_EQ(scene->images[0].rgba.at(0) - scene->images[0].rgba.at(1), 255);
    const std::string name = entry.path().stem().string();
    const bool is_legal = std::find(legal.begin(), legal.end(), name) != legal.end();
    EXPECT_EQ(scene->notes.warnings.size(), is_legal ? 0u : 1u);
  }
}

}  // namespace
}  // namespace asos
