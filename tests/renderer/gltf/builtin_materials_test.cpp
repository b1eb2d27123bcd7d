#include "renderer/gltf/load.h"
#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/shapes.h"
#include "renderer/scene/builtin/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

// Materials of the built-in scenes of CGF'98 sections 7.2 to 7.4.

namespace asos {
namespace {

Scene scene_called(const std::string& name) {
  return load_scene("builtin:" + name).value();
}

const Material& material_called(const Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                  [&](const Material& m) { return m.name == name; });
  if (found == scene.materials.end()) throw std::runtime_error("no material is called " + name);
  return *found;
}

const Mesh& mesh_called(const Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.meshes.begin(), scene.meshes.end(),
                                  [&](const Mesh& m) { return m.name == name; });
  if (found == scene.meshes.end()) throw std::runtime_error("no mesh is called " + name);
  return *found;
}

/// The larger mean difference, in bytes, between adjacent columns (`x` and the next) or rows. The
/// image repeats.
double step_at(const Image& image, int x) {
  const auto byte = [&image](int column, int row, int channel) {
    return static_cast<int>(image.rgba[4u * (row * image.width + column) + channel]);
  };
  double columns = 0.0, rows = 0.0;
  const int next = (x + 1) % image.width;
  for (int i = 0; i < image.width; ++i) {
    for (int c = 0; c < 3; ++c) {
      columns += std::abs(byte(x, i, c) - byte(next, i, c));
      rows += std::abs(byte(i, x, c) - byte(i, next, c));
    }
  }
  return std::max(columns, rows) / (3.0 * image.width);
}

TEST(BuiltinTextures, RepeatWithoutASeam) {
  for (const Image& image :
       {builtin::wood_planks(), builtin::clapboards(), builtin::sand_normals(4.0),
        builtin::hammered_normals(1.0), builtin::brushed_normals(1.0)}) {
    ASSERT_EQ(image.width, image.height);
    ASSERT_EQ(image.rgba.size(), 4u * image.width * image.height);
    double largest = 0.0;
    for (int x = 0; x + 1 < image.width; ++x) largest = std::max(largest, step_at(image, x));
    EXPECT_GT(largest, 1.0) << image.name << " is plain";
    EXPECT_LE(step_at(image, image.width - 1), largest) << image.name;
  }
}

TEST(BuiltinTextures, NormalsAreUnitAndUpright) {
  for (const Image& image : {builtin::sand_normals(4.0), builtin::hammered_normals(1.0),
                             builtin::brushed_normals(1.0)}) {
    SCOPED_TRACE(image.name);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      const glm::dvec3 n(image.rgba[i] / 127.5 - 1.0, image.rgba[i + 1] / 127.5 - 1.0,
                         image.rgba[i + 2] / 127.5 - 1.0);
      ASSERT_NEAR(glm::length(n), 1.0, 1.8 / 255.0);  // half a step in each of three bytes
      ASSERT_GT(n.z, 0.5);
      sum += n / n.z;
    }
    // Repeating heights have a mean slope of zero.
    EXPECT_NEAR(sum.x / sum.z, 0.0, 1e-3);
    EXPECT_NEAR(sum.y / sum.z, 0.0, 1e-3);
  }
}

TEST(BuiltinTextures, FlatFacesHaveCoordinatesInMetres) {
  Mesh solid;
  builtin::add_box(solid, {1.0f, 2.0f, 0.5f}, glm::mat4(builtin::turned({0.3, 1.0, -2.0}, 33.0)));
  builtin::add_beam(solid, {0.0f, 0.0f, 0.0f}, {1.0f, 2.0f, 0.5f}, 0.3f, 0.2f);
  builtin::add_texcoords(solid);
  ASSERT_EQ(solid.texcoords[0].size(), solid.positions.size());
  for (const glm::uvec3& t : solid.triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      EXPECT_NEAR(glm::distance(solid.texcoords[0][a], solid.texcoords[0][b]),
                  glm::distance(solid.positions[a], solid.positions[b]), 1e-5f);
    }
  }
}

TEST(BuiltinHouse, TexturedHasThePapersPolygonsAndTextures) {
  const Scene scene = scene_called("house-textured");
  const Mesh& ground = mesh_called(scene, "ground");
  EXPECT_NEAR(static_cast<double>(ground.triangles.size()), 1139.0, 1.0);
  const auto house = static_cast<double>(scene.instanced_triangles() - ground.triangles.size());
  EXPECT_NEAR(house / 2770.0, 1.0, 0.05);

  for (const char* name : {"boards", "gazebo floor", "clapboard"}) {
    const TextureUse& use = material_called(scene, name).base_color_texture;
    ASSERT_TRUE(use.used()) << name;
    const Texture& texture = scene.textures.at(use.texture);
    EXPECT_EQ(texture.wrap_u, Wrap::repeat);
    EXPECT_EQ(scene.images.at(texture.image).name,
              std::string(name) == "clapboard" ? "clapboards" : "wood planks");
    // Texture coordinates are metres; the image covers two of them.
    EXPECT_EQ(use.uv_transform * glm::vec3(2.0f, -4.0f, 1.0f), glm::vec3(1.0f, -2.0f, 1.0f));
  }
  for (const char* name : {"porch floor", "gazebo floor", "walls"}) {
    EXPECT_EQ(mesh_called(scene, name).texcoords[0].size(),
              mesh_called(scene, name).positions.size())
        << name;
  }
}

TEST(BuiltinHouse, SandIsAMeshWithTangentsAlongItsTexture) {
  const Scene scene = scene_called("house-textured");
  const Mesh& ground = mesh_called(scene, "ground");
  EXPECT_TRUE(material_called(scene, "sand").normal_texture.used());
  ASSERT_EQ(ground.tangents.size(), ground.positions.size());
  bool uneven = false;
  for (std::size_t i = 0; i < ground.positions.size(); ++i) {
    const glm::vec3 p = ground.positions[i], tangent(ground.tangents[i]);
    ASSERT_EQ(ground.texcoords[0][i], glm::vec2(p.x, p.z));
    ASSERT_NEAR(glm::length(tangent), 1.0f, 1e-5f);
    ASSERT_NEAR(glm::dot(tangent, ground.normals[i]), 0.0f, 1e-5f);
    // Green points against v, that is towards -z.
    ASSERT_LT(ground.tangents[i].w * glm::cross(ground.normals[i], tangent).z, -0.9f);
    if (std::abs(p.x) < 10.0f && std::abs(p.z) < 8.0f) {
      ASSERT_EQ(p.y, 0.0f) << "the house stands on level sand";
    }
    uneven = uneven || p.y > 0.5f;
  }
  EXPECT_TRUE(uneven);
}

TEST(BuiltinHouse, TexturedHasABallWherePlainHasASun) {
  const Scene plain = scene_called("house"), textured = scene_called("house-textured");
  const Light &sun = plain.lights.at(0), &ball = textured.lights.at(0);
  EXPECT_EQ(ball.type, Light::Type::point);
  EXPECT_GT(ball.radius, 1.0);
  const double d = glm::length(ball.position);
  EXPECT_NEAR(glm::dot(ball.position / d, -sun.direction), 1.0, 1e-12);
  EXPECT_NEAR(static_cast<double>(ball.intensity) / (d * d), static_cast<double>(sun.intensity),
              1e-5);
  ASSERT_EQ(textured.lights.size(), plain.lights.size());
}

TEST(BuiltinHouse, MirroredStandsOnAPerfectMirrorWithoutTexturesAndShadows) {
  const Scene scene = scene_called("house-mirror");
  const Material& mirror = material_called(scene, "mirror");
  EXPECT_EQ(mirror.metallic, 1.0f);
  EXPECT_EQ(mirror.roughness, 0.0f);
  EXPECT_EQ(mirror.base_color, glm::vec4(1.0f));
  EXPECT_EQ(scene.materials.at(mesh_called(scene, "mirror").material).name, "mirror");
  EXPECT_TRUE(scene.textures.empty());
  for (const Light& light : scene.lights) EXPECT_FALSE(light.casts_shadows) << light.name;
}

TEST(BuiltinOffice, MetalDiffersFromTheOfficeInDeskAndWhiteboard) {
  const Scene office = scene_called("office"), metal = scene_called("office-metal");
  EXPECT_EQ(metal.instanced_triangles(), office.instanced_triangles());
  const Material& top = material_called(metal, "desk top");
  EXPECT_EQ(top.metallic, 1.0f);
  EXPECT_EQ(top.roughness, 0.15f);
  EXPECT_EQ(material_called(metal, "whiteboard").metallic, 0.0f);
  EXPECT_EQ(material_called(metal, "whiteboard").roughness, 0.1f);
  // The camera is nearer to the centre of the desk's top.
  const auto distance = [](const Scene& scene) {
    const glm::dvec3 eye(scene.cameras.at(0).world_from_camera[3]);
    return glm::distance(eye, glm::dvec3(-0.15, 0.74, -0.75));
  };
  EXPECT_LT(distance(metal), 0.5 * distance(office));
}

TEST(BuiltinSolids, AreMirrorsOfDifferentTintsOnAPlaneThatReflectsNothing) {
  const Scene scene = scene_called("solids");
  ASSERT_EQ(scene.shapes.size(), 3u);
  std::vector<glm::vec4> tints;
  for (const Instance& instance : scene.instances) {
    const Material& m = scene.materials.at(scene.meshes.at(instance.mesh).material);
    if (instance.shape < 0) {
      EXPECT_EQ(m.metallic, 0.0f);
      EXPECT_EQ(m.specular, 0.0f);
      continue;
    }
    EXPECT_EQ(m.metallic, 1.0f) << instance.name;
    EXPECT_EQ(m.roughness, 0.0f) << instance.name;
    EXPECT_EQ(std::count(tints.begin(), tints.end(), m.base_color), 0) << instance.name;
    tints.push_back(m.base_color);
  }
  EXPECT_EQ(tints.size(), 3u);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_GT(scene.lights[0].radius, 0.0);
}

TEST(BuiltinWorkshop, IsOfRoughMetalWithMapsOfNormals) {
  const Scene scene = scene_called("workshop");
  std::vector<int> maps;
  for (const Mesh& mesh : scene.meshes) {
    const Material& m = scene.materials.at(mesh.material);
    if (!m.normal_texture.used()) continue;
    SCOPED_TRACE(m.name);
    maps.push_back(m.normal_texture.texture);
    EXPECT_EQ(m.metallic, 1.0f);
    // Rougher than the default limit of mirrors: the metal reflects only the lamps.
    EXPECT_GT(m.roughness, 0.35f);
    EXPECT_EQ(mesh.texcoords[0].size(), mesh.positions.size());
  }
  EXPECT_GE(maps.size(), 8u);
  EXPECT_GT(std::count(maps.begin(), maps.end(), 0), 2) << "hammered";
  EXPECT_GT(std::count(maps.begin(), maps.end(), 1), 2) << "brushed";
}

TEST(BuiltinWorkshop, RoundMetalHasCoordinatesInMetresWithoutASeam) {
  const Scene scene = scene_called("workshop");
  const Mesh& pipes = mesh_called(scene, "copper pipes");
  for (const glm::uvec3& t : pipes.triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      const float apart = glm::distance(pipes.positions[a], pipes.positions[b]);
      // An arc is longer than its chord, here by 0.2 %.
      EXPECT_NEAR(glm::distance(pipes.texcoords[0][a], pipes.texcoords[0][b]), apart,
                  0.004f * apart + 1e-5f);
    }
  }
}

}  // namespace
}  // namespace asos
