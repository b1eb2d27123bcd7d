#include "renderer/film/image_io.h"
#include "renderer/gltf/document.h"
#include "renderer/gltf/load.h"
#include "renderer/gltf/memory_check.h"
#include "renderer/scene/source_files.h"
#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/renderer/gltf/load_timer.h"
#include "tests/support/processor_seconds.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <sys/resource.h>
#include <vector>

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
  // A sparse file of three gigabytes: reading it would be noticed.
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

// Files of other kinds were once reported as broken JSON.
TEST(ImportLimits, AFileOfAnotherKindIsNamedByItsFirstBytes) {
  using std::string_literals::operator""s;
  const test::TemporaryFolder folder;
  const auto of = [&](const std::string& name, const std::string& bytes) {
    return reason(folder.write(name, bytes));
  };
  EXPECT_EQ(of("a.glb", "\x89PNG\r\n\x1a\n\0\0\0\rIHDR"s), "is a PNG picture, not a glTF scene");
  EXPECT_EQ(of("b.gltf", "\xff\xd8\xff\xe0"s), "is a JPEG picture, not a glTF scene");
  EXPECT_EQ(of("c.glb", "PK\3\4 and so on"s), "is a ZIP archive, not a glTF scene");
  EXPECT_EQ(of("d.gltf", "<!DOCTYPE html><html>"s), "is an XML or HTML text, not a glTF scene");
  std::string glb = GltfBuilder::square().glb();
  ASSERT_EQ(glb.substr(0, 4), "glTF");
  glb[3] = 'G';
  EXPECT_EQ(of("e.glb", glb), "is a GLB file with the magic 'glTG' instead of 'glTF'");
  glb[1] = '\0';
  EXPECT_EQ(of("f.glb", glb), "is a GLB file with the magic 'g\\x00TG' instead of 'glTF'");
  EXPECT_EQ(of("g.glb", "\2 something"s), "is neither GLB nor JSON: it begins with the byte 0x02");
  EXPECT_NE(of("h.gltf", "{"s).find("the JSON is broken"), std::string::npos);
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
  // No single accessor is too large.
  const auto many = load_scene(folder.write("many.glb", zeros(100, 60'000).glb()));
  ASSERT_TRUE(many) << many.error().message();
  EXPECT_LE(many->instances.size(), 3u);
  std::string warnings;
  for (const std::string& warning : many->notes.warnings) warnings += warning + "\n";
  EXPECT_NE(warnings.find("has no data, and there are more such"), std::string::npos) << warnings;
}

TEST(ImportLimits, AFileThatManyBuffersNameIsReadOnce) {
  const test::TemporaryFolder folder;
  GltfBuilder b = GltfBuilder::square();
  std::filesystem::create_directory(folder.file("part"));
  folder.write("part/data.bin", b.bin + std::string(1 << 20, '\1'));
  std::filesystem::create_symlink("part/data.bin", folder.file("other.bin"));
  for (const char* uri : {"part/data.bin", "./part/data.bin", "part/%64ata.bin", "other.bin"})
    b.json["buffers"].push_back({{"uri", uri}, {"byteLength", b.bin.size()}});
  const auto document = gltf::read_document(folder.write("shared.gltf", b.json.dump()));
  ASSERT_TRUE(document) << document.error();
  ASSERT_EQ(document->buffers.size(), 4u);
  for (const gltf::Buffer& buffer : document->buffers) {
    EXPECT_EQ(buffer.held, document->buffers[0].held);
    EXPECT_EQ(buffer.bytes.size(), b.bin.size());
  }
  EXPECT_LT(document->honest_bytes, std::uint64_t{2} << 20) << "it counts once";
  EXPECT_EQ(reason(folder.file("shared.gltf")), "");
}

/// A square for each of `images`.
GltfBuilder with_images(GltfBuilder b, const nlohmann::json& images) {
  b.json["images"] = images;
  for (std::size_t i = 0; i < images.size(); ++i) {
    b.json["textures"].push_back({{"source", i}});
    b.json["materials"].push_back({{"emissiveTexture", {{"index", i}}}});
    nlohmann::json primitive = b.json["meshes"][0]["primitives"][0];
    primitive["material"] = i;
    b.json["meshes"][0]["primitives"].push_back(primitive);
  }
  return b;
}

TEST(ImportLimits, APictureThatManyImagesNameIsDecodedOnce) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_png(folder.file("a.png"), RgbImage{1, 1, {1, 2, 3}, {}}));
  const std::string png = test::content_of(folder.file("a.png"));
  GltfBuilder b = GltfBuilder::square();
  const int first = b.view(png.data(), png.size());
  b.json["bufferViews"].push_back(b.json["bufferViews"][static_cast<std::size_t>(first)]);
  nlohmann::json images;
  for (const int view : {first, first + 1, first})
    images.push_back({{"bufferView", view}, {"mimeType", "image/png"}});
  for (const char* uri : {"a.png", "./a.png"}) images.push_back({{"uri", uri}});
  const auto scene = load_scene(folder.write("images.glb", with_images(b, images).glb()));
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(scene->images.size(), 2u) << "the buffer's limit, and the file's limit";
  EXPECT_EQ(scene->textures.size(), 5u);
}

TEST(ImportLimits, WhatTheMachineHasNoMemoryForIsRefused) {
  constexpr std::uint64_t gigabyte = 1'000'000'000;
  EXPECT_TRUE(gltf::check_memory(2'000'000, 1'000'000, gigabyte));
  const auto refused = gltf::check_memory(60'000'000, 10, 8 * gigabyte);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("60000000 triangles"), std::string::npos) << refused.error();
  EXPECT_NE(refused.error().find("this machine has 8.0 GB"), std::string::npos);
  EXPECT_FALSE(gltf::check_memory(0, 4'000'000, gigabyte));
  EXPECT_GT(gltf::memory_of_machine(), gigabyte / 2);
}

TEST(ImportLimits, EntriesThatSayNothingAreCountedAgainstTheFile) {
  const test::TemporaryFolder folder;
  // Inserts millions of entries as text: building the JSON would take half a minute in an
  // unoptimised test.
  const auto loaded = [&](const GltfBuilder& b, const std::string& entries) {
    std::string text = b.gltf();
    text.replace(text.find("\"@\""), 3, entries);
    return reason(folder.write("many.gltf", text));
  };
  const auto repeated = [](std::size_t count, const std::string& entry) {
    std::string list = "[" + entry;
    for (std::size_t i = 1; i < count; ++i) list += "," + entry;
    return list + "]";
  };
  const auto with = [&](const char* list, std::size_t count, const std::string& entry) {
    GltfBuilder b = GltfBuilder::square();
    b.json[list] = "@";
    return loaded(b, repeated(count, entry).replace(0, 1, R"([{"mesh":0},)"));
  };
  EXPECT_EQ(with("nodes", 100'000, "{}"), "");
  EXPECT_EQ(with("materials", 10'000, "{}"), "");
  EXPECT_NE(with("nodes", 400'000, "{}").find("more entries"), std::string::npos);
  EXPECT_NE(with("materials", 100'000, "{}").find("more entries"), std::string::npos);
  // Entries with contents are normal for files of this size.
  EXPECT_EQ(with("nodes", 400'000, R"({"name":"node","translation":[1,2,3]})"), "");
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = {"KHR_node_visibility"};
  b.node()["extensions"]["KHR_node_visibility"] = {{"visible", true}, {"more", "@"}};
  EXPECT_NE(loaded(b, repeated(2'000'000, "0")).find("more entries"), std::string::npos);
  GltfBuilder skinned = GltfBuilder::square();
  skinned.json["skins"] = {{{"joints", "@"}}};
  EXPECT_NE(loaded(skinned, repeated(5'000'000, "0")).find("more entries"), std::string::npos);
}

TEST(ImportLimits, WeightsThatMorphNothingAreNotKeptForEachPrimitive) {
  if (test::sanitized) GTEST_SKIP() << "memory is not the program's";
  const auto most_memory_kb = [] {
    rusage used{};
    ::getrusage(RUSAGE_SELF, &used);
    return used.ru_maxrss;
  };
  GltfBuilder b = GltfBuilder::square();
  auto& mesh = b.json["meshes"][0];
  mesh["weights"] = std::vector<int>(20'000, 1);
  for (int i = 0; i < 2000; ++i) mesh["primitives"].push_back(mesh["primitives"][0]);
  const test::TemporaryFolder folder;
  const std::string path = folder.write("weights.glb", b.glb());
  const auto before = most_memory_kb();
  const auto scene = load_scene(path);
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(scene->meshes.size(), 2001u);
  EXPECT_LT(most_memory_kb() - before, 100'000);
}

TEST(ImportLimits, MoreCopiesThanObjectsMayBeAreRefusedBeforeTheyAreRead) {
  const test::TemporaryFolder folder;
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  b.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", b.accessor(-1, 5126, "VEC3", 4'000'001)}};
  EXPECT_EQ(reason(folder.write("copies.glb", b.glb())),
            "has more than 4000000 objects, which is the limit");
}

// Shared poses and names are computed once, not n times for each of n users.
TEST(ImportLimits, ManyThatShareMuchLoadInTime) {
  if (test::sanitized) GTEST_SKIP() << "times are not the program's";
  constexpr int count = 20'000;
  GltfBuilder skinned = GltfBuilder::square();
  skinned.node()["skin"] = 0;
  nlohmann::json joints = {0};
  for (int i = 1; i < count; ++i) {
    skinned.json["nodes"].push_back({{"mesh", 0}, {"skin", 0}});
    skinned.json["scenes"][0]["nodes"].push_back(i);
    joints.push_back(i);
  }
  skinned.json["skins"] = {{{"joints", joints}}};
  EXPECT_TRUE(test::load_in_time(skinned));

  const test::TemporaryFolder folder;
  GltfBuilder named = GltfBuilder::square();
  for (int i = 0; i < 4 * count; ++i)
    named.json["images"].push_back({{"uri", "a-picture-of-this-name-" + std::to_string(i)}});
  const std::string path = folder.write("named.glb", named.glb());
  const double start = test::processor_seconds();
  EXPECT_EQ(source_files(path).size(), std::size_t{1} + 4 * count);
  EXPECT_LT(test::processor_seconds() - start, test::longest_load_seconds);
}

}  // namespace
}  // namespace asos::import_limits_test
