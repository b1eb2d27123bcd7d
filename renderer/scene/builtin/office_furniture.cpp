#include "renderer/scene/builtin/office_furniture.h"

#include "renderer/scene/builtin/shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace asos::builtin {

namespace {

constexpr float desk_height = 0.74f;

/// Adds a jointed lamp standing at the origin of `placement`: foot, two thin arms, conical shade.
void add_desk_lamp(SceneAssembler& stage, const glm::dmat4& placement) {
  const glm::vec3 foot(0.0f, 0.018f, 0.0f), elbow(-0.10f, 0.30f, 0.0f), head(0.16f, 0.44f, 0.0f);
  Mesh metal, shade;
  add_frustum(metal, {0.0f, 0.0f, 0.0f}, foot, 0.085f, 0.08f, 64);
  // Both arms end inside the joint, short of the joint's centre and of each other.
  add_frustum(metal, foot, elbow - 0.008f * glm::normalize(elbow - foot), 0.006f, 0.006f, 16);
  add_sphere(metal, elbow, 0.012f, 8);
  add_frustum(metal, elbow + 0.008f * glm::normalize(head - elbow), head, 0.006f, 0.006f, 16);
  // The shade is a thin shell: its outline runs down the inside and up the outside.
  const glm::vec3 axis = glm::normalize(glm::vec3(-0.25f, 1.0f, 0.0f));
  const std::array<glm::vec2, 6> outline{{{0.0f, 0.117f},
                                          {0.026f, 0.117f},
                                          {0.082f, 0.0f},
                                          {0.085f, 0.0f},
                                          {0.03f, 0.12f},
                                          {0.0f, 0.12f}}};
  add_lathe(shade, head - 0.11f * axis, axis, outline, 64);
  const int metal_mesh =
      stage.keep("lamp arm", std::move(metal), stage.paint("lamp arm", 0x50555c, 0.4f));
  const int shade_mesh =
      stage.keep("lamp shade", std::move(shade), stage.paint("lamp shade", 0xb5332c, 0.4f));
  stage.place("lamp arm", metal_mesh, placement);
  stage.place("lamp shade", shade_mesh, placement);
  const glm::dvec3 bulb(placement * glm::dvec4(head - 0.075f * axis, 1.0));
  const glm::dvec3 below(placement * glm::dvec4(head - 0.5f * axis, 1.0));
  stage.spot("desk lamp", bulb, below, 0xffdfae, 0.16f, 50.0);
}

void add_screen(SceneAssembler& stage, const glm::dmat4& placement) {
  Mesh body, picture;
  add_box(body, {-0.11f, 0.0f, -0.09f}, {0.11f, 0.012f, 0.09f});
  add_box(body, {-0.025f, 0.012f, -0.03f}, {0.025f, 0.16f, -0.005f});
  add_frame(body, {0.27f, 0.17f}, {0.257f, 0.157f}, 0.03f,
            glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.29f, -0.005f)));
  add_box(picture, {-0.257f, 0.133f, -0.003f}, {0.257f, 0.447f, 0.017f});
  const int body_mesh =
      stage.keep("screen", std::move(body), stage.paint("screen", 0x3a3d42, 0.5f));
  const int picture_mesh =
      stage.keep("picture", std::move(picture), stage.glow("picture", 0x4f86b8, 0.8f));
  stage.place("screen", body_mesh, placement);
  stage.place("picture", picture_mesh, placement);
  stage.show_light();  // too dim compared with the panel to be a light
}

/// Appends a mug that stands at `at`, with a wall and a handle.
void add_mug(Mesh& mesh, glm::vec3 at) {
  const std::array<glm::vec2, 6> outline{{{0.0f, 0.0f},
                                          {0.037f, 0.0f},
                                          {0.040f, 0.095f},
                                          {0.036f, 0.095f},
                                          {0.033f, 0.008f},
                                          {0.0f, 0.008f}}};
  add_lathe(mesh, at, {0.0f, 1.0f, 0.0f}, outline, 64);
  std::vector<glm::vec3> handle;
  for (int i = 0; i <= 16; ++i) {
    const float turn = glm::radians(-78.0f + 156.0f * static_cast<float>(i) / 16.0f);
    handle.push_back(
        at + glm::vec3(0.034f + 0.03f * std::cos(turn), 0.05f + 0.032f * std::sin(turn), 0.0f));
  }
  add_tube(mesh, handle, 0.005f, 16);
}

}  // namespace

void add_desk(SceneAssembler& stage, glm::dvec3 place) {
  Mesh top, legs, drawers, handles;
  const float under = desk_height - 0.035f;
  add_box(top, {-0.85f, under, -0.38f}, {0.85f, desk_height, 0.38f});
  for (const float x : {-0.82f, 0.77f}) {
    for (const float z : {-0.35f, 0.30f})
      add_box(legs, {x, 0.0f, z}, {x + 0.05f, under, z + 0.05f});
  }
  add_box(legs, {-0.77f, under - 0.3f, -0.335f}, {0.77f, under, -0.315f});
  add_box(drawers, {0.34f, 0.26f, -0.31f}, {0.76f, under, 0.31f});
  for (int i = 0; i < 3; ++i) {
    const float y = 0.285f + 0.142f * static_cast<float>(i);
    add_box(drawers, {0.352f, y, 0.31f}, {0.748f, y + 0.125f, 0.325f});
    add_frustum(handles, {0.49f, y + 0.07f, 0.343f}, {0.61f, y + 0.07f, 0.343f}, 0.006f, 0.006f,
                16);
    for (const float x : {0.505f, 0.595f}) {
      add_frustum(handles, {x, y + 0.07f, 0.325f}, {x, y + 0.07f, 0.341f}, 0.004f, 0.004f, 12);
    }
  }
  const glm::dmat4 placement = turned(place, 0.0);
  stage.place("desk top",
              stage.keep("desk top", std::move(top), stage.paint("desk top", 0xc59a66, 0.35f)),
              placement);
  stage.place("desk legs",
              stage.keep("desk legs", std::move(legs), stage.paint("desk legs", 0x77797d, 0.5f)),
              placement);
  stage.place("drawers",
              stage.keep("drawers", std::move(drawers), stage.paint("drawers", 0xa97f50, 0.5f)),
              placement);
  stage.place(
      "drawer handles",
      stage.keep("drawer handles", std::move(handles), stage.paint("handle", 0x8d9197, 0.4f)),
      placement);

  Mesh papers, mug, pencil;
  const auto sheet = [&papers](glm::vec3 at, float degrees) {
    const glm::mat4 turn = glm::mat4(turned(at + glm::vec3(0.0f, 0.0015f, 0.0f), degrees));
    add_box(papers, {0.21f, 0.003f, 0.297f}, turn);
  };
  sheet({0.02f, desk_height, 0.17f}, 8.0f);
  sheet({0.03f, desk_height + 0.003f, 0.16f}, -6.0f);
  sheet({-0.42f, desk_height, 0.16f}, 21.0f);
  add_mug(mug, {0.36f, desk_height, 0.12f});
  const glm::vec3 tip(-0.12f, desk_height + 0.005f, 0.27f),
      end(-0.25f, desk_height + 0.005f, 0.15f);
  add_frustum(pencil, tip, end, 0.004f, 0.004f, 6);
  stage.place("papers",
              stage.keep("papers", std::move(papers), stage.paint("paper", 0xf3f1ea, 0.95f)),
              placement);
  stage.place("mug", stage.keep("mug", std::move(mug), stage.paint("mug", 0x2f7f86, 0.3f)),
              placement);
  stage.place("pencil",
              stage.keep("pencil", std::move(pencil), stage.paint("pencil", 0xe0a92e, 0.5f)),
              placement);
  add_screen(stage, turned(place + glm::dvec3(0.08, desk_height, -0.16), -6.0));
  add_desk_lamp(stage, turned(place + glm::dvec3(-0.64, desk_height, -0.12), -38.0));
}

void add_chair(SceneAssembler& stage, const glm::dmat4& placement) {
  Mesh seat, sticks;
  add_box(seat, {-0.22f, 0.44f, -0.21f}, {0.22f, 0.47f, 0.21f});
  const auto stick = [&sticks](glm::vec3 a, glm::vec3 b, float r) {
    add_frustum(sticks, a, b, r, r, 24);
  };

  // Legs splay outwards; rungs join them at two heights.
  const auto leg = [](float side, float end, float y) {
    const float splay = 1.0f + 0.14f * (0.44f - y) / 0.44f;
    return glm::vec3(0.17f * side * splay, y, 0.16f * end * splay);
  };
  for (const float side : {-1.0f, 1.0f}) {
    for (const float end : {-1.0f, 1.0f}) {
      add_frustum(sticks, leg(side, end, 0.0f), leg(side, end, 0.44f), 0.013f, 0.017f, 24);
    }
    stick(leg(side, -1.0f, 0.16f), leg(side, 1.0f, 0.16f), 0.008f);
    stick(leg(side, -1.0f, 0.27f), leg(side, 1.0f, 0.27f), 0.008f);
  }
  stick(leg(-1.0f, -1.0f, 0.21f), leg(1.0f, -1.0f, 0.21f), 0.008f);
  stick(leg(-1.0f, 1.0f, 0.21f), leg(1.0f, 1.0f, 0.21f), 0.008f);

  // The back leans: two posts, six spindles and a top rail that bows.
  const auto lean = [](float x, float y) { return glm::vec3(x, y, 0.17f + 0.2f * (y - 0.47f)); };
  for (const float x : {-0.19f, 0.19f}) stick(lean(x, 0.465f), lean(1.08f * x, 0.93f), 0.012f);
  for (int i = 0; i < 6; ++i) {
    const float x = -0.1357f + 0.0543f * static_cast<float>(i);
    stick(lean(x, 0.465f), lean(1.08f * x, 0.90f), 0.0055f);
  }
  std::vector<glm::vec3> rail;
  for (int i = 0; i <= 24; ++i) {
    const float t = -1.0f + 2.0f * static_cast<float>(i) / 24.0f;
    rail.push_back(lean(0.225f * t, 0.93f - 0.018f * t * t));
  }
  add_tube(sticks, rail, 0.019f, 24);
  stage.place("chair seat",
              stage.keep("chair seat", std::move(seat), stage.paint("seat", 0x8f3f33, 0.6f)),
              placement);
  stage.place(
      "chair frame",
      stage.keep("chair frame", std::move(sticks), stage.paint("chair wood", 0x9c6b3f, 0.5f)),
      placement);
}

void add_shelf(SceneAssembler& stage, glm::dvec3 place) {
  constexpr float width = 0.95f, depth = 0.28f, height = 1.92f, board = 0.02f;
  constexpr int rows = 5;
  Mesh wood;
  add_box(wood, {0.0f, 0.0f, 0.0f}, {board, height, depth});
  add_box(wood, {width - board, 0.0f, 0.0f}, {width, height, depth});
  for (int i = 0; i <= rows; ++i) {
    const float y = 0.05f + (height - 0.07f) * static_cast<float>(i) / rows;
    add_box(wood, {board, y, 0.0f}, {width - board, y + board, depth - 0.01f});
  }
  const glm::dmat4 placement = turned(place, 0.0);
  stage.place("shelf", stage.keep("shelf", std::move(wood), stage.paint("shelf", 0xb79064, 0.6f)),
              placement);

  // Books of many sizes and five colours, from a fixed pseudo-random sequence.
  std::uint32_t state = 12345;
  const auto random = [&state](float from, float to) {
    state = state * 1664525u + 1013904223u;
    return from + (to - from) * static_cast<float>(state >> 8) / 16777216.0f;
  };
  std::array<Mesh, 5> books;
  for (int row = 0; row < rows; ++row) {
    const float floor = 0.05f + (height - 0.07f) * static_cast<float>(row) / rows + board;
    float x = board + 0.004f;
    const float stop = width - board - random(0.03f, 0.3f);
    while (true) {
      const float thick = random(0.016f, 0.055f), tall = random(0.21f, 0.315f);
      if (x + thick > stop) break;
      const float out = depth - random(0.02f, 0.07f);
      Mesh& mesh = books[static_cast<std::size_t>(random(0.0f, 4.999f))];
      add_box(mesh, {x, floor, 0.02f}, {x + thick, floor + tall, out});
      x += thick + 0.0015f;
    }
  }
  constexpr std::array<std::uint32_t, 5> colours{0x8c3b32, 0x2f5a7d, 0xc9a44a, 0x44705a, 0xd9d2c0};
  for (std::size_t i = 0; i < books.size(); ++i) {
    const std::string name = "books " + std::to_string(i + 1);
    stage.place(name, stage.keep(name, std::move(books[i]), stage.paint(name, colours[i], 0.7f)),
                placement);
  }
}

void add_waste_bin(SceneAssembler& stage, glm::dvec3 place) {
  const std::array<glm::vec2, 6> outline{{{0.0f, 0.0f},
                                          {0.11f, 0.0f},
                                          {0.145f, 0.32f},
                                          {0.14f, 0.32f},
                                          {0.106f, 0.01f},
                                          {0.0f, 0.01f}}};
  Mesh bin, ball;
  add_lathe(bin, {}, {0.0f, 1.0f, 0.0f}, outline, 96);
  Blob crumpled;
  crumpled.ripples = {{{5.0f, 7.0f, -4.0f}, 0.10f, 0.2f}, {{-9.0f, 6.0f, 11.0f}, 0.06f, 1.3f}};
  add_blob(ball, {0.02f, 0.27f, 0.03f}, glm::vec3(0.055f), crumpled, 16);
  const glm::dmat4 placement = turned(place, 0.0);
  stage.place("waste bin",
              stage.keep("waste bin", std::move(bin), stage.paint("bin", 0x4a5560, 0.5f)),
              placement);
  stage.place(
      "crumpled paper",
      stage.keep("crumpled paper", std::move(ball), stage.paint("crumpled", 0xefece2, 0.95f)),
      placement);
}

}  // namespace asos::builtin
