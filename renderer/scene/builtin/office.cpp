#include "renderer/scene/builtin/office_furniture.h"
#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>

namespace asos::builtin {

namespace {

// The room: x to the right, z towards the camera; the window is in the left wall.
constexpr float left = -2.6f, right = 2.6f, back = -2.0f, front = 3.0f, ceiling = 2.7f;
constexpr float window_y0 = 0.95f, window_y1 = 2.2f, window_z0 = -1.25f, window_z1 = 0.45f;
constexpr float wall_depth = 0.22f;

/// Adds floor, ceiling and walls, which face inwards. The left wall has the opening of the window.
void add_room(SceneAssembler& stage) {
  Mesh floor, top, walls;
  add_quad(floor, {left, 0, front}, {right, 0, front}, {right, 0, back}, {left, 0, back});
  add_quad(top, {left, ceiling, back}, {right, ceiling, back}, {right, ceiling, front},
           {left, ceiling, front});
  add_quad(walls, {left, 0, back}, {right, 0, back}, {right, ceiling, back}, {left, ceiling, back});
  add_quad(walls, {right, 0, back}, {right, 0, front}, {right, ceiling, front},
           {right, ceiling, back});
  add_quad(walls, {right, 0, front}, {left, 0, front}, {left, ceiling, front},
           {right, ceiling, front});

  const std::array<glm::vec3, 4> wall{
      {{left, 0, front}, {left, 0, back}, {left, ceiling, back}, {left, ceiling, front}}};
  std::array<glm::vec3, 4> opening{{{left, window_y0, window_z1},
                                    {left, window_y0, window_z0},
                                    {left, window_y1, window_z0},
                                    {left, window_y1, window_z1}}};
  add_rim(walls, wall, opening);
  std::array<glm::vec3, 4> outside = opening;
  for (glm::vec3& corner : outside) corner.x -= wall_depth;
  add_rim(walls, opening, outside);

  stage.add("floor", std::move(floor), stage.paint("parquet", 0xa9855c, 0.45f));
  stage.add("ceiling", std::move(top), stage.paint("ceiling", 0xf2f0ea, 0.95f));
  stage.add("walls", std::move(walls), stage.paint("wall", 0xd8d6cc, 0.95f));

  Mesh skirting;
  add_box(skirting, {left, 0.0f, back}, {left + 0.015f, 0.09f, front});
  add_box(skirting, {left + 0.015f, 0.0f, back}, {right, 0.085f, back + 0.015f});
  stage.add("skirting", std::move(skirting), stage.paint("skirting", 0xf0eee6, 0.6f));
}

/// Adds frame and mullions in the opening, a sill, and the view outside.
void add_window(SceneAssembler& stage) {
  const glm::vec2 half(0.5f * (window_z1 - window_z0), 0.5f * (window_y1 - window_y0));
  const glm::vec3 centre(left - 0.14f, 0.5f * (window_y0 + window_y1),
                         0.5f * (window_z0 + window_z1));
  const glm::mat4 placement = glm::mat4(turned(centre, 90.0));
  Mesh frame;
  add_frame(frame, half, half - 0.05f, 0.07f, placement);
  add_box(frame, {0.045f, 2.0f * half.y - 0.1f, 0.05f},
          glm::translate(placement, glm::vec3(0.0f, 0.0f, 0.035f)));
  const float bar = half.x - 0.05f - 0.0225f;  // from the centre mullion to the frame
  for (const float side : {-1.0f, 1.0f}) {
    for (const float y : {-0.19f, 0.19f}) {
      const glm::vec3 at(side * (0.0225f + 0.5f * bar), y, 0.035f);
      add_box(frame, {bar, 0.028f, 0.036f}, glm::translate(placement, at));
    }
  }
  stage.add("window frame", std::move(frame), stage.paint("window frame", 0xf4f2ec, 0.5f));

  Mesh sill;
  add_box(sill, {left, window_y0 - 0.045f, window_z0 - 0.06f},
          {left + 0.16f, window_y0, window_z1 + 0.06f});
  stage.add("window sill", std::move(sill), stage.paint("sill", 0xe9e5da, 0.5f));

  // The sky's screen stands low and far away, so that the sun passes over it.
  Mesh sky, lawn, hedge, leaves, trunk;
  add_quad(sky, {-14, -0.6f, 14}, {-14, -0.6f, -22}, {-14, 5.5f, -22}, {-14, 5.5f, 14});
  add_quad(lawn, {-14, -0.4f, 14}, {-3.2f, -0.4f, 14}, {-3.2f, -0.4f, -22}, {-14, -0.4f, -22});
  add_box(hedge, {-13.0f, -0.4f, -20.0f}, {-12.2f, 0.75f, 12.0f});
  add_sphere(leaves, {-10.4f, 1.9f, -4.6f}, 0.85f, 24);
  add_sphere(leaves, {-11.2f, 2.2f, -8.4f}, 1.0f, 24);
  add_frustum(trunk, {-10.4f, -0.4f, -4.6f}, {-10.4f, 1.3f, -4.6f}, 0.1f, 0.08f, 24);
  add_frustum(trunk, {-11.2f, -0.4f, -8.4f}, {-11.2f, 1.4f, -8.4f}, 0.1f, 0.08f, 24);
  stage.add("sky", std::move(sky), stage.glow("sky", 0xbcd8f5, 1.0f));
  stage.show_light();  // its light is the sun "sky over the garden"
  stage.add("lawn", std::move(lawn), stage.paint("lawn", 0x7fa650, 1.0f));
  stage.add("hedge", std::move(hedge), stage.paint("hedge", 0x4f7a3c, 1.0f));
  stage.add("tree", std::move(leaves), stage.paint("leaves", 0x6c9a45, 1.0f));
  stage.add("trunk", std::move(trunk), stage.paint("bark", 0x6d5039, 1.0f));
}

void add_room_door(SceneAssembler& stage) {
  constexpr float x0 = -2.35f, x1 = -1.5f, top = 2.05f;
  Mesh frame, leaf, handle;
  add_box(frame, {x0 - 0.08f, 0.0f, back}, {x0, top + 0.08f, back + 0.05f});
  add_box(frame, {x1, 0.0f, back}, {x1 + 0.08f, top + 0.08f, back + 0.05f});
  add_box(frame, {x0, top, back}, {x1, top + 0.075f, back + 0.047f});
  add_box(leaf, {x0, 0.01f, back}, {x1, top, back + 0.02f});
  for (const float y : {0.18f, 1.15f}) {
    const glm::vec3 centre(0.5f * (x0 + x1), y + 0.38f, back + 0.02f);
    add_frame(leaf, {0.31f, 0.38f}, {0.275f, 0.345f}, 0.012f,
              glm::translate(glm::mat4(1.0f), centre));
  }
  const std::array<glm::vec3, 8> bend{{{x1 - 0.07f, 1.0f, back + 0.02f},
                                       {x1 - 0.07f, 1.0f, back + 0.05f},
                                       {x1 - 0.073f, 1.0f, back + 0.06f},
                                       {x1 - 0.08f, 1.0f, back + 0.067f},
                                       {x1 - 0.09f, 1.0f, back + 0.07f},
                                       {x1 - 0.12f, 1.0f, back + 0.07f},
                                       {x1 - 0.15f, 1.0f, back + 0.07f},
                                       {x1 - 0.19f, 1.0f, back + 0.07f}}};
  add_tube(handle, bend, 0.009f, 16);
  stage.add("door frame", std::move(frame), stage.paint("door frame", 0x8a6a4a, 0.6f));
  stage.add("door", std::move(leaf), stage.paint("door", 0xb08d66, 0.6f));
  stage.add("door handle", std::move(handle), stage.paint("brushed steel", 0x9a9da3, 0.35f));
}

void add_whiteboard(SceneAssembler& stage) {
  const glm::vec3 centre(-0.2f, 1.62f, back);
  const glm::mat4 placement = glm::translate(glm::mat4(1.0f), centre);
  Mesh frame, board, tray, red_pen, blue_pen, writing;
  add_frame(frame, {0.95f, 0.55f}, {0.92f, 0.52f}, 0.03f, placement);
  add_box(board, centre + glm::vec3(-0.92f, -0.52f, 0.0f),
          centre + glm::vec3(0.92f, 0.52f, 0.012f));
  add_box(tray, centre + glm::vec3(-0.45f, -0.572f, 0.0f),
          centre + glm::vec3(0.45f, -0.558f, 0.085f));
  const auto pen = [centre](Mesh& mesh, float x) {
    const glm::vec3 at = centre + glm::vec3(x, -0.549f, 0.055f);
    add_frustum(mesh, at, at + glm::vec3(0.09f, 0.0f, 0.006f), 0.009f, 0.009f, 24);
    add_frustum(mesh, at + glm::vec3(0.09f, 0.0f, 0.006f), at + glm::vec3(0.125f, 0.0f, 0.008f),
                0.0075f, 0.005f, 24);
  };
  pen(red_pen, -0.2f);
  pen(blue_pen, 0.05f);
  add_box(tray, centre + glm::vec3(0.24f, -0.558f, 0.03f),
          centre + glm::vec3(0.36f, -0.525f, 0.075f));

  // A drawing on the board, of strokes as thin as a marker's: a pyramid of rays through a pixel.
  const glm::vec3 lift(0.0f, 0.0f, 0.0135f);
  const auto stroke = [&](glm::vec2 a, glm::vec2 b) {
    add_beam(writing, centre + glm::vec3(a, 0.0f) + lift, centre + glm::vec3(b, 0.0f) + lift,
             0.007f, 0.003f, {0.0f, 0.0f, 1.0f});
  };
  const glm::vec2 apex(-0.62f, 0.02f);
  const std::array<glm::vec2, 4> pixel{
      {{0.1f, -0.2f}, {0.3f, -0.08f}, {0.3f, 0.3f}, {0.1f, 0.18f}}};
  for (std::size_t i = 0; i < 4; ++i) {
    stroke(apex, pixel[i] - 0.01f * glm::normalize(pixel[i] - apex));
    stroke(pixel[i], pixel[(i + 1) % 4] - 0.005f * glm::normalize(pixel[(i + 1) % 4] - pixel[i]));
  }
  stroke({0.45f, -0.25f}, {0.68f, 0.33f});
  for (int i = 0; i < 3; ++i) {
    const float y = -0.34f - 0.035f * static_cast<float>(i);
    stroke({-0.7f, y}, {-0.35f + 0.06f * static_cast<float>(i), y});
  }
  stage.add("whiteboard frame", std::move(frame), stage.paint("aluminium", 0xb4b8bd, 0.4f));
  stage.add("whiteboard", std::move(board), stage.paint("whiteboard", 0xf6f7f7, 0.2f));
  stage.add("pen tray", std::move(tray), stage.paint("tray", 0x8f949a, 0.5f));
  stage.add("red pen", std::move(red_pen), stage.paint("red pen", 0xc23a35, 0.4f));
  stage.add("blue pen", std::move(blue_pen), stage.paint("blue pen", 0x2f5fb0, 0.4f));
  stage.add("drawing", std::move(writing), stage.paint("marker", 0x2b4f95, 0.8f));
}

/// Adds the luminous panel under the ceiling. The light is a rectangle slightly below the visible
/// panel, which would shadow it otherwise. The panel is displayed just brighter than white: at its
/// full radiance its outline would be clipped and look jagged with every method.
void add_ceiling_light(SceneAssembler& stage) {
  const glm::vec3 centre(0.1f, ceiling, -0.15f);
  const glm::mat4 facing_down =
      glm::rotate(glm::translate(glm::mat4(1.0f), centre), glm::radians(90.0f), glm::vec3(1, 0, 0));
  Mesh frame, panel;
  add_frame(frame, {0.66f, 0.36f}, {0.62f, 0.32f}, 0.06f, facing_down);
  add_box(panel, centre - glm::vec3(0.62f, 0.045f, 0.32f), centre + glm::vec3(0.62f, 0.0f, 0.32f));
  stage.add("light frame", std::move(frame), stage.paint("light frame", 0xd5d7d9, 0.5f));
  stage.add("light panel", std::move(panel), stage.glow("light panel", 0xfffaf0, 1.6f));
  stage.show_light();
  const glm::dvec3 below = glm::dvec3(centre) - glm::dvec3(0.0, 0.046, 0.0);
  stage.panel("ceiling panel", below, below - glm::dvec3(0, 1, 0), {1.24, 0.64}, 0xfff6e6, 11.6f);
}

/// Adds all of the office but its cameras.
void furnish_office(SceneAssembler& stage) {
  add_room(stage);
  add_window(stage);
  add_room_door(stage);
  add_whiteboard(stage);
  add_ceiling_light(stage);
  add_desk(stage, {-0.15, 0.0, -0.75});
  add_chair(stage, turned({0.1, 0.0, 0.1}, 28.0));
  add_shelf(stage, {1.5, 0.0, back});
  add_waste_bin(stage, {1.2, 0.0, -0.35});

  stage.sun("sun", {0.78, -0.6, 0.3}, 0xffe9c4, 5.0f);
  stage.sun("sky over the garden", {-0.6, -0.5, 0.1}, 0xe8f1ff, 2.4f);  // lights only the garden
  stage.lamp("fill", {0.9, 1.75, 2.85}, 0xeaf0ff, 5.0f);
  stage.spot("bounce", {0.7, 1.45, 2.9}, {0.0, 2.7, 0.6}, 0xffefdc, 14.0f, 62.0);
}

}  // namespace

// A room in the spirit of the papers' office (CGF'98 section 7.1): thin chair legs and rungs, pens,
// mullions and the arm of a lamp between large plain surfaces.
Scene make_office() {
  SceneAssembler stage("office");
  furnish_office(stage);
  stage.camera("room", {1.45, 1.62, 2.8}, {-0.25, 1.1, -1.1}, 53.0);
  stage.camera("desk", {0.75, 1.25, 0.75}, {-0.25, 0.82, -0.9}, 46.0);
  return stage.take();
}

// CGF'98 figure 20: nearer to the desk, whose metal blurs the reflected whiteboard; the whiteboard
// reflects the ceiling light. The camera is between the chair's back and the desk.
Scene make_office_metal() {
  SceneAssembler stage("office-metal");
  furnish_office(stage);
  Material& top = stage.material("desk top");
  top.metallic = 1.0f;
  top.roughness = 0.15f;
  top.base_color = stage.material("aluminium").base_color;
  stage.material("whiteboard").roughness = 0.1f;
  stage.camera("desk", {0.5, 1.2, 0.18}, {0.02, 1.02, -1.6}, 62.0);
  return stage.take();
}

}  // namespace asos::builtin
