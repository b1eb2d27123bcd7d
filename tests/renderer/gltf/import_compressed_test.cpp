#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/renderer/gltf/load_timer.h"

#include <gtest/gtest.h>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

namespace asos {
namespace {

using test::GltfBuilder;
using test::load_in_time;

/// The corner points of all triangles, in order.
std::vector<glm::vec3> corners(const Scene& scene) {
  std::vector<glm::vec3> points;
  for (const Mesh& mesh : scene.meshes) {
    for (const glm::uvec3 t : mesh.triangles) {
      points.insert(points.end(), {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
    }
  }
  return points;
}

/// A square whose buffer views are compressed with meshoptimizer.
GltfBuilder meshopt_square() {
  const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<unsigned> indices{0, 1, 2, 0, 2, 3};
  std::vector<unsigned char> v(meshopt_encodeVertexBufferBound(4, sizeof(glm::vec3)));
  v.resize(meshopt_encodeVertexBuffer(v.data(), v.size(), positions.data(), 4, sizeof(glm::vec3)));
  std::vector<unsigned char> i(meshopt_encodeIndexBufferBound(6, 4));
  i.resize(meshopt_encodeIndexBuffer(i.data(), i.size(), indices.data(), 6));

  GltfBuilder b;
  const int vertex_view = b.view(v), index_view = b.view(i);
  const auto compress = [&](int view, const char* mode, int stride, int count) {
    auto& declared = b.json["bufferViews"][view];
    nlohmann::json ext = {{"buffer", 0},
                          {"byteOffset", declared["byteOffset"]},
                          {"byteLength", declared["byteLength"]},
                          {"byteStride", stride},
                          {"count", count},
                          {"mode", mode}};
    // The view describes the decompressed bytes in a placeholder buffer.
    declared = {{"buffer", 1}, {"byteLength", stride * count}};
    declared["extensions"]["EXT_meshopt_compression"] = ext;
  };
  compress(vertex_view, "ATTRIBUTES", 12, 4);
  compress(index_view, "TRIANGLES", 4, 6);
  b.primitive({{"POSITION", b.accessor(vertex_view, 5126, "VEC3", 4)}})["indices"] =
      b.accessor(index_view, 5125, "SCALAR", 6);
  b.json["extensionsUsed"] = b.json["extensionsRequired"] = {"EXT_meshopt_compression"};
  return b;
}

TEST(ImportCompressed, DecodesMeshopt) {
  const Result<Scene> scene = load_in_time(meshopt_square());
  ASSERT_TRUE(scene) << scene.error().message();
  const std::vector<glm::vec3> expected{{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                        {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(corners(*scene), expected);
}

TEST(ImportCompressed, MeshoptThatClaimsTooMuchIsRefused) {
  GltfBuilder b = meshopt_square();
  b.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["count"] = 2'000'000'000;
  const Result<Scene> scene = load_in_time(b);
  ASSERT_FALSE(scene);
  EXPECT_NE(scene.error().reason.find("cannot hold"), std::string::npos) << scene.error().message();
}

// Each view decompresses to the allowed size, but they share their compressed bytes.
TEST(ImportCompressed, MeshoptThatManyViewsShareIsCounted) {
  constexpr std::size_t count = 3 * 5461;
  const std::vector<glm::vec3> positions(count, glm::vec3(1));
  std::vector<unsigned char> v(meshopt_encodeVertexBufferBound(count, sizeof(glm::vec3)));
  v.resize(
      meshopt_encodeVertexBuffer(v.data(), v.size(), positions.data(), count, sizeof(glm::vec3)));
  GltfBuilder b;
  const int packed = b.view(v.data(), v.size());
  const nlohmann::json at = b.json["bufferViews"][static_cast<std::size_t>(packed)];
  b.json["extensionsUsed"] = {"EXT_meshopt_compression"};
  for (int i = 0; i < 400; ++i) {
    nlohmann::json view{{"buffer", 0}, {"byteLength", count * sizeof(glm::vec3)}};
    nlohmann::json& extension = view["extensions"]["EXT_meshopt_compression"] = at;
    extension["mode"] = "ATTRIBUTES";
    extension["byteStride"] = sizeof(glm::vec3);
    extension["count"] = count;
    b.json["bufferViews"].push_back(view);
    b.primitive({{"POSITION", b.accessor(packed + 1 + i, 5126, "VEC3", count)}});
  }
  const Result<Scene> scene = load_in_time(b);
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_GE(scene->meshes.size(), 2u);
  EXPECT_LT(scene->meshes.size(), 200u);
  ASSERT_FALSE(scene->notes.warnings.empty());
  EXPECT_NE(scene->notes.warnings[0].find("more than the file can hold"), std::string::npos)
      << scene->notes.warnings[0];
}

TEST(ImportCompressed, BrokenMeshoptIsNamed) {
  GltfBuilder b = meshopt_square();
  b.bin[0] = '\x11';
  const Result<Scene> scene = load_in_time(b);
  ASSERT_FALSE(scene);
  EXPECT_NE(scene.error().reason.find("meshopt data cannot be decoded"), std::string::npos)
      << scene.error().message();
}

/// A square in a Draco stream; its accessors have no data.
GltfBuilder draco_square(int method) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2);
  const int id = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const glm::vec3 p[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  builder.SetAttributeValuesForFace(id, draco::FaceIndex(0), &p[0], &p[1], &p[2]);
  builder.SetAttributeValuesForFace(id, draco::FaceIndex(1), &p[0], &p[2], &p[3]);
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  draco::EncoderBuffer encoded;
  if (!encoder.EncodeMeshToBuffer(*mesh, &encoded).ok()) throw std::runtime_error("draco");

  GltfBuilder b;
  const int view = b.view(encoded.data(), encoded.size());
  auto& primitive = b.primitive({{"POSITION", b.accessor(-1, 5126, "VEC3", 4)}});
  primitive["indices"] = b.accessor(-1, 5125, "SCALAR", 6);
  primitive["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", view}, {"attributes", {{"POSITION", mesh->attribute(0)->unique_id()}}}};
  b.json["extensionsUsed"] = b.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return b;
}

TEST(ImportCompressed, DecodesDraco) {
  for (const int method : {static_cast<int>(draco::MESH_SEQUENTIAL_ENCODING),
                           static_cast<int>(draco::MESH_EDGEBREAKER_ENCODING)}) {
    const Result<Scene> scene = load_in_time(draco_square(method));
    ASSERT_TRUE(scene) << scene.error().message();
    ASSERT_EQ(scene->instanced_triangles(), 2u);
    double area = 0.0;
    const std::vector<glm::vec3> points = corners(*scene);
    for (std::size_t i = 0; i < points.size(); i += 3) {
      area += 0.5 * static_cast<double>(
                        glm::cross(points[i + 1] - points[i], points[i + 2] - points[i]).z);
    }
    EXPECT_NEAR(area, 1.0, 1e-3) << "the triangles cover the square once and face +Z";
  }
}

TEST(ImportCompressed, DracoThatClaimsMoreThanIsDeclaredIsRefused) {
  GltfBuilder b = draco_square(draco::MESH_SEQUENTIAL_ENCODING);
  b.json["accessors"][1]["count"] = 3;
  const Result<Scene> scene = load_in_time(b);
  ASSERT_FALSE(scene);
  EXPECT_NE(scene.error().reason.find("claims 2 faces where 1"), std::string::npos)
      << scene.error().message();
}

TEST(ImportCompressed, BrokenStreamsAreSurvived) {
  for (const GltfBuilder& whole :
       {draco_square(draco::MESH_SEQUENTIAL_ENCODING),
        draco_square(draco::MESH_EDGEBREAKER_ENCODING), meshopt_square()}) {
    for (std::size_t at = 0; at < whole.bin.size(); ++at) {
      for (const char value : {'\0', '\x7f', '\xff'}) {
        GltfBuilder b = whole;
        b.bin[at] = value;
        const Result<Scene> scene = load_in_time(b);
        if (scene) {
          EXPECT_LE(scene->instanced_triangles(), 2u);
        } else {
          EXPECT_FALSE(scene.error().reason.empty());
        }
      }
    }
  }
}

}  // namespace
}  // namespace asos
