#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scene_random.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace asos::builtin {

namespace {

/// A tree without leaves, its foot at the origin: branches that bend, thin out and fork.
class Tree {
 public:
  Tree(Mesh& mesh, std::uint64_t seed) : mesh_(mesh), chance_(seed) {}

  void grow(float height, float radius) {
    add_frustum(mesh_, {0.0f, -0.1f, 0.0f}, {0.0f, 0.7f, 0.0f}, 1.35f * radius, 0.97f * radius, 12);
    branch({{0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 0.36f * height, radius}, 0);
  }

 private:
  struct Branch {
    glm::vec3 from, way;
    float length, radius;
  };

  static constexpr int deepest = 7;

  // Returns a direction at `angle` from `way`, rotated by `turn` around it.
  static glm::vec3 bent(glm::vec3 way, float angle, float turn) {
    const glm::vec3 aside =
        std::abs(way.y) > 0.9f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    const glm::vec3 u = glm::normalize(glm::cross(way, aside)), v = glm::cross(way, u);
    return std::cos(angle) * way + std::sin(angle) * (std::cos(turn) * u + std::sin(turn) * v);
  }

  // Adds a stem in a few pieces and returns its end. Each piece bends up a little, or down at the
  // thinnest branches, and starts inside the previous one.
  Branch stem(const Branch& branch, int depth) {
    const int pieces = depth < 5 ? 3 : 2;
    const int sides = std::max(4, 12 - 2 * depth);
    Branch at = branch;
    const float tip = 0.72f * branch.radius;
    for (int i = 0; i < pieces; ++i) {
      const float share = static_cast<float>(i + 1) / static_cast<float>(pieces);
      const float radius = glm::mix(branch.radius, tip, share);
      const glm::vec3 to = at.from + branch.length / static_cast<float>(pieces) * at.way;
      add_frustum(mesh_, at.from - 0.3f * at.radius * at.way, to, at.radius, radius, sides);
      at.from = to;
      at.radius = 0.995f * radius;
      const float lean = depth == 0 ? 0.05f : 0.16f;
      at.way = bent(at.way, chance_.between(0.3f, 1.0f) * lean,
                    chance_.between(0.0f, glm::two_pi<float>()));
      at.way = glm::normalize(at.way + glm::vec3(0.0f, depth < 6 ? 0.07f : -0.03f, 0.0f));
    }
    return at;
  }

  void branch(const Branch& from, int depth) {
    const Branch end = stem(from, depth);
    if (depth == deepest) return;
    const int forks = depth == 0 ? 4 : chance_.between(0.0f, 1.0f) < 0.3f ? 3 : 2;
    const float first_turn = chance_.between(0.0f, glm::two_pi<float>());
    for (int i = 0; i < forks; ++i) {
      // One branch continues the stem, thicker and straighter; the others fork off.
      const bool leader = i == 0 && depth > 0;
      const float turn = first_turn + glm::two_pi<float>() *
                                          (static_cast<float>(i) + chance_.between(-0.2f, 0.2f)) /
                                          static_cast<float>(forks);
      const float angle = leader ? chance_.between(0.1f, 0.3f) : chance_.between(0.45f, 0.85f);
      const float thin = leader ? 0.98f : chance_.between(0.55f, 0.75f);
      const float shorten = leader ? chance_.between(0.75f, 0.9f) : chance_.between(0.6f, 0.8f);
      branch({end.from - 0.2f * end.radius * end.way, bent(end.way, angle, turn),
              from.length * shorten, std::max(0.0035f, end.radius * thin)},
             depth + 1);
    }
  }

  Mesh& mesh_;
  SceneRandom chance_;
};

void add_trees(SceneAssembler& stage) {
  const int bark = stage.paint("bark", 0x665c52, 0.95f);
  std::array<int, 3> trees{};
  for (std::size_t i = 0; i < trees.size(); ++i) {
    Mesh mesh;
    Tree(mesh, 40 + i)
        .grow(8.5f + 0.8f * static_cast<float>(i), 0.23f + 0.02f * static_cast<float>(i));
    trees[i] = stage.keep("tree " + std::to_string(i + 1), std::move(mesh), bark);
  }
  struct Place {
    double x, z, turn_deg;
    std::size_t tree;
  };
  constexpr std::array<Place, 9> places{{{-4.6, -3.5, 20, 0},
                                         {4.9, -6.5, 140, 1},
                                         {-5.2, -13.0, 250, 2},
                                         {6.0, -17.0, 75, 0},
                                         {-6.0, -23.0, 300, 1},
                                         {5.4, -28.0, 190, 2},
                                         {-15.0, -20.0, 110, 0},
                                         {17.0, -26.0, 10, 1},
                                         {-22.0, -38.0, 60, 2}}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place& at = places[i];
    stage.place("standing tree " + std::to_string(i + 1), trees[at.tree],
                turned({at.x, 0.0, at.z}, at.turn_deg));
  }
}

/// Adds benches of slats on two cast frames, 1.7 m wide.
void add_benches(SceneAssembler& stage) {
  Mesh slats, frames;
  for (int i = 0; i < 5; ++i) {
    const float z = -0.2f + 0.1f * static_cast<float>(i);
    add_box(slats, {-0.85f, 0.43f, z - 0.04f}, {0.85f, 0.46f, z + 0.04f});
  }
  for (int i = 0; i < 4; ++i) {
    const float y = 0.56f + 0.11f * static_cast<float>(i), z = -0.28f - 0.28f * (y - 0.5f);
    add_beam(slats, {-0.85f, y, z}, {0.85f, y, z}, 0.03f, 0.08f, {0.0f, 1.0f, -0.28f});
  }
  for (const float x : {-0.65f, 0.65f}) {
    const std::array<glm::vec3, 7> rear{{{x, 0.0f, -0.42f},
                                         {x, 0.15f, -0.34f},
                                         {x, 0.3f, -0.28f},
                                         {x, 0.45f, -0.29f},
                                         {x, 0.6f, -0.335f},
                                         {x, 0.75f, -0.38f},
                                         {x, 0.95f, -0.44f}}};
    add_tube(frames, rear, 0.02f, 8);
    const std::array<glm::vec3, 7> fore{{{x, 0.0f, 0.3f},
                                         {x, 0.2f, 0.24f},
                                         {x, 0.4f, 0.26f},
                                         {x, 0.56f, 0.27f},
                                         {x, 0.64f, 0.2f},
                                         {x, 0.66f, 0.05f},
                                         {x, 0.65f, -0.34f}}};
    add_tube(frames, fore, 0.018f, 8);
    add_beam(frames, {x, 0.41f, -0.3f}, {x, 0.41f, 0.26f}, 0.03f, 0.03f);
  }
  const int wood =
      stage.keep("slats", std::move(slats), stage.paint("painted wood", 0x6f8a5a, 0.6f));
  const int iron =
      stage.keep("bench frame", std::move(frames), stage.paint("iron", 0x33363a, 0.5f));
  int number = 0;
  for (const auto& [x, z, turn] :
       {std::array{2.35, -1.6, -82.0}, {-2.5, -7.6, 88.0}, {2.5, -12.0, -90.0}}) {
    const std::string name = std::to_string(++number);
    stage.place("bench " + name, wood, turned({x, 0.0, z}, turn));
    stage.place("bench frame " + name, iron, turned({x, 0.0, z}, turn));
  }
}

/// Adds lamps along the path. They are lit, since it is late afternoon.
void add_globe_lamps(SceneAssembler& stage) {
  Mesh post, globe;
  const std::array<glm::vec2, 12> outline{{{0.0f, 0.0f},
                                           {0.17f, 0.0f},
                                           {0.17f, 0.12f},
                                           {0.1f, 0.22f},
                                           {0.075f, 0.55f},
                                           {0.09f, 0.6f},
                                           {0.045f, 0.7f},
                                           {0.035f, 3.1f},
                                           {0.07f, 3.16f},
                                           {0.07f, 3.2f},
                                           {0.12f, 3.26f},
                                           {0.0f, 3.26f}}};
  add_lathe(post, glm::vec3(0.0f), {0.0f, 1.0f, 0.0f}, outline, 20);
  add_frustum(post, {0.0f, 3.62f, 0.0f}, {0.0f, 3.78f, 0.0f}, 0.24f, 0.02f, 20);
  for (int i = 0; i < 4; ++i) {
    const float angle = glm::two_pi<float>() * (static_cast<float>(i) + 0.5f) / 4.0f;
    const glm::vec3 out(std::cos(angle), 0.0f, std::sin(angle));
    add_frustum(post, 0.1f * out + glm::vec3(0.0f, 3.24f, 0.0f),
                0.2f * out + glm::vec3(0.0f, 3.65f, 0.0f), 0.008f, 0.008f, 6);
  }
  constexpr float radius = 0.11f;
  add_sphere(globe, glm::vec3(0.0f), radius, 8);
  const int iron =
      stage.keep("lamp post", std::move(post), stage.paint("black iron", 0x2a2d31, 0.5f));
  const int glass =
      stage.keep("globe", std::move(globe), stage.glow("lamp light", 0xffd9a0, 130.0f));
  int number = 0;
  for (const glm::dvec2 at :
       {glm::dvec2(-2.3, -1.2), glm::dvec2(2.4, -9.5), glm::dvec2(-2.4, -19.0)}) {
    const std::string name = "lamp " + std::to_string(++number);
    const glm::dvec3 middle(at.x, 3.42, at.y);
    stage.place(name + " post", iron, turned({at.x, 0.0, at.y}, 0.0));
    stage.place(name + " globe", glass, turned(middle, 0.0));
  }
}

/// A gravel way with stones along its edges, and a low railing at the far end of the lawn.
void add_way(SceneAssembler& stage) {
  Mesh gravel, kerb, railing;
  add_box(gravel, {-1.7f, -0.2f, -300.0f}, {1.7f, 0.02f, 12.0f});
  for (int i = 0; i < 60; ++i) {
    const float z = 6.0f - static_cast<float>(i);
    for (const float x : {-1.76f, 1.76f})
      add_box(kerb, {x - 0.055f, -0.1f, z - 0.485f}, {x + 0.055f, 0.07f, z + 0.485f});
  }
  for (const float side : {-1.0f, 1.0f}) {
    for (int i = 0; i < 70; ++i) {
      const float x = side * (2.6f + 0.45f * static_cast<float>(i));
      add_frustum(railing, {x, -0.05f, -44.0f}, {x, 1.25f, -44.0f}, 0.018f, 0.018f, 6);
    }
    for (const float y : {0.25f, 1.1f})
      add_beam(railing, {side * 2.4f, y, -44.0f}, {side * 34.0f, y, -44.0f}, 0.03f, 0.04f);
  }
  stage.add("gravel", std::move(gravel), stage.paint("gravel", 0xcdc4b4, 1.0f));
  stage.add("kerb", std::move(kerb), stage.paint("stone", 0x9c968b, 0.95f));
  stage.add("railing", std::move(railing), stage.paint("green iron", 0x39473c, 0.6f));
}

}  // namespace

// Boughs, twigs and their shadows on the lawn, most of them thinner than a pixel.
Scene make_park() {
  SceneAssembler stage("park");
  Mesh ground;
  add_quad(ground, {-900, 0, 300}, {900, 0, 300}, {900, 0, -900}, {-900, 0, -900});
  stage.add("lawn", std::move(ground), stage.paint("winter grass", 0x93a463, 1.0f));
  add_way(stage);
  add_trees(stage);
  add_benches(stage);
  add_globe_lamps(stage);
  stage.sun("low sun", {-0.82, -0.42, -0.38}, 0xffe0b8, 3.6f, sun_diameter_rad);
  stage.sun("sky", {0.2, -1.0, 0.15}, 0xc4d6ff, 0.7f);
  stage.sun("fill", {0.2, -0.05, -1.0}, 0xdde6ff, 0.5f);
  stage.camera("along the way", {0.75, 1.65, 5.4}, {-0.25, 2.75, -8.0}, 48.0);
  stage.camera("bench", {-0.6, 1.5, 2.2}, {2.6, 0.9, -2.6}, 44.0);
  return stage.take();
}

}  // namespace asos::builtin
