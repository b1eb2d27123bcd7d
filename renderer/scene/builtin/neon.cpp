#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace asos::builtin {

namespace {

// The house front is in the plane z = 0 and faces +z, over the pavement.
constexpr float front_half = 7.5f, front_height = 9.6f;

/// A stroke of a letter, in a box 1 wide and 1.6 high, from the box's lower left corner.
struct Stroke {
  glm::vec2 from, to;
};
std::vector<Stroke> strokes_of(char letter) {
  const glm::vec2 a(0.0f, 0.0f), b(1.0f, 0.0f), c(1.0f, 0.8f), d(1.0f, 1.6f), e(0.0f, 1.6f),
      f(0.0f, 0.8f), low(0.5f, 0.0f), middle(0.5f, 0.8f), high(0.5f, 1.6f);
  switch (letter) {
    case 'A':
      return {{a, e}, {e, d}, {d, b}, {f, c}};
    case 'B':
      return {{a, e}, {e, {0.85f, 1.6f}}, {{0.85f, 1.6f}, {0.85f, 0.8f}}, {f, c}, {c, b}, {b, a}};
    case 'C':
      return {{b, a}, {a, e}, {e, d}};
    case 'E':
      return {{a, e}, {e, d}, {f, {0.8f, 0.8f}}, {a, b}};
    case 'F':
      return {{a, e}, {e, d}, {f, {0.8f, 0.8f}}};
    case 'H':
      return {{a, e}, {b, d}, {f, c}};
    case 'J':
      return {{f, a}, {a, b}, {b, d}};
    case 'L':
      return {{e, a}, {a, b}};
    case 'N':
      return {{a, e}, {e, b}, {b, d}};
    case 'O':
      return {{a, e}, {e, d}, {d, b}, {b, a}};
    case 'P':
      return {{a, e}, {e, d}, {d, c}, {c, f}};
    case 'R':
      return {{a, e}, {e, d}, {d, c}, {c, f}, {middle, b}};
    case 'T':
      return {{e, d}, {high, low}};
    case 'Z':
      return {{e, d}, {d, a}, {a, b}};
    default:
      return {};
  }
}

/// A word in glass tubes: the position of its first letter, and the directions along the line and
/// up, each as long as a letter's unit.
struct Word {
  std::string_view letters;
  glm::vec3 from;
  glm::vec3 along, up;
  float advance = 1.45f;  ///< from letter to letter, in lengths of `along`
  bool downwards = false;
};

// Strokes end before they meet, so that each tube is a separate solid.
void add_word(Mesh& tubes, Mesh& holders, const Word& word) {
  constexpr float gap = 0.09f;
  const float unit = glm::length(word.along), radius = 0.055f * unit;
  const glm::vec3 out = glm::normalize(glm::cross(word.along, word.up));
  glm::vec3 corner = word.from;
  for (const char letter : word.letters) {
    for (const auto& [from, to] : strokes_of(letter)) {
      const glm::vec2 short_of = gap * glm::normalize(to - from);
      const auto place = [&](glm::vec2 at) { return corner + at.x * word.along + at.y * word.up; };
      const glm::vec3 a = place(from + short_of), b = place(to - short_of);
      add_frustum(tubes, a, b, radius, radius, 10);
      const glm::vec3 middle = 0.5f * (a + b);
      add_frustum(holders, middle - 0.16f * out, middle - 1.05f * radius * out, 0.008f, 0.008f, 6);
    }
    corner += word.downwards ? -2.1f * word.up : word.advance * word.along;
  }
}

void add_sign(SceneAssembler& stage, const std::string& name, const Word& word, std::uint32_t srgb,
              float nits) {
  Mesh tubes, holders;
  add_word(tubes, holders, word);
  stage.add(name + " tubes", std::move(tubes), stage.glow(name + " light", srgb, nits));
  stage.add(name + " holders", std::move(holders), stage.paint(name + " holder", 0x55585c, 0.6f));
}

void add_signs(SceneAssembler& stage) {
  const auto flat = [](float unit) { return glm::vec3(unit, 0.0f, 0.0f); };
  const auto high = [](float unit) { return glm::vec3(0.0f, unit, 0.0f); };
  add_sign(stage, "bar", {"BAR", {-4.9f, 3.3f, 0.2f}, flat(0.5f), high(0.5f)}, 0xff3050, 16.0f);
  add_sign(stage, "jazz", {"JAZZ", {1.2f, 3.38f, 0.2f}, flat(0.4f), high(0.42f)}, 0x3080ff, 20.0f);
  add_sign(stage, "open", {"OPEN", {4.62f, 2.2f, 0.12f}, flat(0.17f), high(0.17f)}, 0x40ff90,
           18.0f);
  Mesh board;
  add_box(board, {-0.45f, 4.62f, 0.12f}, {0.45f, 9.0f, 0.26f});
  for (const float y : {5.0f, 8.6f}) add_box(board, {-0.03f, y, 0.0f}, {0.03f, y + 0.06f, 0.12f});
  stage.add("board", std::move(board), stage.paint("board", 0x34343c, 0.6f));
  add_sign(stage, "hotel", {"HOTEL", {-0.25f, 8.08f, 0.36f}, flat(0.5f), high(0.4f), 0.0f, true},
           0xff8a20, 16.0f);
}

/// Adds bulbs in sockets along the awning's edge and around the door.
void add_bulbs(SceneAssembler& stage) {
  Mesh bulbs, sockets;
  const auto add = [&](glm::vec3 at, glm::vec3 out) {
    add_sphere(bulbs, at, 0.035f, 3);
    add_frustum(sockets, at - 0.09f * out, at - 0.03f * out, 0.022f, 0.022f, 8);
  };
  for (int i = 0; i < 7; ++i) {
    const float x = -1.2f + 0.4f * static_cast<float>(i);
    add({x, 2.93f, 1.33f}, {0.0f, 0.0f, 1.0f});
  }
  for (int i = 0; i < 6; ++i) {
    const float y = 0.55f + 0.4f * static_cast<float>(i);
    for (const float x : {-0.98f, 0.98f}) add({x, y, 0.16f}, {0.0f, 0.0f, 1.0f});
  }
  stage.add("bulbs", std::move(bulbs), stage.glow("bulb light", 0xffc060, 22.0f));
  stage.add("sockets", std::move(sockets), stage.paint("socket", 0x8a7a50, 0.5f));
}

/// The meshes of all windows of the upper floors: frames, sills, and dark or lit panes.
struct WindowParts {
  Mesh frames, sills, dark;
  std::array<Mesh, 3> lit;
};

void add_flat_window(WindowParts& parts, glm::vec2 at, int light) {
  constexpr glm::vec2 half(0.48f, 0.78f);
  const glm::mat4 place = glm::mat4(turned({at.x, at.y, -0.02}, 0.0));
  add_frame(parts.frames, half + 0.07f, half, 0.1f, place);
  add_box(parts.frames, {at.x - 0.02f, at.y - half.y - 0.01f, 0.0f},
          {at.x + 0.02f, at.y + half.y + 0.01f, 0.06f});
  add_box(parts.frames, {at.x - half.x - 0.01f, at.y + 0.2f, 0.005f},
          {at.x + half.x + 0.01f, at.y + 0.24f, 0.055f});
  add_box(parts.sills, {at.x - half.x - 0.15f, at.y - half.y - 0.16f, 0.0f},
          {at.x + half.x + 0.15f, at.y - half.y - 0.075f, 0.2f});
  Mesh& pane = light < 0 ? parts.dark : parts.lit[static_cast<std::size_t>(light)];
  const glm::vec2 lo = at - half, hi = at + half;
  constexpr float z = 0.012f;
  add_quad(pane, {lo.x, lo.y, z}, {hi.x, lo.y, z}, {hi.x, hi.y, z}, {lo.x, hi.y, z});
}

void add_windows_of_front(SceneAssembler& stage) {
  WindowParts parts;
  // The light in each window: -1 none, 0 warm, 1 cold, 2 a television.
  constexpr std::array<std::array<int, 6>, 2> lights{{{0, -1, 0, -1, 1, 0}, {-1, 1, -1, 2, -1, 0}}};
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 6; ++column) {
      const float x = -6.0f + 2.4f * static_cast<float>(column);
      const auto at = glm::vec2(x, 5.55f + 2.5f * static_cast<float>(row));
      add_flat_window(parts, at,
                      lights[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]);
    }
  }
  stage.add("window frames", std::move(parts.frames), stage.paint("frame", 0xd9d2c2, 0.7f));
  stage.add("window sills", std::move(parts.sills), stage.paint("sill", 0x9a938a, 0.9f));
  stage.add("dark panes", std::move(parts.dark), stage.paint("dark pane", 0x10141c, 0.4f));
  constexpr std::array<std::uint32_t, 3> colours{0xffc880, 0xd8e4ff, 0x6f9cff};
  for (std::size_t i = 0; i < parts.lit.size(); ++i) {
    const std::string name = "lit panes " + std::to_string(i + 1);
    stage.add(name, std::move(parts.lit[i]), stage.glow(name, colours[i], 0.9f));
  }
}

/// Wall, plinth, cornices, door and awning.
void add_front(SceneAssembler& stage) {
  Mesh wall, trim, door, awning, roof;
  add_box(wall, {-front_half, 0.0f, -0.5f}, {front_half, front_height, 0.0f});
  add_box(trim, {-front_half - 0.05f, 0.0f, -0.4f}, {front_half + 0.05f, 0.5f, 0.07f});
  for (const auto& [y, height, depth] : {std::array{4.25f, 0.1f, 0.14f},
                                         {4.36f, 0.06f, 0.2f},
                                         {9.2f, 0.14f, 0.2f},
                                         {9.38f, 0.1f, 0.34f}})
    add_box(trim, {-front_half - 0.1f, y, -0.45f}, {front_half + 0.1f, y + height, depth});
  add_box(door, {-0.78f, 0.0f, 0.005f}, {-0.01f, 2.6f, 0.06f});
  add_box(door, {0.01f, 0.0f, 0.005f}, {0.78f, 2.6f, 0.06f});
  add_frame(trim, {0.9f, 1.42f}, {0.79f, 1.31f}, 0.12f, glm::mat4(turned({0.0, 1.31, 0.0}, 0.0)));
  for (const float x : {-0.09f, 0.09f})
    add_frustum(trim, {x, 0.95f, 0.11f}, {x, 1.5f, 0.11f}, 0.015f, 0.015f, 8);
  const std::array<glm::vec2, 4> profile{
      {{0.0f, 2.95f}, {-1.35f, 2.85f}, {-1.35f, 3.0f}, {0.0f, 3.2f}}};
  const std::array<glm::vec2, 4> turned_profile{{profile[1], profile[0], profile[3], profile[2]}};
  add_prism(awning, turned_profile, 2.9f, glm::mat4(turned({-1.45, 0.0, 0.0}, 90.0)));
  stage.add("wall", std::move(wall), stage.paint("plaster", 0x9c7566, 0.95f));
  stage.add("trim", std::move(trim), stage.paint("trim", 0x8f8a84, 0.85f));
  stage.add("door", std::move(door), stage.paint("door", 0x2e4a44, 0.5f));
  stage.add("awning", std::move(awning), stage.paint("awning", 0x6e1f2c, 0.8f));
}

/// Adds the shop windows on both sides of the door: frames, glowing panes, and a row of bottles.
void add_shop(SceneAssembler& stage) {
  Mesh frames, panes, bottles;
  for (const float x : {-4.0f, 4.0f}) {
    add_frame(frames, {1.75f, 1.02f}, {1.62f, 0.9f}, 0.14f, glm::mat4(turned({x, 1.72, 0.0}, 0.0)));
    for (const float at : {-0.54f, 0.54f})
      add_box(frames, {x + at - 0.025f, 0.81f, 0.02f}, {x + at + 0.025f, 2.63f, 0.1f});
    for (const float at : {-1.08f, 0.0f, 1.08f})
      add_quad(panes, {x + at - 0.5f, 0.84f, 0.015f}, {x + at + 0.5f, 0.84f, 0.015f},
               {x + at + 0.5f, 2.6f, 0.015f}, {x + at - 0.5f, 2.6f, 0.015f});
    add_box(frames, {x - 1.6f, 1.3f, 0.02f}, {x + 1.6f, 1.33f, 0.12f});
    for (int i = 0; i < 14; ++i) {
      const float height = 0.22f + 0.05f * static_cast<float>(i % 3);
      const glm::vec3 foot(x - 1.45f + 0.22f * static_cast<float>(i), 1.335f, 0.07f);
      const std::array<glm::vec2, 6> outline{{{0.0f, 0.0f},
                                              {0.036f, 0.0f},
                                              {0.036f, 0.65f * height},
                                              {0.013f, 0.8f * height},
                                              {0.013f, height},
                                              {0.0f, height}}};
      add_lathe(bottles, foot, {0.0f, 1.0f, 0.0f}, outline, 12);
    }
  }
  stage.add("shop frames", std::move(frames), stage.paint("shop frame", 0x3a2c26, 0.6f));
  stage.add("shop panes", std::move(panes), stage.glow("shop light", 0xffb070, 0.55f));
  stage.add("bottles", std::move(bottles), stage.paint("bottle", 0x1e3a2a, 0.4f));
}

/// Adds the houses on both sides, and the sky above.
void add_backdrop(SceneAssembler& stage) {
  Mesh left, right, sky;
  add_box(left, {-26.0f, 0.0f, -0.9f}, {-front_half - 0.2f, 8.2f, -0.25f});
  add_box(left, {-25.8f, 8.15f, -0.85f}, {-front_half - 0.15f, 8.5f, -0.1f});
  add_box(right, {front_half + 0.2f, 0.0f, -0.9f}, {26.0f, 11.5f, -0.35f});
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < 5; ++i) {
      const float x = front_half + 1.7f + 2.6f * static_cast<float>(i);
      const float y = 1.6f + 3.0f * static_cast<float>(row);
      add_frame(right, {0.62f, 0.9f}, {0.5f, 0.78f}, 0.1f, glm::mat4(turned({x, y, -0.35}, 0.0)));
      add_frame(left, {0.62f, 0.75f}, {0.5f, 0.63f}, 0.1f,
                glm::mat4(turned({-x, 0.85 * static_cast<double>(y), -0.25}, 0.0)));
    }
  }
  add_quad(sky, {-400, -30, -60}, {400, -30, -60}, {400, 300, -60}, {-400, 300, -60});
  stage.add("left house", std::move(left), stage.paint("grey plaster", 0x6f7480, 0.95f));
  stage.add("right house", std::move(right), stage.paint("ochre plaster", 0x8a7c62, 0.95f));
  stage.add("night sky", std::move(sky), stage.glow("night", 0x182038, 1.0f));
  stage.show_light();
}

/// Pavement, kerb, road with a line, bollards with chains, and crates by the wall.
void add_street(SceneAssembler& stage) {
  Mesh pavement, road, line, posts, crates;
  add_box(pavement, {-40.0f, -0.3f, -0.6f}, {40.0f, 0.0f, 3.2f});
  add_quad(road, {-60, -0.12f, 40}, {60, -0.12f, 40}, {60, -0.12f, -30}, {-60, -0.12f, -30});
  for (int i = 0; i < 12; ++i) {
    const float x = -18.0f + 3.2f * static_cast<float>(i);
    add_box(line, {x, -0.2f, 6.0f}, {x + 1.6f, -0.112f, 6.14f});
  }
  for (int i = 0; i < 8; ++i) {
    const glm::vec3 foot(-6.3f + 1.8f * static_cast<float>(i), 0.0f, 2.8f);
    add_frustum(posts, foot, foot + glm::vec3(0.0f, 0.75f, 0.0f), 0.05f, 0.045f, 12);
    add_sphere(posts, foot + glm::vec3(0.0f, 0.79f, 0.0f), 0.065f, 4);
    if (i == 7) break;
    std::vector<glm::vec3> chain;
    for (int k = 0; k <= 12; ++k) {
      const float t = static_cast<float>(k) / 12.0f;
      chain.push_back(foot + glm::vec3(0.04f + 1.72f * t, 0.68f - 0.9f * t * (1.0f - t), 0.0f));
    }
    add_tube(posts, chain, 0.012f, 6);
  }
  for (const auto& [x, y, turn] :
       {std::array{-6.6, 0.17, 8.0}, {-6.05, 0.17, -14.0}, {-6.35, 0.51, 20.0}}) {
    const glm::mat4 place = glm::mat4(turned({x, y, 0.45}, turn));
    for (int i = 0; i < 3; ++i) {
      const double level = -0.11 + 0.11 * i;
      add_box(crates, {0.48f, 0.08f, 0.34f}, place * glm::mat4(turned({0.0, level, 0.0}, 0.0)));
    }
    add_box(crates, {0.44f, 0.32f, 0.3f}, place);
  }
  stage.add("pavement", std::move(pavement), stage.paint("pavement", 0xa29f98, 0.7f));
  stage.add("road", std::move(road), stage.paint("wet road", 0x45464c, 0.42f));
  stage.add("road line", std::move(line), stage.paint("line", 0xe0ddd0, 0.7f));
  stage.add("bollards", std::move(posts), stage.paint("black iron", 0x3a3c42, 0.5f));
  stage.add("crates", std::move(crates), stage.paint("crate", 0xa87d4e, 0.85f));
}

}  // namespace

// About a hundred small lights: the strokes of letters, bulbs and panes.
Scene make_neon() {
  SceneAssembler stage("neon");
  add_backdrop(stage);
  add_street(stage);
  add_front(stage);
  add_windows_of_front(stage);
  add_shop(stage);
  add_signs(stage);
  add_bulbs(stage);
  stage.sun("moon", {0.35, -0.6, -0.55}, 0x9db4ff, 0.16f);
  stage.camera("across the street", {-3.2, 1.7, 13.2}, {-0.2, 4.15, 0.0}, 46.0);
  stage.camera("at the door", {-2.6, 1.6, 4.6}, {0.4, 2.1, 0.0}, 50.0);
  return stage.take();
}

}  // namespace asos::builtin
