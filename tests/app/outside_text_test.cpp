#include "renderer/film/image_io.h"
#include "tests/app/run_asos.h"
#include "tests/renderer/gltf/gltf_builder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace asos::outside_text_test {
namespace {

using test::AsosRun;
using test::contains;
using test::GltfBuilder;
using test::operator+;
using test::run_asos;

/// All control bytes, marks that change the direction of text, and lines that imitate the program's
/// own.
const std::string& evil() {
  static const std::string text = [] {
    std::string all = "\nasos: all fine\n";
    for (char c = 1; c < 32; ++c) all += c;
    return all + "\x7f\u0085\u009b\u061c\u200e\u200f\u2028\u2029\u202a\u202b\u202c\u202d\u202e" +
           "\u2066\u2067\u2068\u2069\ufeff end";
  }();
  return text;
}

/// Checks that the output has none of the dangerous parts, and does contain the harmless ones.
testing::AssertionResult harmless(const std::string& printed, bool told = true) {
  for (const char c : printed) {
    if ((static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f)
      return testing::AssertionFailure() << "byte " << int{c} << " in:\n" << printed;
  }
  for (const char* mark : {"\u0085", "\u009b", "\u061c", "\u200e", "\u2028", "\u202e", "\u2066",
                           "\u2069", "\ufeff", "\nasos: all fine"}) {
    if (printed.find(mark) != std::string::npos)
      return testing::AssertionFailure() << "\"" << mark << "\" in:\n" << printed;
  }
  if (told && printed.find("asos: all fine") == std::string::npos)
    return testing::AssertionFailure() << "it was not printed at all:\n" << printed;
  return testing::AssertionSuccess();
}

class OutsideText : public testing::Test {
 protected:
  std::string put(const GltfBuilder& file, const std::string& name = "scene.glb") {
    return folder_.write(name, file.glb());
  }
  AsosRun render(const std::vector<std::string>& words) {
    return run_asos(std::vector<std::string>{"render", "-o", folder_.file("picture.png"), "--size",
                                             "8x6", "--stats", folder_.file("stats.json")} +
                    words);
  }

  test::TemporaryFolder folder_;
};

TEST_F(OutsideText, NamesInAFileArePrintedEscaped) {
  GltfBuilder b = GltfBuilder::square();
  b.json["scenes"][0]["name"] = evil();
  b.node()["name"] = evil();
  b.json["meshes"][0]["name"] = evil();
  b.json["materials"] = {{{"name", evil()}}};
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  b.json["cameras"] = {
      {{"name", evil()}, {"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}},
      {{"name", evil()}, {"type", "perspective"}, {"perspective", {{"yfov", -1}, {"znear", 0.1}}}}};
  b.json["images"] = {{{"name", evil()}, {"uri", evil()}}};
  b.json["textures"] = {{{"source", 0}, {"name", evil()}}};
  b.json["materials"][0]["normalTexture"] = {{"index", 0}};
  b.json["extensionsUsed"] = {evil(), "KHR_lights_punctual"};
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"name", evil()}, {"type", "point"}},
                                                           {{"name", evil()}, {"type", evil()}}};
  for (int i = 0; i < 2; ++i) {
    b.json["nodes"].push_back({{"name", evil()},
                               {"camera", i},
                               {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
  }
  b.json["scenes"][0]["nodes"] = {0, 1, 2};
  const std::string file = put(b);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"info", file},
        {"info", file, "--json"},
        {"trace", file, "--pixel", "4,3", "--size", "8x6"},
        {"trace", file, "--pixel", "4,3", "--size", "8x6", "--json"}}) {
    const AsosRun run = run_asos(words);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_TRUE(harmless(run.out, words[0] == "info"));
    EXPECT_TRUE(harmless(run.err, false));
  }
  const AsosRun run = render({file});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(harmless(run.out + run.err));
  // JSON escapes the text without loss.
  const std::string stats = test::content_of(folder_.file("stats.json"));
  EXPECT_TRUE(harmless(stats, false));
  EXPECT_EQ(nlohmann::json::parse(stats)["camera"], evil());
}

TEST_F(OutsideText, NamesInErrorsArePrintedEscaped) {
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsRequired"] = {evil()};
  const std::string needy = put(b, "needy.glb");
  const std::string broken = folder_.write("broken.glb", evil());
  const std::string named = put(GltfBuilder::square(), "a" + evil() + ".glb");
  for (const std::string& file : {needy, folder_.file(evil()), folder_.file(evil() + ".hdr")}) {
    for (const char* command : {"info", "view"}) {
      const AsosRun run = run_asos({command, file});
      EXPECT_EQ(run.exit_code, 1) << command;
      EXPECT_TRUE(
          harmless(run.err, file != needy || run.err.find("extension") != std::string::npos))
          << command;
    }
    EXPECT_TRUE(harmless(render({file}).err));
    EXPECT_TRUE(harmless(render({"builtin:boxes", "--sky", file + ".hdr"}).err, file != needy));
    EXPECT_TRUE(harmless(render({"--from", file + ".png"}).err, file != needy));
    EXPECT_TRUE(harmless(run_asos({"report", file, "-o", folder_.file("report")}).err, false));
  }
  EXPECT_TRUE(harmless(run_asos({"info", broken}).err, false));
  EXPECT_TRUE(harmless(run_asos({"info", named}).out));
  const AsosRun wrote =
      run_asos({"render", named, "--size", "8x6", "-o", folder_.file("b" + evil() + ".png")});
  EXPECT_EQ(wrote.exit_code, 0) << wrote.err;
  EXPECT_TRUE(harmless(wrote.out));
  const AsosRun exported = run_asos({"export-scene", "boxes", "-o", folder_.file(evil() + ".glb")});
  EXPECT_EQ(exported.exit_code, 0) << exported.err;
  EXPECT_TRUE(harmless(exported.out));
  // Typed text is echoed, too, and may come from a wildcard.
  EXPECT_TRUE(harmless(run_asos({"render", "builtin:boxes", "--max", evil()}).err));
  EXPECT_TRUE(harmless(run_asos({"info", "builtin:boxes", evil()}).err));
  EXPECT_TRUE(harmless(run_asos({"export-scene", evil(), "-o", folder_.file("c.glb")}).err));
}

/// A square with `count` textures whose images are missing.
GltfBuilder lossy(int count) {
  GltfBuilder b = GltfBuilder::square();
  for (int i = 0; i < count; ++i) {
    b.json["images"].push_back({{"uri", "gone-" + std::to_string(i) + ".png"}});
    b.json["textures"].push_back({{"source", i}});
    b.json["materials"].push_back({{"normalTexture", {{"index", i}}}});
  }
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  return b;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST_F(OutsideText, LossesAreSaidOnceCountedAndKept) {
  for (const int losses : {1, 10, 11, 250}) {
    const std::string file = put(lossy(losses));
    EXPECT_EQ(render({file, "--quiet"}).err, "") << "the files still contain it";
    const AsosRun run = render({file});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto lines = static_cast<std::size_t>(std::min(losses, 10));
    EXPECT_EQ(count_of(run.err, "asos: warning: image "), lines) << run.err;
    EXPECT_EQ(count_of(run.err, "\n"), lines + (losses > 10 ? 1 : 0)) << run.err;
    if (losses > 10) {
      EXPECT_TRUE(
          contains(run.err, "asos: warning: and " + std::to_string(losses - 10) + " more\n"));
    }
    const auto stats = nlohmann::json::parse(test::content_of(folder_.file("stats.json")));
    EXPECT_EQ(stats["warning_count"], losses);
    EXPECT_TRUE(contains(stats["warnings"][0], "gone-0.png"));
    const auto png = read_png(folder_.file("picture.png"));
    ASSERT_TRUE(png);
    std::string text;
    for (const auto& [key, value] : png->text) text += value;
    EXPECT_TRUE(contains(text, "gone-0.png"));
  }
}

TEST_F(OutsideText, FramesSayLossesOnce) {
  const AsosRun run = run_asos({"render", put(lossy(1)), "--size", "8x6", "--frames", "0-2/9", "-o",
                                folder_.file("turn.png")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(count_of(run.err, "asos: warning: "), 1u) << run.err;
}

TEST_F(OutsideText, ASceneOfWhichNothingIsDrawnIsAnError) {
  GltfBuilder b = GltfBuilder::square();
  b.json["scenes"][0]["nodes"] = nlohmann::json::array();
  const std::string empty = put(b, "empty.glb");
  const AsosRun run = render({empty});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "empty.glb: there is nothing in it to draw"));
  EXPECT_TRUE(contains(run.err, "--allow-empty"));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("picture.png")));
  EXPECT_EQ(render({empty, "--allow-empty"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_.file("picture.png")));
}

TEST_F(OutsideText, PropertiesOfTheWrongKindAreSaid) {
  const std::vector<std::pair<std::string, nlohmann::json>> wrong{
      {"pbrMetallicRoughness", nlohmann::json::array()},
      {"pbrMetallicRoughness", 3},
      {"pbrMetallicRoughness", {{"metallicFactor", "much"}}},
      {"pbrMetallicRoughness", {{"baseColorFactor", {1, "0", 0, 1}}}},
      {"pbrMetallicRoughness", {{"baseColorTexture", nlohmann::json::array()}}},
      {"normalTexture", "a"},
      {"emissiveFactor", 1},
      {"alphaMode", 1},
      {"doubleSided", "yes"}};
  for (const auto& [key, value] : wrong) {
    GltfBuilder b = GltfBuilder::square();
    b.json["materials"] = nlohmann::json::array();
    b.json["materials"].push_back({{key, value}});
    b.json["meshes"][0]["primitives"][0]["material"] = 0;
    const std::string file = put(b);
    EXPECT_TRUE(contains(run_asos({"info", file}).out, "Warning: /materials/0/" + key)) << value;
    EXPECT_TRUE(contains(render({file}).err, "asos: warning: /materials/0/" + key)) << value;
  }
}

/// A square with one of each thing, all with properties of the wrong type.
GltfBuilder of_everything() {
  GltfBuilder b = GltfBuilder::square();
  nlohmann::json& j = b.json;
  j["materials"] = {{{"normalTexture", {{"index", 0}, {"scale", 1}}}}};
  j["textures"] = nlohmann::json::array({nlohmann::json::object()});
  j["meshes"][0]["primitives"][0]["material"] = 0;
  j["samplers"] = nlohmann::json::array({nlohmann::json::object()});
  j["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}}};
  j["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}, {"spot", {{"x", 0}}}}};
  b.node()["extensions"]["KHR_lights_punctual"]["light"] = 0;
  b.node()["camera"] = 0;
  return b;
}

TEST_F(OutsideText, PropertiesOfTheWrongKindAreSaidWhereverTheyStand) {
  const std::string material = "/materials/0/extensions/KHR_materials_";
  const std::string light = "/extensions/KHR_lights_punctual/lights/0/";
  const std::string transform = "/materials/0/normalTexture/extensions/KHR_texture_transform/";
  const std::vector<std::pair<std::string, nlohmann::json>> wrong{
      {material + "ior/ior", "1.5"},
      {material + "transmission/transmissionFactor", true},
      {material + "transmission/transmissionTexture", 3},
      {material + "emissive_strength/emissiveStrength", {1}},
      {material + "volume/attenuationColor", {1, 2}},
      {material + "volume/attenuationDistance", "far"},
      {material + "specular/specularColorFactor", {1, "0", 0}},
      {material + "clearcoat/clearcoatFactor", nlohmann::json::object()},
      {material + "sheen/sheenColorFactor", 1},
      {material + "iridescence/iridescenceIor", "x"},
      {material + "anisotropy/anisotropyRotation", "x"},
      {material + "diffuse_transmission/diffuseTransmissionColorFactor", 0},
      {material + "pbrSpecularGlossiness/diffuseFactor", {1, 1, 1}},
      {transform + "offset", {0}},
      {transform + "rotation", "half"},
      {light + "color", "red"},
      {light + "intensity", "bright"},
      {light + "range", -1},
      {light + "spot/innerConeAngle", "narrow"},
      {"/cameras/0/perspective/aspectRatio", 0},
      {"/nodes/0/scale", 2},
      {"/nodes/0/children", 1},
      {"/nodes/0/extensions/KHR_node_visibility/visible", 0},
      {"/meshes/0/primitives/0/mode", 3.5},
      {"/meshes/0/primitives/0/targets", "x"},
      {"/samplers/0/wrapS", "repeat"},
      {"/skins", 3},
      {"/animations", "x"}};
  for (const auto& [place, value] : wrong) {
    GltfBuilder b = of_everything();
    b.json[nlohmann::json::json_pointer(place)] = value;
    const std::string file = put(b);
    const AsosRun run = render({file});
    EXPECT_EQ(run.exit_code, 0) << place << ": " << run.err;
    EXPECT_TRUE(contains(run.err, "asos: warning: " + place + " is not "));
    EXPECT_TRUE(contains(run_asos({"info", file}).out, "Warning: " + place + " is not "));
  }
}

TEST_F(OutsideText, ALongNameMakesNoLongMessage) {
  const std::string name(1 << 20, 'x');
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsRequired"] = {name};
  const AsosRun refused = render({put(b)});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_TRUE(contains(refused.err, "requires the extension xxx"));
  EXPECT_TRUE(contains(refused.err, "xxx, which is not supported"));
  EXPECT_LT(refused.err.size(), 1000u);
  GltfBuilder odd = GltfBuilder::square();
  odd.json["materials"] = {{{"name", name}, {"alphaMode", "NONE"}}};
  odd.json["meshes"][0]["primitives"][0]["material"] = 0;
  const AsosRun warned = render({put(odd)});
  EXPECT_TRUE(contains(warned.err, "its alpha mode 'NONE' is unknown"));
  EXPECT_LT(warned.err.size(), 1000u);
}

TEST_F(OutsideText, ASceneWhoseNameIsNoUtf8IsFoundAgain) {
  for (const std::string name : {"caf\xe9.glb", "file:%41.glb", "100%.glb", "\xff\n.glb"}) {
    const std::string file = put(GltfBuilder::square(), name);
    ASSERT_EQ(render({file}).exit_code, 0) << name;
    const AsosRun again = run_asos(
        {"render", "--from", folder_.file("picture.png"), "-o", folder_.file("again.png")});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(read_png(folder_.file("again.png"))->rgb, read_png(folder_.file("picture.png"))->rgb);
  }
}

}  // namespace
}  // namespace asos::outside_text_test
