#include "renderer/scene/builtin.h"

#include "renderer/scene/builtin/scenes.h"

#include <algorithm>

namespace asos {

const std::vector<BuiltinScene>& builtin_scenes() {
  static const std::vector<BuiltinScene> scenes{
      {"office", "a room with desk, chair, whiteboard, shelf and a ceiling light panel",
       builtin::make_office},
      {"office-metal", "the office's desk with a top of brushed metal, before a glossy whiteboard",
       builtin::make_office_metal},
      {"primitives", "sphere, cylinder, cone, truncated cone, box and disk over a plane",
       builtin::make_primitives},
      {"primitives-ball", "the same under a luminous ball", builtin::make_primitives_ball},
      {"primitives-linear", "the same under a linear light", builtin::make_primitives_linear},
      {"primitives-rectangle", "the same under a rectangular light",
       builtin::make_primitives_rectangle},
      {"solids", "sphere, cylinder and cone that mirror each other, on a dull plane",
       builtin::make_solids},
      {"house", "about 2,800 polygons: a house with a porch, and a gazebo, on a plane",
       builtin::make_house},
      {"house-textured",
       "the house of planks and clapboards on rippled sand, under a luminous ball",
       builtin::make_house_textured},
      {"house-mirror", "the house on a mirror, without shadows", builtin::make_house_mirror},
      {"fence", "hair-thin poles and wires from near to the horizon", builtin::make_fence},
      {"boxes", "a few hundred triangles: boxes and a picket fence", builtin::make_boxes},
      {"mixed", "about 50 thousand triangles: sphere, torus knot, boxes and a fence",
       builtin::make_mixed},
      {"dense", "1.2 million triangles in a few smooth closed meshes", builtin::make_dense},
      {"wheel", "a Ferris wheel: spokes, struts, cabins and railings as thin as a pixel",
       builtin::make_wheel},
      {"park", "leafless trees with thousands of twigs, benches and lamps along a way",
       builtin::make_park},
      {"neon", "a street at night under about a hundred small lights: letters, bulbs, windows",
       builtin::make_neon},
      {"workshop", "brushed and hammered metal with maps of normals: tools, sheets, pipes, bowls",
       builtin::make_workshop},
      {"railing", "wrought iron that one image cuts out of a few cards, and its shadow",
       builtin::make_railing},
      {"foliage", "a young tree of cards, of which an image cuts out twigs with leaves",
       builtin::make_foliage},
      {"glass", "a ball, a slab and a prism of glass, which bend light, on a chequered floor",
       builtin::make_glass},
      {"turning-fence", "a picket fence that turns about its middle, once in 30 seconds",
       builtin::make_turning_fence},
      {"walking-pole", "a leaning pole as thin as half a pixel, which walks by quarters of one",
       builtin::make_walking_pole},
      {"cards", "cards with common edges, thin wires, a thin shadow: the papers' argument",
       builtin::make_cards},
  };
  return scenes;
}

Result<Scene> builtin_scene(const std::string& name) {
  const std::vector<BuiltinScene>& scenes = builtin_scenes();
  const auto found = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const BuiltinScene& s) { return s.name == name; });
  if (found == scenes.end()) {
    std::string names;
    for (const BuiltinScene& s : scenes) names += (names.empty() ? "" : ", ") + s.name;
    return unexpected(Error{name, "there is no such built-in scene; there are " + names});
  }
  return found->make();
}

}  // namespace asos
