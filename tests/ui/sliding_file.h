#pragma once

#include "tests/renderer/gltf/moving_file.h"

namespace asos::test {

/// A square that moves two units to the right in one second and stands still for another. A second
/// animation moves a camera backwards. A point light lights the scene.
inline GltfBuilder sliding() {
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = {"KHR_lights_punctual"};
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 30}}};
  b.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}}};
  b.json["nodes"].push_back({{"camera", 0}, {"translation", {1.5, 0.5, 6}}});
  b.json["nodes"].push_back(
      {{"translation", {0, 1, 3}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  b.json["scenes"][0]["nodes"] = {0, 1, 2};
  add_channel(b, 0, "translation", b.scalars({0, 1, 2}), b.vec3({{0, 0, 0}, {2, 0, 0}, {2, 0, 0}}));
  b.json["animations"][0]["name"] = "Slide";
  b.json["animations"].push_back(b.json["animations"][0]);
  b.json["animations"][1]["name"] = "Dolly";
  b.json["animations"][1]["channels"][0]["target"]["node"] = 1;
  return b;
}

}  // namespace asos::test
