#include "renderer/scene/load.h"
#include "tests/renderer/scene/gltf_builder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace asos::import_limits_test {
namespace {

using test::GltfBuilder;

std::string reason(const std::string& path) {
  const auto scene = load_scene(path);
  return scene ? "" : scene.error().reason;
}

TEST(ImportLimits, AGlbsHeaderIsJudgedBeforeTheFileIsRead) {
  using std::string_literals::operator""s;
  const test::TemporaryFolder folder;
  const std::string path = folder.file("large.glb");
  // Three gigabytes that are not there: reading them would be noticed.
  const auto with_head = [&](const std::string& head, std::uintmax_t size) {
    folder.write("large.glb", head);
    std::filesystem::resize_file(path, size);
    return reason(path);
  };
  constexpr std::uintmax_t large = std::uintmax_t{3} << 30;
  EXPECT_EQ(with_head("glTF\1\0\0\0"s, large), "GLB version 1 is not supported, only 2");
  EXPECT_NE(with_head("glTF\2\0\0\0\xff\xff\xff\xff"s, large).find("cut off"), std::string::npos);
  EXPECT_NE(with_head("glTF\2\0\0\0\4\0\0\0"s, large).find("length of 4"), std::string::npos);
  EXPECT_EQ(with_head("{", large), "the JSON is larger than 1 GiB");
  EXPECT_NE(with_head("glTF", std::uintmax_t{9} << 30).find("the limit is"), std::string::npos);
}

/// `count` primitives of `vertices` zeros each, drawn without indices.
GltfBuilder zeros(int count, std::size_t vertices) {
  GltfBuilder b;
  for (int i = 0; i < count; ++i)
    b.primitive({{"POSITION", b.accessor(-1, 5126, "VEC3", vertices)}});
  return b;
}

TEST(ImportLimits, AccessorsWithoutDataAreCountedAgainstTheFile) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(reason(folder.write("few.glb", zeros(1, 3000).glb())), "");
  // A file of a megabyte, so that the limit is two.
  GltfBuilder large = zeros(1, 300'000);
  large.bin = std::string(1 << 20, '\0');
  large.json["asset"]["extras"] = {{"why", "the buffer counts"}};
  EXPECT_NE(reason(folder.write("large.glb", large.glb())).find("without data"), std::string::npos);
  // None of them is too large alone.
  const auto many = load_scene(folder.write("many.glb", zeros(100, 60'000).glb()));
  ASSERT_TRUE(many) << many.error().message();
  EXPECT_LE(many->instances.size(), 3u);
  std::string warnings;
  for (const std::string& warning : many->notes.warnings) warnings += warning + "\n";
  EXPECT_NE(warnings.find("has no data, and there are more such"), std::string::npos) << warnings;
}

}  // namespace
}  // namespace asos::import_limits_test
