#include "renderer/gltf/load.h"
#include "renderer/scene/builtin.h"
#include "tests/renderer/gltf/light_checks.h"
#include "tests/renderer/gltf/moving_file.h"
#include "tests/renderer/gltf/rich_scene.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

// Exported scenes are read back unchanged.

namespace asos {
namespace {

void expect_equal(const TextureUse& a, const TextureUse& b) {
  EXPECT_EQ(a.texture, b.texture);
  EXPECT_EQ(a.texcoord, b.texcoord);
  EXPECT_EQ(a.scale, b.scale);
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) EXPECT_NEAR(a.uv_transform[c][r], b.uv_transform[c][r], 1e-6f);
  }
}

void expect_equal(const Material& a, const Material& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.base_color, b.base_color);
  EXPECT_EQ(a.metallic, b.metallic);
  EXPECT_EQ(a.roughness, b.roughness);
  EXPECT_EQ(a.emissive, b.emissive);
  EXPECT_EQ(a.emissive_strength, b.emissive_strength);
  EXPECT_EQ(a.alpha_mode, b.alpha_mode);
  if (a.alpha_mode == AlphaMode::mask) {
    EXPECT_EQ(a.alpha_cutoff, b.alpha_cutoff);
  }
  EXPECT_EQ(a.double_sided, b.double_sided);
  EXPECT_EQ(a.unlit, b.unlit);
  EXPECT_EQ(a.ior, b.ior);
  EXPECT_EQ(a.transmission, b.transmission);
  EXPECT_EQ(a.specular, b.specular);
  EXPECT_EQ(a.specular_color, b.specular_color);
  EXPECT_EQ(a.dfr, b.dfr);
  EXPECT_EQ(a.film.factor, b.film.factor);
  EXPECT_EQ(a.film.ior, b.film.ior);
  EXPECT_EQ(a.film.thickness_min_nm, b.film.thickness_min_nm);
  EXPECT_EQ(a.film.thickness_max_nm, b.film.thickness_max_nm);
  EXPECT_EQ(a.anisotropy.strength, b.anisotropy.strength);
  EXPECT_EQ(a.anisotropy.rotation_rad, b.anisotropy.rotation_rad);
  EXPECT_EQ(a.diffuse_transmission.factor, b.diffuse_transmission.factor);
  EXPECT_EQ(a.diffuse_transmission.color, b.diffuse_transmission.color);
  EXPECT_EQ(a.volume.thickness, b.volume.thickness);
  EXPECT_EQ(a.volume.attenuation_distance, b.volume.attenuation_distance);
  EXPECT_EQ(a.volume.attenuation_color, b.volume.attenuation_color);
  EXPECT_EQ(a.volume.dispersion, b.volume.dispersion);
  EXPECT_EQ(a.coat.factor, b.coat.factor);
  EXPECT_EQ(a.coat.roughness, b.coat.roughness);
  EXPECT_EQ(a.sheen.color, b.sheen.color);
  EXPECT_EQ(a.sheen.roughness, b.sheen.roughness);
  const auto textures_a = texture_uses(a), textures_b = texture_uses(b);
  for (std::size_t i = 0; i < textures_a.size(); ++i) expect_equal(*textures_a[i], *textures_b[i]);
}

void expect_equal(const Camera& a, const Camera& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.type, b.type);
  EXPECT_EQ(a.aspect_ratio, b.aspect_ratio);
  if (a.type == Camera::Type::perspective) {
    EXPECT_EQ(a.fov_y_rad, b.fov_y_rad);
  } else {
    EXPECT_EQ(a.height, b.height);
  }
  for (int c = 0; c < 4; ++c) {
    EXPECT_LT(glm::length(a.world_from_camera[c] - b.world_from_camera[c]), 1e-12);
  }
}

void expect_equal(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.name, b.name);
  ASSERT_EQ(a.instances.size(), b.instances.size());
  for (std::size_t i = 0; i < a.instances.size(); ++i) {
    const Mesh& was = a.meshes.at(a.instances[i].mesh);
    const Mesh& is = b.meshes.at(b.instances[i].mesh);
    SCOPED_TRACE(a.instances[i].name);
    EXPECT_EQ(a.instances[i].name, b.instances[i].name);
    EXPECT_EQ(a.instances[i].world_from_mesh, b.instances[i].world_from_mesh);
    EXPECT_EQ(a.instances[i].shows_light, b.instances[i].shows_light);
    EXPECT_TRUE(was.positions == is.positions);
    EXPECT_TRUE(was.triangles == is.triangles);
    EXPECT_TRUE(was.colors == is.colors);
    EXPECT_EQ(was.material, is.material);
    ASSERT_EQ(was.normals.size(), is.normals.size());
    for (std::size_t v = 0; v < was.normals.size(); ++v) {
      ASSERT_LT(glm::length(was.normals[v] - is.normals[v]), 1e-6f);
    }
  }
  ASSERT_EQ(a.materials.size(), b.materials.size());
  for (std::size_t i = 0; i < a.materials.size(); ++i) {
    SCOPED_TRACE(a.materials[i].name);
    expect_equal(a.materials[i], b.materials[i]);
  }
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i) test::expect_equal(a.lights[i], b.lights[i]);
  ASSERT_EQ(a.cameras.size(), b.cameras.size());
  for (std::size_t i = 0; i < a.cameras.size(); ++i) expect_equal(a.cameras[i], b.cameras[i]);
}

TEST(ExportRoundTrip, OfARichScene) {
  const test::TemporaryFolder folder;
  for (const char* name : {"rich.glb", "a name with spaces \u00e9.gltf"}) {
    SCOPED_TRACE(name);
    const Scene scene = test::rich_scene();
    ASSERT_TRUE(export_gltf(scene, folder.file(name)));
    const Result<Scene> back = import_gltf(folder.file(name));
    ASSERT_TRUE(back) << back.error().message();
    expect_equal(scene, *back);
    EXPECT_TRUE(back->notes.warnings.empty());
    EXPECT_TRUE(back->notes.unsupported_extensions.empty());
    ASSERT_EQ(back->images.size(), 1u);
    EXPECT_EQ(back->images[0].rgba, scene.images[0].rgba);
    ASSERT_EQ(back->textures.size(), 2u);
    EXPECT_EQ(back->textures[0].wrap_u, Wrap::clamp_to_edge);
    EXPECT_EQ(back->textures[0].wrap_v, Wrap::mirrored_repeat);
    EXPECT_EQ(back->textures[0].filter, Filter::nearest);
  }
}

TEST(ExportRoundTrip, KeepsTheClippingPlanesOfCameras) {
  const test::TemporaryFolder folder;
  for (const double near : {0.002, 0.5}) {
    Scene scene = test::rich_scene();
    ASSERT_GE(scene.cameras.size(), 2u);
    for (Camera& camera : scene.cameras) {
      camera.near_depth = near;
      camera.far_depth = 20.0 * near;
    }
    ASSERT_TRUE(export_gltf(scene, folder.file("planes.glb")));
    const Result<Scene> again = import_gltf(folder.file("planes.glb"));
    ASSERT_TRUE(again) << again.error().message();
    ASSERT_EQ(again->cameras.size(), scene.cameras.size());
    for (const Camera& camera : again->cameras) {
      EXPECT_EQ(camera.near_depth, near);
      EXPECT_EQ(camera.far_depth, 20.0 * near);
    }
  }
}

TEST(ExportRoundTrip, OfEveryBuiltinScene) {
  const test::TemporaryFolder folder;
  for (const BuiltinScene& builtin : builtin_scenes()) {
    SCOPED_TRACE(builtin.name);
    const Scene scene = builtin.make();
    ASSERT_TRUE(export_gltf(scene, folder.file(builtin.name + ".glb")));
    const Result<Scene> back = import_gltf(folder.file(builtin.name + ".glb"));
    ASSERT_TRUE(back) << back.error().message();
    expect_equal(scene, *back);
    EXPECT_TRUE(back->notes.warnings.empty());
    EXPECT_EQ(back->contents.animations.size(), scene.contents.animations.size());
  }
}

TEST(ExportRoundTrip, KeepsTheMotionOfObjects) {
  const test::TemporaryFolder folder;
  for (const char* name : {"turning-fence", "walking-pole"}) {
    SCOPED_TRACE(name);
    const Scene scene = *builtin_scene(name);
    ASSERT_TRUE(writes_animations(scene));
    ASSERT_TRUE(export_gltf(scene, folder.file("moving.glb")));
    const Scene back = *import_gltf(folder.file("moving.glb"), {.keep_posable = true});
    ASSERT_EQ(back.contents.animations.size(), 1u);
    const SceneContents::Animation& clip = scene.contents.animations[0];
    EXPECT_EQ(back.contents.animations[0].name, clip.name);
    EXPECT_EQ(back.contents.animations[0].seconds, clip.seconds);
    for (const double fraction : {0.0, 0.13, 0.5, 0.81, 1.0}) {
      const Scene a = test::posed(scene, fraction * clip.seconds);
      const Scene b = test::posed(back, fraction * clip.seconds);
      const glm::dmat4& expected = a.instances.back().world_from_mesh;
      const glm::dmat4& found = b.instances.back().world_from_mesh;
      for (int c = 0; c < 4; ++c)
        EXPECT_LT(glm::distance(found[c], expected[c]), 1e-6) << fraction << " column " << c;
    }
  }
}

/// Bends a mesh instead of moving an object.
class BendingRig final : public PosableScene {
 public:
  explicit BendingRig(Scene scene) : scene_(std::move(scene)) {}
  Result<Scene> pose(const std::optional<ClipTime>& time) override {
    Scene bent = scene_;
    if (time) bent.meshes[0].positions[0].y += static_cast<float>(time->seconds);
    return bent;
  }

 private:
  Scene scene_;
};

TEST(ExportRoundTrip, AMotionWithinAMeshIsLeftOut) {
  Scene scene = *builtin_scene("walking-pole");
  scene.rig = nullptr;
  EXPECT_FALSE(writes_animations(scene)) << "nothing poses it";
  scene.rig = std::make_shared<BendingRig>(scene);
  EXPECT_FALSE(writes_animations(scene));
}

}  // namespace
}  // namespace asos
