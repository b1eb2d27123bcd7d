#pragma once

#include "renderer/scene/scene.h"
#include "tests/ui/test_scenes.h"
#include "tests/ui/ui_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace asos::test {
using namespace ui;

/// A window with an open scene and room for the whole panel next to the picture; the panel shows
/// all of its tabs, and there is no bar. Draws blind, and with a picture of 1/36 of the pixels,
/// unless a test changes that.
class PanelsTest : public testing::Test {
 protected:
  /// Renders the picture once at this size of the window; a larger one takes seconds.
  explicit PanelsTest(int pixel_size = 6, glm::ivec2 size = {660, 1000}) : rig(load, size) {
    rig.set_pixel_size(pixel_size);
    StoredSettings stored = rig.content().stored_settings();
    stored.tab = PanelTab::all;
    stored.sections["Advanced (papers)"] = true;
    stored.look.show_bar = false;  // the panel has no controls that the bar shows
    rig.content().apply(stored);
    EXPECT_TRUE(rig.opens("scene") && rig.settle());
    restarts_ = rig.render().restarts();
  }

  /// Drags a slider, from and to fractions of its width.
  void slide(const std::string& name, float from, float to) {
    const Controls::Placed at = rig.control(name);
    const float y = at.centre().y;
    rig.rest();
    rig.drag({std::ceil(glm::mix(at.lo.x, at.hi.x, from)), y}, {glm::mix(at.lo.x, at.hi.x, to), y});
  }
  void choose_method(const std::string& title) {
    rig.click("Method");
    rig.frame();
    rig.click("Method/" + title);
  }
  /// Settles, and returns whether the render has restarted since the last call: changes may wait
  /// for the picture of the previous render.
  bool restarted() {
    EXPECT_TRUE(rig.settle());
    const bool yes = rig.render().restarts() > restarts_;
    restarts_ = rig.render().restarts();
    return yes;
  }
  RenderSettings& settings() { return rig.settings(); }
  DisplaySettings& display() { return rig.state().display; }

  /// Renders every pixel of the window, for tests that read them.
  void show_all_pixels() {
    rig.set_pixel_size(1);
    rig.frame();
    EXPECT_TRUE(restarted());
  }

  UiRig rig;

 private:
  static Result<Scene> load(const std::string& source) {
    if (source.starts_with("missing")) {
      return unexpected(Error{source, "there is no such file"});
    }
    if (source.ends_with("broken.glb")) return unexpected(Error{source, "is no glTF file"});
    return scene_named(source);
  }
  /// A grating, or two triangles with the properties that the name states.
  static Scene scene_named(const std::string& source) {
    if (source == "grating") return test::grating(source);
    Scene scene = test::two_triangles({1, 0, 0}, source);
    scene.materials[0].double_sided = false;  // faces the camera: there are backs to cull
    Light light;
    light.position = {0, 1, 2};
    if (source == "point light") scene.lights.assign(1, light);
    if (source == "nine lights") scene.lights.assign(9, light);
    if (source == "sunlit") {  // matte, under a sun behind the viewer
      for (Material& material : scene.materials) {
        material.unlit = false;
        material.metallic = 0.0f;
      }
      light.type = Light::Type::directional;
      light.direction = {0, 0, -1};
      light.intensity = 1000.0f;
      scene.lights.assign(1, light);
    }
    if (source == "mirrors") {
      // Two equal materials, and a different one.
      scene.materials.resize(2);
      for (Material& material : scene.materials) {
        material.unlit = false;
        material.metallic = 1.0f;
        material.roughness = 0.0f;
      }
      scene.materials[1].roughness = 0.2f;
      scene.materials.push_back(scene.materials[0]);
      scene.materials[0].name = "chrome";
      scene.meshes.push_back(scene.meshes[0]);
      scene.meshes.back().material = 2;
      scene.instances.emplace_back();
      scene.instances.back().mesh = 2;
      scene.instances.back().world_from_mesh[3] = glm::dvec4(2.5, 0, -1, 1);
      light.intensity = 20.0f;
      scene.lights.assign(1, light);
    }
    if (source == "textured") {
      scene.images.push_back({"dots", 2, 2, std::vector<std::uint8_t>(16, 200)});
      scene.textures.push_back({});
      scene.textures[0].image = 0;
      scene.materials[0].base_color_texture.texture = 0;
      scene.meshes[0].texcoords[0] = {{0, 0}, {1, 0}, {0, 1}};
    }
    if (source == "shining") {
      scene.materials[0].unlit = false;
      scene.materials[0].emissive = glm::vec3(2.0f);
    }
    return scene;
  }

  std::uint64_t restarts_ = 0;
};

}  // namespace asos::test
