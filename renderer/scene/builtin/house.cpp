#include "renderer/scene/builtin/house_parts.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"
#include "renderer/scene/builtin/textures.h"

#include <array>

namespace asos::builtin {

namespace {

// The house stands along x with its front towards +z; the ridge runs along x, too.
constexpr float half_length = 4.2f, half_width = 3.0f, wall_height = 4.4f, ridge_height = 6.7f;

void add_walls(SceneAssembler& stage) {
  Mesh walls, base;
  // The outline is in the yz plane and extruded along x: the prism's x axis is -z here, its z axis
  // is x.
  const std::array<glm::vec2, 5> gable{{{-half_width, 0.3f},
                                        {half_width, 0.3f},
                                        {half_width, wall_height},
                                        {0.0f, ridge_height},
                                        {-half_width, wall_height}}};
  const glm::mat4 along_x = glm::mat4(turned({-half_length, 0.0, 0.0}, 90.0));
  add_prism(walls, gable, 2.0f * half_length, along_x);
  add_box(base, {-half_length - 0.08f, 0.0f, -half_width - 0.08f},
          {half_length + 0.08f, 0.3f, half_width + 0.08f});
  stage.add("walls", std::move(walls), stage.paint("clapboard", 0xe8d9b0, 0.9f));
  stage.add("base", std::move(base), stage.paint("stone", 0x8f877c, 0.95f));
}

void add_main_roof(SceneAssembler& stage) {
  Mesh tiles, trim, chimney, pots;
  const float slope = (ridge_height - wall_height) / half_width;
  for (const float side : {-1.0f, 1.0f}) {
    const glm::vec2 eave(half_width + 0.45f, wall_height - 0.45f * slope);
    add_tiled_slope(tiles, eave, {0.0f, ridge_height}, half_length + 0.35f, side, 9);
  }
  add_frustum(trim, {-half_length - 0.4f, ridge_height + 0.06f, 0.0f},
              {half_length + 0.4f, ridge_height + 0.06f, 0.0f}, 0.09f, 0.09f, 8);
  add_box(chimney, {1.9f, ridge_height - 1.2f, -0.75f}, {2.6f, ridge_height + 1.1f, -0.05f});
  add_box(chimney, {1.82f, ridge_height + 1.1f, -0.83f}, {2.68f, ridge_height + 1.22f, 0.03f});
  for (const float z : {-0.58f, -0.22f}) {
    const glm::vec3 foot(2.25f, ridge_height + 1.22f, z);
    add_frustum(pots, foot, foot + glm::vec3(0.0f, 0.42f, 0.0f), 0.13f, 0.1f, 8);
  }
  stage.add("roof", std::move(tiles), stage.paint("tiles", 0xa4503a, 0.85f));
  stage.add("ridge", std::move(trim), stage.paint("ridge", 0x7d3a2b, 0.8f));
  stage.add("chimney", std::move(chimney), stage.paint("brick", 0x9a5b46, 0.95f));
  stage.add("chimney pots", std::move(pots), stage.paint("clay", 0xc07a55, 0.9f));
}

void add_windows(SceneAssembler& stage) {
  const WindowMeshes window = keep_window(stage);
  const double z = half_width, x = half_length;
  int number = 0;
  for (const double along : {-2.9, -0.9, 1.1, 3.1}) {
    place_window(stage, window, turned({along, 3.35, z}, 0.0), ++number);
  }
  place_window(stage, window, turned({2.75, 1.55, z}, 0.0), ++number);
  for (const double along : {-1.2, 1.2}) {
    place_window(stage, window, turned({x, 1.7, along}, 90.0), ++number);
  }
  place_window(stage, window, turned({x, 4.35, 0.0}, 90.0), ++number);
}

void add_front_door(SceneAssembler& stage) {
  const glm::mat4 placement = glm::mat4(turned({-0.6, 1.32, half_width}, 0.0));
  Mesh frame, leaf, knob;
  add_frame(frame, {0.58f, 1.02f}, {0.48f, 0.94f}, 0.09f, placement);
  add_box(leaf, {0.96f, 1.88f, 0.05f}, placement * glm::mat4(turned({0.0, 0.0, 0.025}, 0.0)));
  for (const double x : {-0.22, 0.22}) {
    for (const double y : {-0.45, 0.42}) {
      add_box(leaf, {0.3f, 0.66f, 0.02f}, placement * glm::mat4(turned({x, y, 0.06}, 0.0)));
    }
  }
  add_sphere(knob, {-0.2f, 1.28f, half_width + 0.09f}, 0.035f, 2);
  stage.add("door frame", std::move(frame), stage.paint("white trim", 0xf3efe4, 0.7f));
  stage.add("door", std::move(leaf), stage.paint("door", 0x2f5d50, 0.5f));
  stage.add("door knob", std::move(knob), stage.paint("brass", 0xc9a24a, 0.4f));
}

/// Adds the house with its porch and the gazebo, without the ground.
void add_house(SceneAssembler& stage) {
  add_walls(stage);
  add_main_roof(stage);
  add_windows(stage);
  add_front_door(stage);
  add_porch(stage, -half_length, 1.6f, half_width);
  add_gazebo(stage, {7.6, 0.0, 4.4});
}

void add_plane(SceneAssembler& stage, const std::string& name, int material) {
  Mesh plane;
  add_quad(plane, {-2000, 0, 900}, {2000, 0, 900}, {2000, 0, -900}, {-2000, 0, -900});
  stage.add(name, std::move(plane), material);
}

constexpr glm::dvec3 sun_travel(-0.62, -0.68, -0.55);
constexpr std::uint32_t sun_srgb = 0xfff0d6;
constexpr float sun_lux = 3.1f;

void add_sun(SceneAssembler& stage) {
  stage.sun("sun", sun_travel, sun_srgb, sun_lux, sun_diameter_rad);
}

/// Adds the soft fill light from the sky and from behind the camera.
void add_fill(SceneAssembler& stage) {
  stage.sun("sky", {0.25, -1.0, 0.1}, 0xcfe0ff, 0.5f);
  stage.sun("fill", {-0.29, -0.05, -1.0}, 0xe6edff, 0.75f);
}

}  // namespace

// About 2,800 polygons, after the house of CGF'98 section 7.2 and GI'93: thin balusters, mullions
// and rows of tiles next to large walls, on a large plane.
Scene make_house() {
  SceneAssembler stage("house");
  add_plane(stage, "ground", stage.paint("grass", 0x93ad68, 1.0f));
  Mesh path;
  add_box(path, {-1.3f, 0.0f, 5.75f}, {0.1f, 0.04f, 16.0f});
  stage.add("path", std::move(path), stage.paint("path", 0xcabfa8, 0.95f));
  add_house(stage);
  add_sun(stage);
  add_fill(stage);
  stage.camera("garden", {7.2, 3.0, 17.5}, {2.05, 3.25, 0.0}, 35.0);
  stage.camera("gazebo", {11.5, 1.8, 11.0}, {5.6, 2.0, 2.6}, 38.0);
  return stage.take();
}

// CGF'98 figures 14 and 15: wood textures on walls, porch and gazebo, shaded softly by a spherical
// light, and a normal-mapped mesh for the sand around them.
Scene make_house_textured() {
  SceneAssembler stage("house-textured");
  constexpr float sand_metres = 4.0f;
  Mesh ground;
  add_sand(ground);
  const int sand = stage.paint("sand", 0xd9c49b, 1.0f);
  stage.add("ground", std::move(ground), sand);
  stage.material("sand").normal_texture =
      by_metres(stage.keep_texture(sand_normals(sand_metres)), sand_metres);
  add_house(stage);
  stage.cover("clapboard", stage.keep_texture(clapboards()), 2.0f);
  const int planks = stage.keep_texture(wood_planks());
  stage.cover("boards", planks, 2.0f);
  stage.cover("gazebo floor", planks, 2.0f);

  // The ball replaces the sun. It is far enough to light the garden evenly, and so large that a
  // penumbra's width is a twentieth of the distance from an occluder's edge to the shadow.
  constexpr double distance = 150.0;
  stage.ball("ball", -distance * glm::normalize(sun_travel), 0.025 * distance, sun_srgb,
             sun_lux * static_cast<float>(distance * distance));
  add_fill(stage);
  stage.camera("garden", {7.2, 3.0, 18.6}, {2.2, 2.9, 0.0}, 37.0);
  stage.camera("gazebo", {11.5, 1.8, 11.0}, {5.6, 2.0, 2.6}, 38.0);
  return stage.take();
}

// CGF'98 figures 16 to 19: the house on a mirror, without textures and shadows. The camera is so
// low that the house and its reflection each fill half of the picture.
Scene make_house_mirror() {
  SceneAssembler stage("house-mirror");
  add_plane(stage, "mirror", stage.paint("mirror", 0xffffff, 0.0f, 1.0f));
  add_house(stage);
  add_sun(stage);
  add_fill(stage);
  stage.cast_no_shadows();
  stage.camera("garden", {7.2, 1.4, 17.5}, {2.0, 0.0, 0.0}, 52.0);
  stage.camera("gazebo", {11.5, 1.8, 11.0}, {5.6, 2.0, 2.6}, 38.0);
  return stage.take();
}

}  // namespace asos::builtin
