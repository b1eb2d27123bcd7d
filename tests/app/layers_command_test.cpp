#include "renderer/film/image_io.h"
#include "renderer/film/layers.h"
#include "tests/app/run_asos.h"
#include "tests/support/temporary_folder.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

// Layers on the command line.

namespace asos {
namespace {

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  char buffer[4096];
  while (pipe && std::fgets(buffer, sizeof buffer, pipe.get())) text += buffer;
  return text;
}

test::AsosRun render(std::vector<std::string> more) {
  using test::operator+;
  return test::run_asos(
      std::vector<std::string>{"render", "builtin:boxes", "--size", "32x18", "--quiet"} + more);
}

TEST(LayersOption, PictureIsTheSameWithAllLayers) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(render({"-o", folder.file("plain.exr")}).exit_code, 0);
  const test::AsosRun run = render({"-o", folder.file("all.exr"), "--layers", "all"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto plain = read_exr(folder.file("plain.exr")), all = read_exr(folder.file("all.exr"));
  ASSERT_TRUE(plain && all);
  EXPECT_EQ(plain->film.radiance, all->film.radiance);
  EXPECT_TRUE(plain->film.coverage.empty() && all->film.coverage.empty());
  const std::string bytes = test::content_of(folder.file("all.exr"));
  for (const char* channel : {"alpha.A", "depth.Z", "normal.X", "CryptoObject00.R", "error.V"})
    EXPECT_NE(bytes.find(channel), std::string::npos) << channel;
  EXPECT_EQ(test::content_of(folder.file("plain.exr")).find("depth.Z"), std::string::npos);
}

TEST(LayersOption, SavedPictureBringsItsLayers) {
  const test::TemporaryFolder folder;
  const std::string first = folder.file("first.exr"), second = folder.file("second.exr");
  ASSERT_EQ(render({"-o", first, "--layers", "depth,object"}).exit_code, 0);
  ASSERT_EQ(test::run_asos({"render", "--from", first, "-o", second, "--quiet"}).exit_code, 0);
  EXPECT_NE(test::content_of(second).find("depth.Z"), std::string::npos);
  EXPECT_EQ(test::content_of(second).find("normal.X"), std::string::npos);
  // A PNG cannot hold layers, so it is saved without them.
  const test::AsosRun png =
      test::run_asos({"render", "--from", first, "-o", folder.file("a.png"), "--quiet"});
  EXPECT_EQ(png.exit_code, 0) << png.err;
}

TEST(LayersOption, BrokenPictureIsAnError) {
  const test::TemporaryFolder folder;
  const std::string whole = folder.file("whole.exr");
  ASSERT_EQ(render({"-o", whole, "--layers", "all"}).exit_code, 0);
  const std::string bytes = test::content_of(whole);
  const std::string cut = folder.write("cut.exr", bytes.substr(0, 900));
  const test::AsosRun run =
      test::run_asos({"render", "--from", cut, "-o", folder.file("b.exr"), "--quiet"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(test::contains(run.err, "cut.exr"));
}

TEST(LayersOption, SaysWhatItCannotDo) {
  const test::TemporaryFolder folder;
  const std::string exr = folder.file("a.exr");
  const test::AsosRun unknown = render({"-o", exr, "--layers", "deep"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(test::contains(unknown.err, "\"deep\""));
  EXPECT_TRUE(test::contains(unknown.err, "geometric_normal"));
  const test::AsosRun png = render({"-o", folder.file("a.png"), "--layers", "depth"});
  EXPECT_EQ(png.exit_code, 2);
  EXPECT_TRUE(test::contains(png.err, ".exr"));
  const test::AsosRun method = render({"-o", exr, "--layers", "depth", "--method", "beam"});
  EXPECT_EQ(method.exit_code, 1);
  EXPECT_TRUE(test::contains(method.err, "beam renders none"));
}

// Coarse passes have layers, too: whatever the limit finds, the picture has them.
TEST(LayersOption, TimeLimitKeepsThem) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("soon.exr");
  const test::AsosRun run = render({"-o", path, "--layers", "all", "--time-limit", "0"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string bytes = test::content_of(path);
  for (const char* channel : {"depth.Z", "direct.R", "CryptoObject00.R", "error.V"})
    EXPECT_TRUE(test::contains(bytes, channel)) << channel;
}

TEST(LayersOption, InfoListsThemWithUnits) {
  const test::AsosRun text = test::run_asos({"info", "--layers"});
  ASSERT_EQ(text.exit_code, 0) << text.err;
  const test::AsosRun as_json = test::run_asos({"info", "--layers", "--json"});
  const auto listed = nlohmann::json::parse(as_json.out);
  ASSERT_EQ(listed.size(), layer_table().size());
  for (const LayerRow& row : layer_table()) EXPECT_TRUE(test::contains(text.out, row.name));
  EXPECT_EQ(listed[9]["name"], "depth");
  EXPECT_EQ(listed[9]["unit"], "m");
  EXPECT_EQ(test::run_asos({"info"}).exit_code, 2) << "a scene, or --layers";
}

// OpenImageIO reads the channels, the matte's metadata and the matrices.
TEST(LayersOption, OpenImageIoReadsThem) {
  if (std::system("command -v oiiotool > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "oiiotool is not installed (package openimageio-tools)";
  const test::TemporaryFolder folder;
  const std::string path = folder.file("all.exr");
  ASSERT_EQ(render({"-o", path, "--layers", "all"}).exit_code, 0);
  const std::string info = output_of("oiiotool --info -v " + path);
  for (const char* part :
       {"32 x   18", "depth.Z", "normal.X", "CryptoObject00.R", "cryptomatte/3ae39a5/manifest",
        "MurmurHash3_32", "worldToCamera", "chromaticities"})
    EXPECT_TRUE(test::contains(info, part));
}

}  // namespace
}  // namespace asos
