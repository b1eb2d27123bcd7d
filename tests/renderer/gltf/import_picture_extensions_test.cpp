#include "renderer/gltf/load.h"
#include "tests/renderer/gltf/gltf_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <webp/encode.h>

// Images of extensions: EXT_texture_webp, KHR_texture_basisu, and the roughness in a texture's
// alpha of KHR_materials_pbrSpecularGlossiness.

namespace asos {
namespace {

using nlohmann::json;
using test::GltfBuilder;

using Texels = std::vector<std::uint8_t>;

/// Two texels, RGBA.
const Texels two_texels = {10, 20, 30, 0, 200, 100, 50, 204};

std::string webp_of(const Texels& rgba, int width, int height) {
  WebPConfig config;
  WebPPicture picture;
  if (!WebPConfigInit(&config) || !WebPConfigLosslessPreset(&config, 0) ||
      !WebPPictureInit(&picture))
    return {};
  config.exact = 1;  // keeps the colours of transparent texels
  picture.use_argb = 1;
  picture.width = width;
  picture.height = height;
  WebPMemoryWriter writer;
  WebPMemoryWriterInit(&writer);
  picture.writer = WebPMemoryWrite;
  picture.custom_ptr = &writer;
  EXPECT_TRUE(WebPPictureImportRGBA(&picture, rgba.data(), 4 * width));
  EXPECT_TRUE(WebPEncode(&config, &picture));

  std::string bytes(reinterpret_cast<const char*>(writer.mem), writer.size);
  WebPPictureFree(&picture);
  WebPMemoryWriterClear(&writer);
  return bytes;
}

json data_uri(const std::string& bytes, const std::string& type) {
  return {{"uri", "data:" + type + ";base64," + GltfBuilder::base64(bytes)}};
}

Result<Scene> import_file(json texture, json images, json extensions_used) {
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = std::move(extensions_used);
  b.json["images"] = std::move(images);
  b.json["textures"] = {std::move(texture)};
  b.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  const test::TemporaryFolder folder;
  return import_gltf(folder.write("test.glb", b.glb()));
}

json webp_source(int image) {
  return {{"EXT_texture_webp", {{"source", image}}}};
}

bool warns(const Scene& scene, const std::string& of) {
  return std::any_of(scene.notes.warnings.begin(), scene.notes.warnings.end(),
                     [&](const std::string& w) { return w.find(of) != std::string::npos; });
}

TEST(WebpTextures, TakeTheirOwnImageBeforeTheOther) {
  const std::string webp = webp_of(two_texels, 2, 1);
  const auto scene =
      import_file({{"source", 0}, {"extensions", webp_source(1)}},
                  {{{"uri", test::small_png}}, data_uri(webp, "image/webp")}, {"EXT_texture_webp"});
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_TRUE(scene->notes.warnings.empty()) << scene->notes.warnings.at(0);
  EXPECT_TRUE(scene->notes.unsupported_extensions.empty());
  ASSERT_EQ(scene->images.size(), 1u);
  EXPECT_EQ(scene->images[0].width, 2);
  EXPECT_EQ(scene->images[0].height, 1);
  EXPECT_EQ(scene->images[0].rgba, two_texels);
  EXPECT_TRUE(scene->materials.at(0).base_color_texture.used());
}

TEST(WebpTextures, WithBrokenDataFallBackOrAreLeftOutByName) {
  const std::string webp = webp_of(two_texels, 2, 1);
  // Truncated anywhere, and with each byte changed: an image, or a warning that names it.
  for (std::size_t length = 0; length < webp.size(); ++length) {
    SCOPED_TRACE(length);
    const auto scene =
        import_file({{"extensions", webp_source(0)}},
                    {data_uri(webp.substr(0, length), "image/webp")}, {"EXT_texture_webp"});
    ASSERT_TRUE(scene);
    EXPECT_TRUE(scene->images.empty());
    EXPECT_TRUE(warns(*scene, "image 0")) << "cut off";
    EXPECT_FALSE(scene->materials.at(0).base_color_texture.used());
  }
  for (std::size_t i = 0; i < webp.size(); ++i) {
    std::string changed = webp;
    changed[i] = static_cast<char>(changed[i] ^ 0x55);
    const auto scene = import_file({{"source", 1}, {"extensions", webp_source(0)}},
                                   {data_uri(changed, "image/webp"), {{"uri", test::small_png}}},
                                   {"EXT_texture_webp"});
    ASSERT_TRUE(scene);
    ASSERT_EQ(scene->images.size(), 1u) << "its own, or the fallback";
    const Texels red(scene->images[0].rgba.get().begin(), scene->images[0].rgba.get().begin() + 4);
    const bool fell_back = red == Texels{255, 0, 0, 255};
    EXPECT_EQ(fell_back, warns(*scene, "falls back")) << i;
  }
}

TEST(WebpTextures, ClaimNoMoreThanTheirBytesCanHold) {
  // The header of a lossless image of 16383 x 16383 texels: 14 bits per side, minus one.
  std::string head = webp_of(two_texels, 2, 1);
  ASSERT_EQ(head.substr(12, 4), "VP8L");
  head[21] = '\xfe', head[22] = '\xbf', head[23] = '\xff';
  head[24] = static_cast<char>((head[24] & 0xf0) | 0x0f);
  const auto scene = import_file({{"extensions", webp_source(0)}}, {data_uri(head, "image/webp")},
                                 {"EXT_texture_webp"});
  ASSERT_TRUE(scene);
  EXPECT_TRUE(warns(*scene, "cannot hold 16383 x 16383 pixels"))
      << (scene->notes.warnings.empty() ? "no warning" : scene->notes.warnings[0]);
}

TEST(BasisuTextures, ShowTheirFallbackOrSayWhatToDo) {
  const json basisu = {{"KHR_texture_basisu", {{"source", 1}}}};
  const json images = {{{"uri", test::small_png}}, data_uri("\xabKTX 20\xbb", "image/ktx2")};
  const auto with =
      import_file({{"source", 0}, {"extensions", basisu}}, images, {"KHR_texture_basisu"});
  ASSERT_TRUE(with);
  EXPECT_TRUE(with->materials.at(0).base_color_texture.used());
  EXPECT_TRUE(with->notes.warnings.empty());
  EXPECT_EQ(with->notes.unsupported_extensions, std::vector<std::string>{"KHR_texture_basisu"});
  const auto without = import_file({{"extensions", basisu}}, images, {"KHR_texture_basisu"});
  ASSERT_TRUE(without);
  EXPECT_FALSE(without->materials.at(0).base_color_texture.used());
  EXPECT_TRUE(warns(*without, "convert them to PNG or WebP"));

  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = b.json["extensionsRequired"] = {"KHR_texture_basisu"};
  const test::TemporaryFolder folder;
  const auto refused = import_gltf(folder.write("test.glb", b.glb()));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("KHR_texture_basisu"), std::string::npos);
  EXPECT_NE(refused.error().message().find("PNG or WebP"), std::string::npos);
}

Result<Scene> import_glossy(json materials) {
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = {"KHR_materials_pbrSpecularGlossiness", "EXT_texture_webp"};
  b.json["images"] = {data_uri(webp_of(two_texels, 2, 1), "image/webp")};
  b.json["textures"] = {{{"extensions", webp_source(0)}}};
  b.json["materials"] = std::move(materials);
  const test::TemporaryFolder folder;
  return import_gltf(folder.write("test.glb", b.glb()));
}

json glossy(json extension) {
  return {{"name", "gold"},
          {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 1, 1}}, {"roughnessFactor", 0.9}}},
          {"extensions", {{"KHR_materials_pbrSpecularGlossiness", std::move(extension)}}}};
}

TEST(SpecularGlossiness, FactorsBecomeADielectricOfInfiniteIndex) {
  const auto scene = import_glossy({glossy({{"diffuseFactor", {0.5, 0.25, 0.125, 0.75}},
                                            {"specularFactor", {0.25, 0.5, 0.125}},
                                            {"glossinessFactor", 0.75}}),
                                    glossy(json::object())});
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_TRUE(scene->notes.warnings.empty());
  const Material& m = scene->materials.at(0);
  EXPECT_EQ(m.base_color, glm::vec4(0.5f, 0.25f, 0.125f, 0.75f));
  EXPECT_EQ(m.metallic, 0.0f);
  EXPECT_EQ(m.roughness, 0.25f);
  EXPECT_EQ(m.ior, 0.0f);
  EXPECT_EQ(m.specular, 1.0f);
  EXPECT_EQ(m.specular_color, glm::vec3(0.25f, 0.5f, 0.125f));
  const Material& plain = scene->materials.at(1);
  EXPECT_EQ(plain.base_color, glm::vec4(1.0f));
  EXPECT_EQ(plain.specular_color, glm::vec3(1.0f));
  EXPECT_EQ(plain.roughness, 0.0f);
}

TEST(SpecularGlossiness, TexturesGiveColourAndRoughness) {
  const json texture = {{"index", 0}};
  const auto scene =
      import_glossy({glossy({{"glossinessFactor", 0.5}, {"specularGlossinessTexture", texture}}),
                     glossy({{"diffuseTexture", texture},
                             {"glossinessFactor", 0.5},
                             {"specularGlossinessTexture", texture}}),
                     glossy({{"specularGlossinessTexture", texture}})});
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(scene->images.size(), 3u) << "the file's, and one of roughness for each factor";
  const Material& m = scene->materials.at(1);
  EXPECT_TRUE(m.base_color_texture.used());
  EXPECT_TRUE(m.specular_color_texture.used());
  ASSERT_TRUE(m.metallic_roughness_texture.used());
  EXPECT_EQ(m.roughness, 1.0f);
  const auto roughness = [&](std::size_t material, std::size_t texel) {
    const int texture_index = scene->materials.at(material).metallic_roughness_texture.texture;
    const Texture& rough = scene->textures.at(static_cast<std::size_t>(texture_index));
    return scene->images.at(static_cast<std::size_t>(rough.image)).rgba.at(4 * texel + 1);
  };
  EXPECT_EQ(roughness(1, 0), 255) << "no gloss";
  EXPECT_EQ(roughness(1, 1), 255 - 102) << "1 - 0.5 * 204 / 255";
  EXPECT_EQ(roughness(2, 1), 255 - 204);
}

TEST(SpecularGlossiness, HasABoundOfImagesAndNamesWhatIsOutOfRange) {
  json many = json::array();
  for (int i = 0; i < 9; ++i) {
    many.push_back(
        glossy({{"glossinessFactor", 0.1 * i}, {"specularGlossinessTexture", {{"index", 0}}}}));
  }
  const auto scene = import_glossy(many);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->images.size(), 5u);
  EXPECT_TRUE(warns(*scene, "factors of glossiness"));
  EXPECT_FALSE(scene->materials.at(8).metallic_roughness_texture.used());
  EXPECT_FLOAT_EQ(scene->materials.at(8).roughness, 0.2f);
  const auto bad =
      import_glossy({glossy({{"glossinessFactor", 7}, {"specularFactor", {2, 0, 0}}})});
  ASSERT_TRUE(bad);
  EXPECT_EQ(bad->materials.at(0).roughness, 0.0f);
  EXPECT_EQ(bad->materials.at(0).specular_color, glm::vec3(1, 0, 0));
  EXPECT_EQ(bad->notes.warnings.size(), 2u);
}

TEST(Textures, AreTheSameWhetherDecodedTogetherOrOneByOne) {
  constexpr int count = 12, broken = 4, unused = 7;
  const auto texels_of = [](int image) {
    Texels rgba;
    for (int i = 0; i < 4 * 2 * (image + 1); ++i)
      rgba.push_back(static_cast<std::uint8_t>(i % 4 == 3 ? 255 : 17 * i + image));
    return rgba;
  };
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = {"EXT_texture_webp"};
  for (int i = 0; i < count; ++i) {
    const std::string webp = webp_of(texels_of(i), i + 1, 2);
    const bool whole = i != broken && i != unused;
    b.json["images"].push_back(
        data_uri(whole ? webp : webp.substr(0, webp.size() - 6), "image/webp"));
    b.json["textures"].push_back({{"extensions", webp_source(i)}});
  }
  // Materials use them from the last to the first, and the first of them again.
  std::vector<int> expected;
  for (int i = count - 1; i >= -1; --i) {
    const int texture = std::max(0, i);
    if (texture == unused) continue;
    b.json["materials"].push_back(
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
    if (i >= 0 && i != broken) expected.push_back(i);
  }
  const test::TemporaryFolder folder;
  const auto scene = import_gltf(folder.write("test.glb", b.glb()));
  ASSERT_TRUE(scene) << scene.error().message();
  ASSERT_EQ(scene->images.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(scene->images[k].width, expected[k] + 1);
    EXPECT_EQ(scene->images[k].rgba, texels_of(expected[k])) << expected[k];
  }
  EXPECT_EQ(std::count_if(scene->notes.warnings.begin(), scene->notes.warnings.end(),
                          [](const std::string& w) { return w.find("image ") == 0; }),
            1);
  EXPECT_TRUE(warns(*scene, "image 4 "));
  EXPECT_FALSE(warns(*scene, "image 7")) << "no material uses it, so it is not decoded";
  const auto& materials = scene->materials;
  ASSERT_EQ(materials.size(), 12u);
  EXPECT_EQ(materials[10].base_color_texture.texture, materials[11].base_color_texture.texture);
  EXPECT_FALSE(materials[count - 2 - broken].base_color_texture.used());
}

}  // namespace
}  // namespace asos
