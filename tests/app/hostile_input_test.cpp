#include "renderer/film/image_io.h"
#include "renderer/picture/picture_description.h"
#include "tests/app/run_asos.h"
#include "tests/renderer/gltf/gltf_builder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <sys/stat.h>
#include <vector>

namespace asos::hostile_input_test {
namespace {

using test::AsosRun;
using test::contains;
using test::GltfBuilder;
using test::operator+;
using test::run_asos;

// Malicious or unusual files. A failed assertion of Debian's Embree would end the program and this
// test.
class HostileInput : public testing::Test {
 protected:
  std::string put(const GltfBuilder& file, const std::string& name = "scene.glb") {
    return folder_.write(name, file.glb());
  }
  AsosRun render(const std::vector<std::string>& words, const std::string& size = "16x12") {
    return run_asos(
        std::vector<std::string>{"render", "-o", picture(), "--size", size, "--max", "2"} + words);
  }
  [[nodiscard]] std::string picture() const { return folder_.file("picture.png"); }

  test::TemporaryFolder folder_;
};

/// A square, and a camera at `eye` that sees it.
GltfBuilder square_with_camera(glm::dvec3 eye, const nlohmann::json& camera) {
  GltfBuilder b = GltfBuilder::square();
  b.json["cameras"] = nlohmann::json::array({camera});
  b.json["nodes"].push_back({{"camera", 0}, {"translation", {eye.x, eye.y, eye.z}}});
  b.json["scenes"][0]["nodes"] = {0, 1};
  return b;
}

const nlohmann::json perspective{{"type", "perspective"},
                                 {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}};

nlohmann::json orthographic(double size) {
  return {{"type", "orthographic"},
          {"orthographic", {{"xmag", size}, {"ymag", size}, {"znear", 0}, {"zfar", 1}}}};
}

TEST_F(HostileInput, GeometryThatCollapsesToAPointIsRendered) {
  for (const int copies : {1, 2, 3, 9}) {
    for (const nlohmann::json& place :
         {nlohmann::json{{"scale", {0, 0, 0}}}, nlohmann::json{{"scale", {1e-30, 1e-30, 1e-30}}},
          nlohmann::json{{"scale", {0, 1, 0}}}}) {
      for (const bool shines : {false, true}) {
        GltfBuilder b = GltfBuilder::square();
        b.json["materials"] = {{{"emissiveFactor", std::vector<int>(3, shines ? 1 : 0)}}};
        b.json["meshes"][0]["primitives"][0]["material"] = 0;
        for (int i = 0; i < copies; ++i) {
          nlohmann::json node = place;
          node["mesh"] = 0;
          if (i % 2) node["extras"] = {{"asos_shape", {{"type", "sphere"}, {"radius", 1}}}};
          b.json["nodes"][static_cast<std::size_t>(i)] = node;
          b.json["scenes"][0]["nodes"][static_cast<std::size_t>(i)] = i;
        }
        const std::string file = put(b);
        const AsosRun run = render({file});
        EXPECT_EQ(run.exit_code, 0) << copies << " " << place << ": " << run.err;
        EXPECT_EQ(run_asos({"info", file}).exit_code, 0) << copies << " " << place;
      }
    }
  }
}

TEST_F(HostileInput, GeometryBeyondTheLimitIsRefusedByName) {
  for (const double size : {1e15, 1.1e15, 5e17, 2e18, 1e30}) {
    GltfBuilder b = GltfBuilder::square();
    b.node()["scale"] = {size, size, size};
    const std::string file = put(b);
    const AsosRun run = render({file});
    EXPECT_EQ(run.exit_code, size > 1e15 ? 1 : 0) << size << ": " << run.err;
    if (size > 1e15) {
      EXPECT_TRUE(contains(run.err, "scene.glb: is "));
      EXPECT_TRUE(contains(run.err, "the limit is 1e+15"));
      EXPECT_EQ(run_asos({"info", file}).exit_code, 1) << size;
    }
  }
}

TEST_F(HostileInput, ACameraBeyondTheLimitIsLeftOutOfItsFile) {
  for (const double far : {1e16, 1e19, 1e38, 1e300}) {
    for (const glm::dvec3 way : {glm::dvec3(0, 0, 1), glm::dvec3(-1, 0, 0)}) {
      const std::string file = put(square_with_camera(far * way, perspective));
      EXPECT_EQ(render({file}).exit_code, 0) << far;
      EXPECT_TRUE(contains(run_asos({"info", file}).out, "\"eye\" is farther away than 1e+15"));
    }
    const std::string wide = put(square_with_camera({0, 0, 1}, orthographic(far)));
    EXPECT_EQ(render({wide}).exit_code, 0) << far;
    EXPECT_TRUE(contains(run_asos({"info", wide}).out, "\"height\" is more than 1e+15"));
  }
}

TEST_F(HostileInput, ACameraAtTheLimitRenders) {
  for (const glm::dvec3 way : {glm::dvec3(0, 0, 1), glm::dvec3(1, -1, 1)}) {
    EXPECT_EQ(render({put(square_with_camera(1e15 * way, perspective))}).exit_code, 0);
    EXPECT_EQ(render({put(square_with_camera(1e15 * way, orthographic(5e14)))}).exit_code, 0);
  }
  const std::string square = put(GltfBuilder::square());
  EXPECT_EQ(render({square, "--look-at", "1e15,0,1e15,0,0,0"}).exit_code, 0);
  const AsosRun beyond = render({square, "--look-at", "0,0,2e15,0,0,0"});
  EXPECT_EQ(beyond.exit_code, 2);
  EXPECT_TRUE(contains(beyond.err, "1e+15"));
}

TEST_F(HostileInput, AnExtremeProportionOfThePictureFramesTheLargestScene) {
  GltfBuilder b = GltfBuilder::square();
  b.node()["scale"] = {1e15, 1e15, 1e15};
  EXPECT_EQ(render({put(b)}, "1x2048").exit_code, 0);
  EXPECT_EQ(render({put(b)}, "2048x1").exit_code, 0);
}

TEST_F(HostileInput, ALightBeyondTheLimitIsLeftOut) {
  for (const double far : {1e16, 1e30, 1e200}) {
    GltfBuilder b = GltfBuilder::square();
    b.json["extensionsUsed"] = {"KHR_lights_punctual"};
    b.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    b.json["nodes"].push_back(
        {{"translation", {0, 0, far}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    b.json["scenes"][0]["nodes"] = {0, 1};
    const std::string file = put(b);
    EXPECT_EQ(render({file}).exit_code, 0) << far;
    EXPECT_TRUE(contains(run_asos({"info", file}).out, "is farther away than 1e+15; left out"));
  }
}

TEST_F(HostileInput, ASavedPictureWithACameraBeyondTheLimitIsRefused) {
  PictureDescription d;
  d.scene = "builtin:boxes";
  const auto saved = [&](const PictureDescription& description) {
    const std::string file = folder_.file("saved.png");
    EXPECT_TRUE(write_png(
        file,
        RgbImage{1, 1, {1, 2, 3}, {{PictureDescription::key, description_text(description)}}}));
    return render({"--from", file});
  };
  ASSERT_EQ(saved(d).exit_code, 0);
  for (const double far : {1.1e15, 9e18, 1e300}) {
    PictureDescription away = d;
    away.camera.world_from_camera[3].x = far;
    AsosRun run = saved(away);
    EXPECT_EQ(run.exit_code, 1) << far;
    EXPECT_TRUE(contains(run.err,
                         "saved.png: what it says of its picture is damaged: camera: "
                         "\"eye\" is farther away than 1e+15"));
    PictureDescription wide = d;
    wide.camera.type = Camera::Type::orthographic;
    wide.camera.height = far;
    run = saved(wide);
    EXPECT_EQ(run.exit_code, 1) << far;
    EXPECT_TRUE(contains(run.err, "\"height\" is more than 1e+15"));
    // Another origin moves the camera by the same distance.
    PictureDescription moved = d;
    moved.origin.y = far;
    run = saved(moved);
    EXPECT_EQ(run.exit_code, 1) << far;
    EXPECT_TRUE(contains(run.err, "\"eye\" is farther away than 1e+15"));
    PictureDescription lit = d;
    lit.lights.emplace(1).front().position.z = far;
    run = saved(lit);
    EXPECT_EQ(run.exit_code, 1) << far;
    EXPECT_TRUE(contains(run.err, "is farther away than 1e+15"));
  }
}

TEST_F(HostileInput, WhatAPictureIsMadeOfIsNotWrittenOver) {
  GltfBuilder b = GltfBuilder::square();
  b.json["images"] = {{{"uri", "maps/wood.png"}}};
  b.json["textures"] = {{{"source", 0}}};
  b.json["materials"] = {{{"emissiveTexture", {{"index", 0}}}}};
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  const std::string scene = put(b);
  std::filesystem::create_directory(folder_.file("maps"));
  const std::string texture = folder_.file("maps/wood.png"), sky = folder_.file("sky.exr");
  ASSERT_TRUE(write_png(texture, RgbImage{1, 1, {1, 2, 3}, {}}));
  Film film(2, 1);
  film.radiance.assign(2, glm::vec3(0.5f));
  ASSERT_TRUE(write_exr(sky, film, {}));
  const std::string link = folder_.file("link.png");
  std::filesystem::create_symlink(texture, link);
  const std::string all =
      test::content_of(scene) + test::content_of(texture) + test::content_of(sky);
  const std::string free = folder_.file("free.png");
  for (const std::vector<std::string>& words : {std::vector<std::string>{"-o", texture},
                                                {"-o", link},
                                                {"-o", free, "--split-map", texture},
                                                {"-o", free, "--stats", scene},
                                                {"-o", sky, "--sky", sky}}) {
    const AsosRun run =
        run_asos(std::vector<std::string>{"render", scene, "--size", "8x6"} + words);
    EXPECT_EQ(run.exit_code, 1) << words.back() << run.out;
    EXPECT_TRUE(contains(run.err, "is what the picture is made of"));
  }
  EXPECT_EQ(test::content_of(scene) + test::content_of(texture) + test::content_of(sky), all);
  EXPECT_FALSE(std::filesystem::exists(free));
  EXPECT_EQ(render({scene, "--sky", sky}).exit_code, 0);
  EXPECT_EQ(render({scene, "--sky", sky}).exit_code, 0) << "a picture may be made again";
}

TEST_F(HostileInput, NoFrameIsRenderedWhereALaterOneWouldWriteOverAnInput) {
  GltfBuilder b = GltfBuilder::square();
  b.json["images"] = {{{"uri", "wood-2.png"}}};
  b.json["textures"] = {{{"source", 0}}};
  b.json["materials"] = {{{"emissiveTexture", {{"index", 0}}}}};
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  const std::string scene = put(b), texture = folder_.file("wood-2.png");
  ASSERT_TRUE(write_png(texture, RgbImage{1, 1, {1, 2, 3}, {}}));
  const std::string before = test::content_of(texture);
  const auto turn = [&](const char* frames) {
    return run_asos(
        {"render", scene, "--size", "8x6", "-o", folder_.file("wood.png"), "--frames", frames});
  };
  const AsosRun run = turn("0-3/4");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "wood-2.png: is what the picture is made of"));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("wood-0.png")));
  EXPECT_EQ(test::content_of(texture), before);
  // A frame that cannot be written is reported before the first one is rendered.
  std::filesystem::create_directory(folder_.file("wood-1.png"));
  EXPECT_EQ(turn("0-1/4").exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("wood-0.png")));
  EXPECT_EQ(turn("3/4").exit_code, 0);
}

TEST_F(HostileInput, PipesAndDevicesAreRefusedAtOnce) {
  for (const char* ending : {".gltf", ".glb", ".hdr", ".exr", ".png"}) {
    const std::string pipe = folder_.file(std::string("pipe") + ending);
    const std::string zero = folder_.file(std::string("zero") + ending);
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", zero);
    for (const std::string& file : {pipe, zero}) {
      for (const std::vector<std::string>& words :
           {std::vector<std::string>{file}, {"builtin:boxes", "--sky", file}, {"--from", file}}) {
        const bool sky = words[0] == "builtin:boxes";
        if (sky && file.substr(file.size() - 3) != "hdr" && file.substr(file.size() - 3) != "exr")
          continue;
        const AsosRun run = render(words);
        EXPECT_EQ(run.exit_code, 1) << file;
        EXPECT_TRUE(contains(run.err, "is not a regular file")) << words[0];
      }
      EXPECT_EQ(run_asos({"info", file}).exit_code, 1);
    }
  }
}

}  // namespace
}  // namespace asos::hostile_input_test
