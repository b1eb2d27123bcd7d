#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace asos::builtin {

namespace {

// The wheel turns about an axis along z; everything is symmetric about the plane z = 0.
constexpr glm::vec3 hub(0.0f, 9.4f, 0.0f);
constexpr float rim_radius = 7.6f, inner_radius = 6.9f, ring_radius = 3.2f;
constexpr float half_gap = 0.85f;  // from the centre to either rim
constexpr int cabins = 12, fields = 48;

glm::vec3 on_wheel(float turn, float radius, float z) {
  const float angle = glm::two_pi<float>() * turn;
  return hub + glm::vec3(radius * std::sin(angle), radius * std::cos(angle), z);
}

/// A thin rod.
void add_rod(Mesh& mesh, glm::vec3 from, glm::vec3 to, float radius) {
  add_frustum(mesh, from, to, radius, radius, 6);
}

/// A tube bent to a circle about an axis along z.
void add_hoop(Mesh& mesh, glm::vec3 centre, float radius, float tube_radius, int sides) {
  constexpr int around = 12;
  std::vector<glm::vec2> outline;
  for (int i = 0; i < around; ++i) {
    const float angle = glm::two_pi<float>() * static_cast<float>(i) / around;
    outline.push_back({radius + tube_radius * std::cos(angle), tube_radius * std::sin(angle)});
  }
  outline.push_back(outline.front());
  add_lathe(mesh, centre, {0.0f, 0.0f, 1.0f}, outline, sides);
}

/// Adds two rims, each of three hoops with a lattice between the outer two, and the spacers between
/// the rims.
void add_rims(SceneAssembler& stage) {
  Mesh hoops, lattice;
  for (const float z : {-half_gap, half_gap}) {
    add_hoop(hoops, hub + glm::vec3(0.0f, 0.0f, z), rim_radius, 0.055f, fields);
    add_hoop(hoops, hub + glm::vec3(0.0f, 0.0f, z), inner_radius, 0.045f, fields);
    add_hoop(hoops, hub + glm::vec3(0.0f, 0.0f, z), ring_radius, 0.03f, fields);
    for (int i = 0; i < fields; ++i) {
      const float a = static_cast<float>(i) / fields, b = (static_cast<float>(i) + 0.5f) / fields,
                  c = static_cast<float>(i + 1) / fields;
      add_rod(lattice, on_wheel(a, inner_radius, z), on_wheel(b, rim_radius, z), 0.014f);
      add_rod(lattice, on_wheel(b, rim_radius, z), on_wheel(c, inner_radius, z), 0.014f);
    }
  }
  for (int i = 0; i < 2 * cabins; ++i) {
    const float a = static_cast<float>(i) / (2 * cabins), next = a + 0.5f / cabins;
    add_rod(lattice, on_wheel(a, inner_radius, -half_gap), on_wheel(a, inner_radius, half_gap),
            0.02f);
    add_rod(lattice, on_wheel(a, inner_radius, -half_gap), on_wheel(next, inner_radius, half_gap),
            0.012f);
  }
  stage.add("rims", std::move(hoops), stage.paint("white steel", 0xf2efe8, 0.5f));
  stage.add("lattice", std::move(lattice), stage.paint("red steel", 0xc8433a, 0.5f));
}

/// Pairs of spokes from the ends of the hub to the rims, and crosses of wire within each pair.
void add_spokes(SceneAssembler& stage) {
  Mesh spokes, wires, axle;
  for (int i = 0; i < 2 * cabins; ++i) {
    const float turn = static_cast<float>(i) / (2 * cabins);
    for (const float side : {-1.0f, 1.0f}) {
      add_rod(spokes, on_wheel(turn, 0.5f, 1.25f * side),
              on_wheel(turn, inner_radius, half_gap * side), 0.022f);
    }
    add_rod(wires, on_wheel(turn, ring_radius, -half_gap), on_wheel(turn, inner_radius, half_gap),
            0.007f);
    add_rod(wires, on_wheel(turn, ring_radius, half_gap), on_wheel(turn, inner_radius, -half_gap),
            0.007f);
  }
  const glm::vec3 along(0.0f, 0.0f, 1.0f);
  add_frustum(axle, hub - 1.9f * along, hub + 1.9f * along, 0.2f, 0.2f, 24);
  for (const float side : {-1.0f, 1.0f})
    add_frustum(axle, hub + 1.17f * side * along, hub + 1.33f * side * along, 0.62f, 0.55f, 32);
  stage.add("spokes", std::move(spokes), stage.paint("pale steel", 0xdfe4e6, 0.5f));
  stage.add("wires", std::move(wires), stage.paint("cable", 0x565b60, 0.5f));
  stage.add("axle", std::move(axle), stage.paint("hub", 0x3f5f8a, 0.5f));
}

/// Two legs on each side that meet at the axle, with struts between them.
void add_legs(SceneAssembler& stage) {
  Mesh legs;
  for (const float side : {-1.0f, 1.0f}) {
    const float z = 1.7f * side, foot_z = 2.6f * side;
    const auto at = [&](float share, float x) {
      return glm::mix(glm::vec3(x, 0.0f, foot_z), hub + glm::vec3(0.04f * x, 0.0f, z - hub.z),
                      share);
    };
    for (const float x : {-4.2f, 4.2f}) {
      add_frustum(legs, at(0.0f, x), at(1.0f, x), 0.16f, 0.12f, 16);
      add_box(legs, {x - 0.4f, -0.02f, foot_z - 0.4f}, {x + 0.4f, 0.22f, foot_z + 0.4f});
    }
    for (const float share : {0.22f, 0.45f, 0.66f}) {
      add_rod(legs, at(share, -4.2f), at(share, 4.2f), 0.05f);
      add_rod(legs, at(share, -4.2f), at(share + 0.2f, 4.2f), 0.025f);
      add_rod(legs, at(share, 4.2f), at(share + 0.2f, -4.2f), 0.025f);
    }
  }
  stage.add("legs", std::move(legs), stage.paint("blue steel", 0x3f6ea5, 0.5f));
}

struct CabinMeshes {
  int frame = -1, roof = -1;
  std::array<int, 3> body{};
};

/// A cabin whose pin is at the origin: floor, low walls, posts, a railing and a pointed roof.
CabinMeshes keep_cabin(SceneAssembler& stage) {
  constexpr float half = 0.62f, floor = -1.95f, wall = -1.35f, eaves = -0.42f;
  Mesh frame, roof, body;
  add_box(body, {-half, floor, -half}, {half, floor + 0.08f, half});
  for (const float side : {-1.0f, 1.0f}) {
    add_box(body, glm::vec3(1.16f, wall - floor - 0.08f, 0.03f),
            glm::mat4(turned({0.0, 0.5 * (wall + floor + 0.08f), side * 0.6}, 0.0)));
    add_box(body, glm::vec3(1.16f, wall - floor - 0.08f, 0.03f),
            glm::mat4(turned({side * 0.6, 0.5 * (wall + floor + 0.08f), 0.0}, 90.0)));
    add_rod(frame, {0.62f * side, wall + 0.3f, -0.6f}, {0.62f * side, wall + 0.3f, 0.6f}, 0.014f);
    add_rod(frame, {-0.6f, wall + 0.3f, 0.62f * side}, {0.6f, wall + 0.3f, 0.62f * side}, 0.014f);
    for (const float x : {-0.6f, -0.2f, 0.2f, 0.6f}) {
      const bool corner = std::abs(x) > 0.5f;
      const float top = corner ? eaves + 0.03f : wall + 0.31f;
      add_rod(frame, {x, floor + 0.04f, 0.605f * side}, {x, top, 0.605f * side},
              corner ? 0.022f : 0.01f);
      if (!corner)
        add_rod(frame, {0.605f * side, floor + 0.04f, x}, {0.605f * side, top, x}, 0.01f);
    }
  }
  add_frustum(roof, {0.0f, eaves, 0.0f}, {0.0f, eaves + 0.34f, 0.0f}, 0.95f, 0.06f, 12);
  add_frustum(roof, {0.0f, eaves - 0.05f, 0.0f}, {0.0f, eaves, 0.0f}, 0.9f, 0.97f, 12);
  add_frustum(frame, {0.0f, eaves + 0.3f, 0.0f}, {0.0f, 0.05f, 0.0f}, 0.04f, 0.04f, 10);
  add_frustum(frame, {0.0f, 0.0f, -0.95f}, {0.0f, 0.0f, 0.95f}, 0.05f, 0.05f, 10);
  CabinMeshes meshes;
  meshes.frame = stage.keep("cabin frame", std::move(frame), stage.paint("brass", 0xd6b15c, 0.45f));
  meshes.roof = stage.keep("cabin roof", std::move(roof), stage.paint("cream", 0xf6ead0, 0.6f));
  constexpr std::array<std::uint32_t, 3> colours{0xd8574a, 0xe5a93c, 0x3f8f8a};
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const std::string name = "cabin " + std::to_string(i + 1);
    meshes.body[i] = stage.keep(name, body, stage.paint(name, colours[i], 0.5f));
  }
  return meshes;
}

// Cabins hang upright at every position of the wheel, which is rotated by a small angle.
void add_cabins(SceneAssembler& stage) {
  const CabinMeshes cabin = keep_cabin(stage);
  for (int i = 0; i < cabins; ++i) {
    const std::string number = std::to_string(i + 1);
    const glm::dvec3 pin(on_wheel((static_cast<float>(i) + 0.27f) / cabins, rim_radius, 0.0f));
    const glm::dmat4 placement = turned(pin, 0.0);
    stage.place("cabin frame " + number, cabin.frame, placement);
    stage.place("cabin roof " + number, cabin.roof, placement);
    stage.place("cabin body " + number, cabin.body[static_cast<std::size_t>(i) % 3], placement);
  }
}

void add_rod_railing(Mesh& mesh, glm::vec3 from, glm::vec3 to, int rods) {
  const glm::vec3 up(0.0f, 1.0f, 0.0f);
  for (const float y : {0.15f, 1.0f}) add_beam(mesh, from + y * up, to + y * up, 0.035f, 0.03f);
  for (int i = 0; i < rods; ++i) {
    const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(rods);
    const glm::vec3 foot = glm::mix(from, to, share);
    add_rod(mesh, foot + 0.02f * up, foot + 0.99f * up, 0.009f);
  }
  for (const glm::vec3 end : {from, to})
    add_frustum(mesh, end, end + 1.12f * up, 0.035f, 0.035f, 10);
}

/// Adds the boarding platform, with steps, railings and a booth.
void add_platform(SceneAssembler& stage) {
  Mesh deck, rails, booth, roof, counter;
  add_box(deck, {-3.0f, 0.0f, -2.0f}, {3.0f, 0.34f, 2.0f});
  add_box(deck, {-1.2f, 0.0f, 2.0f}, {1.2f, 0.17f, 2.4f});
  add_rod_railing(rails, {-2.9f, 0.34f, 1.9f}, {-1.3f, 0.34f, 1.9f}, 13);
  add_rod_railing(rails, {1.3f, 0.34f, 1.9f}, {2.9f, 0.34f, 1.9f}, 13);
  add_rod_railing(rails, {-2.9f, 0.34f, -1.9f}, {2.9f, 0.34f, -1.9f}, 46);
  for (const float x : {-1.25f, 1.25f})
    add_rod_railing(rails, {x, 0.0f, 2.5f}, {x, 0.0f, 6.5f}, 32);
  for (const float side : {-1.0f, 1.0f})
    add_rod_railing(rails, {11.0f * side, 0.0f, -5.0f}, {5.4f * side, 0.0f, -5.0f}, 44);
  add_box(booth, {4.6f, 0.0f, 3.6f}, {6.2f, 1.05f, 5.0f});
  for (const float x : {4.66f, 6.14f}) {
    for (const float z : {3.66f, 4.94f})
      add_box(booth, {x - 0.05f, 1.05f, z - 0.05f}, {x + 0.05f, 2.25f, z + 0.05f});
  }
  add_box(counter, {4.5f, 1.05f, 3.5f}, {6.3f, 1.1f, 5.1f});
  add_frustum(roof, {5.4f, 2.25f, 4.3f}, {5.4f, 3.1f, 4.3f}, 1.45f, 0.03f, 16);
  stage.add("platform", std::move(deck), stage.paint("boards", 0xb98f63, 0.85f));
  stage.add("railings", std::move(rails), stage.paint("iron", 0x2f3338, 0.5f));
  stage.add("booth", std::move(booth), stage.paint("booth", 0xe9e2d2, 0.7f));
  stage.add("counter", std::move(counter), stage.paint("wood", 0x8e6540, 0.7f));
  stage.add("booth roof", std::move(roof), stage.paint("awning", 0xc94f4a, 0.8f));
}

/// Adds light strings from the top of the legs to masts.
void add_masts(SceneAssembler& stage) {
  Mesh masts, wires;
  for (const glm::vec3 foot : {glm::vec3(-9.5f, 0.0f, 3.0f), glm::vec3(9.8f, 0.0f, 1.5f)}) {
    const glm::vec3 top = foot + glm::vec3(0.0f, 6.5f, 0.0f);
    add_frustum(masts, foot, top, 0.07f, 0.04f, 12);
    const glm::vec3 from = top - glm::vec3(0.0f, 0.15f, 0.0f), to = hub + glm::vec3(0, 0, 1.85f);
    std::vector<glm::vec3> path;
    constexpr int pieces = 24;
    for (int i = 0; i <= pieces; ++i) {
      const float t = static_cast<float>(i) / pieces;
      path.push_back(glm::mix(from, to, t) - glm::vec3(0.0f, 5.6f * t * (1.0f - t), 0.0f));
    }
    add_tube(wires, path, 0.008f, 6);
    for (int i = 1; i < pieces; ++i)
      add_sphere(masts, path[static_cast<std::size_t>(i)] - glm::vec3(0.0f, 0.05f, 0.0f), 0.05f, 2);
  }
  stage.add("masts", std::move(masts), stage.paint("bulbs", 0xf3ead2, 0.4f));
  stage.add("bulb wires", std::move(wires), stage.paint("black cable", 0x24262a, 0.6f));
}

}  // namespace

// Hundreds of rods one pixel thick, which cross each other and their own shadows.
Scene make_wheel() {
  SceneAssembler stage("wheel");
  Mesh ground, paving;
  add_quad(ground, {-900, 0, 500}, {900, 0, 500}, {900, 0, -900}, {-900, 0, -900});
  add_frustum(paving, {0.0f, -0.2f, 1.0f}, {0.0f, 0.04f, 1.0f}, 12.5f, 12.5f, 72);
  stage.add("ground", std::move(ground), stage.paint("grass", 0x97ab6b, 1.0f));
  stage.add("paving", std::move(paving), stage.paint("paving", 0xcfc5b2, 0.95f));
  add_rims(stage);
  add_spokes(stage);
  add_legs(stage);
  add_cabins(stage);
  add_platform(stage);
  add_masts(stage);
  stage.sun("sun", {-0.5, -0.78, -0.52}, 0xfff0d6, 2.9f, sun_diameter_rad);
  stage.sun("sky", {0.25, -1.0, 0.1}, 0xcfe0ff, 0.55f);
  stage.sun("fill", {-0.35, -0.03, -1.0}, 0xe6edff, 0.7f);
  stage.camera("fairground", {9.0, 5.2, 20.4}, {0.1, 7.9, -0.3}, 49.0);
  stage.camera("below", {3.2, 1.7, 7.0}, {-0.4, 9.0, 0.0}, 62.0);
  return stage.take();
}

}  // namespace asos::builtin
