#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"
#include "renderer/scene/builtin/textures.h"
#include "renderer/scene/builtin/tools.h"

#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace asos::builtin {

namespace {

// The bench stands along the wall z = 0; its top is 0.95 m above the floor.
constexpr float bench_half = 2.1f, bench_depth = 0.85f, bench_top = 0.95f;

/// Adds a metal that is rough enough to reflect only the lamps recognizably, not the room.
int paint_metal(SceneAssembler& stage, const std::string& name, std::uint32_t srgb, float roughness,
                int normals = -1, float metres = 1.0f) {
  const int index = stage.paint(name, srgb, roughness, 1.0f);
  if (normals >= 0) stage.material(name).normal_texture = by_metres(normals, metres);
  return index;
}

void add_workshop(SceneAssembler& stage) {
  Mesh floor, wall, board, edge;
  add_quad(floor, {-7, 0, 8}, {7, 0, 8}, {7, 0, 0}, {-7, 0, 0});
  add_quad(wall, {-7, 0, 0}, {7, 0, 0}, {7, 4, 0}, {-7, 4, 0});
  add_box(board, {-1.75f, 1.25f, 0.0f}, {1.75f, 2.45f, 0.03f});
  for (const float y : {1.2f, 2.45f}) add_box(edge, {-1.8f, y, 0.0f}, {1.8f, y + 0.05f, 0.05f});
  for (const float x : {-1.798f, 1.752f})
    add_box(edge, {x, 1.245f, 0.0f}, {x + 0.046f, 2.455f, 0.048f});
  stage.add("floor", std::move(floor), stage.paint("concrete", 0x9b978f, 0.85f));
  stage.add("wall", std::move(wall), stage.paint("wall", 0xb9b4a6, 0.95f));
  stage.add("tool board", std::move(board), stage.paint("tool board", 0x93a69b, 0.8f));
  stage.add("board edge", std::move(edge), stage.paint("pale wood", 0xc9a777, 0.7f));
}

/// Adds a wooden bench with a hammered sheet on its top, and drawers under it.
void add_bench(SceneAssembler& stage, int hammered) {
  Mesh wood, sheet, drawers, knobs;
  add_box(wood, {-bench_half, bench_top - 0.08f, 0.05f},
          {bench_half, bench_top - 0.004f, 0.05f + bench_depth});
  for (const float x : {-bench_half + 0.08f, -0.65f, 0.65f, bench_half - 0.08f}) {
    for (const float z : {0.12f, 0.82f})
      add_box(wood, {x - 0.045f, 0.0f, z - 0.045f}, {x + 0.045f, bench_top - 0.075f, z + 0.045f});
  }
  add_box(wood, {-bench_half + 0.1f, 0.22f, 0.1f}, {bench_half - 0.1f, 0.26f, 0.84f});
  for (int i = 0; i < 3; ++i) {
    const float y = 0.3f + 0.19f * static_cast<float>(i);
    add_box(drawers, {0.72f, y, 0.14f}, {1.92f, y + 0.17f, 0.86f});
    for (const float x : {1.02f, 1.62f})
      add_tube(knobs,
               std::array<glm::vec3, 4>{{{x - 0.07f, y + 0.09f, 0.855f},
                                         {x - 0.05f, y + 0.09f, 0.89f},
                                         {x + 0.05f, y + 0.09f, 0.89f},
                                         {x + 0.07f, y + 0.09f, 0.855f}}},
               0.008f, 8);
  }
  add_box(sheet, {-bench_half - 0.01f, bench_top - 0.004f, 0.05f},
          {bench_half + 0.01f, bench_top, 0.07f + bench_depth});
  add_box(sheet, {-bench_half - 0.01f, bench_top - 0.06f, 0.05f + bench_depth},
          {bench_half + 0.01f, bench_top - 0.002f, 0.066f + bench_depth});
  add_texcoords(sheet);
  stage.add("bench", std::move(wood), stage.paint("oak", 0xa77c4f, 0.75f));
  stage.add("drawers", std::move(drawers), stage.paint("red drawers", 0xa8382f, 0.5f));
  stage.add("drawer handles", std::move(knobs), paint_metal(stage, "handles", 0xd8d8d6, 0.4f));
  stage.add("bench sheet", std::move(sheet),
            paint_metal(stage, "hammered zinc", 0xc4c8cc, 0.38f, hammered, 0.9f));
}

/// Sheets of brushed metal that lean on the wall, and one on the bench with a cut corner.
void add_sheets(SceneAssembler& stage, int brushed) {
  const std::array<std::uint32_t, 3> colours{0xd9dadb, 0xd99a6c, 0xdcc07a};
  const std::array<const char*, 3> names{"steel sheet", "copper sheet", "brass sheet"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto n = static_cast<float>(i);
    Mesh mesh;
    const float height = 1.5f - 0.25f * n, lean = 0.34f + 0.09f * n;
    const glm::vec3 foot(-3.05f + 0.16f * n, 0.006f, lean),
        up = glm::normalize(
            glm::vec3(0.0f, std::sqrt(height * height - lean * lean), 0.03f + 0.055f * n - lean));
    add_beam(mesh, foot, foot + height * up, 1.05f - 0.12f * n, 0.006f, {0.0f, 0.3f, 1.0f});
    add_texcoords(mesh);
    stage.add(names[i], std::move(mesh),
              paint_metal(stage, names[i], colours[i], 0.4f, brushed, 0.5f));
  }
  Mesh plate;
  const std::array<glm::vec2, 5> outline{
      {{0.0f, 0.0f}, {0.62f, 0.0f}, {0.62f, 0.26f}, {0.46f, 0.42f}, {0.0f, 0.42f}}};
  glm::mat4 flat(1.0f);
  flat[0] = {0.97f, 0.0f, -0.2431049f, 0.0f};
  flat[1] = {-0.2431049f, 0.0f, -0.97f, 0.0f};
  flat[2] = {0.0f, 1.0f, 0.0f, 0.0f};
  flat[3] = {-0.45f, bench_top + 0.0005f, 0.78f, 1.0f};
  add_prism(plate, outline, 0.005f, flat);
  add_texcoords(plate);
  stage.add("cut plate", std::move(plate),
            paint_metal(stage, "cut plate", 0xe0e2e4, 0.42f, brushed, 0.35f));
}

/// Pipes of several metals: along the wall with brackets, and a few that lean in the corner.
void add_pipes(SceneAssembler& stage, int brushed) {
  Mesh steel, copper, brackets;
  const auto pipe = [](Mesh& mesh, glm::vec3 from, glm::vec3 to, float radius) {
    const auto first = vertex_count(mesh);
    add_frustum(mesh, from, to, radius, radius, 28);
    add_round_texcoords(mesh, first, from, to - from, radius);
  };
  for (const auto& [y, radius] : {std::array{2.75f, 0.055f}, {2.93f, 0.035f}, {3.06f, 0.035f}}) {
    pipe(radius > 0.05f ? steel : copper, {-7.0f, y, 0.14f}, {7.0f, y, 0.14f}, radius);
    for (int i = 0; i < 9; ++i) {
      const float x = -5.6f + 1.4f * static_cast<float>(i);
      add_frustum(brackets, {x - 0.02f, y, 0.14f}, {x + 0.02f, y, 0.14f}, radius + 0.008f,
                  radius + 0.008f, 20);
      add_box(brackets, {x - 0.012f, y - 0.012f, 0.0f}, {x + 0.012f, y + 0.012f, 0.11f});
    }
  }
  for (int i = 0; i < 5; ++i) {
    const auto n = static_cast<float>(i);
    pipe(i % 2 == 0 ? steel : copper, {2.5f + 0.13f * n, 0.0f, 0.42f + 0.03f * n},
         {2.62f + 0.1f * n, 2.3f - 0.17f * n, 0.07f + 0.012f * n}, 0.03f + 0.005f * n);
  }
  stage.add("steel pipes", std::move(steel),
            paint_metal(stage, "steel pipe", 0xc9cccf, 0.38f, brushed, 0.4f));
  stage.add("copper pipes", std::move(copper),
            paint_metal(stage, "copper pipe", 0xdd9468, 0.36f, brushed, 0.4f));
  stage.add("brackets", std::move(brackets), paint_metal(stage, "bracket", 0x8c9094, 0.5f));
}

/// Adds the workpieces: bowls and a vase beaten from sheet, and gears.
void add_work(SceneAssembler& stage, int hammered, int brushed) {
  struct Vessel {
    const char* name;
    std::uint32_t srgb;
    glm::vec3 foot;
    float size;
    bool tall;
  };
  for (const Vessel& v : {Vessel{"copper bowl", 0xe09a70, {-1.35f, bench_top, 0.45f}, 0.21f, false},
                          {"brass bowl", 0xe2c678, {-0.86f, bench_top, 0.33f}, 0.15f, false},
                          {"tin vase", 0xd5d9dc, {-1.78f, bench_top, 0.3f}, 0.14f, true}}) {
    Mesh mesh;
    add_vessel(mesh, v.foot, v.size, v.tall);
    add_round_texcoords(mesh, 0, v.foot, {0.0f, 1.0f, 0.0f}, 0.7f * v.size);
    stage.add(v.name, std::move(mesh), paint_metal(stage, v.name, v.srgb, 0.37f, hammered, 0.55f));
  }
  Mesh gears;
  add_gear(gears, {0.55f, bench_top + 0.001f, 0.36f}, 0.16f, 22);
  add_gear(gears, {0.88f, bench_top + 0.001f, 0.5f}, 0.11f, 15);
  add_gear(gears, {0.62f, bench_top + 0.043f, 0.4f}, 0.08f, 12);
  add_texcoords(gears);
  stage.add("gears", std::move(gears),
            paint_metal(stage, "gear steel", 0xc3c6c8, 0.4f, brushed, 0.3f));
}

void add_tools(SceneAssembler& stage, int brushed) {
  ToolMeshes tools;
  for (int i = 0; i < 6; ++i)
    add_spanner(tools, {-1.58f + 0.15f * static_cast<float>(i), 2.34f, 0.045f},
                0.46f - 0.045f * static_cast<float>(i));
  for (int i = 0; i < 6; ++i)
    add_screwdriver(tools, {-0.52f + 0.13f * static_cast<float>(i), 2.34f, 0.06f},
                    0.42f - 0.03f * static_cast<float>(i % 4));
  add_hammer(tools, {0.48f, 2.32f, 0.07f}, 0.48f);
  add_hammer(tools, {0.74f, 2.32f, 0.07f}, 0.38f);
  add_saw(tools, {0.98f, 2.26f, 0.05f}, 0.8f);
  add_square(tools, {1.6f, 2.32f, 0.05f}, 0.36f);
  for (int i = 0; i < 4; ++i)
    add_pliers(tools, {-1.5f + 0.24f * static_cast<float>(i), 1.8f, 0.05f},
               0.36f - 0.03f * static_cast<float>(i));
  for (int i = 0; i < 7; ++i)
    add_chisel(tools, {-0.5f + 0.12f * static_cast<float>(i), 1.8f, 0.055f},
               0.34f + 0.03f * static_cast<float>(i % 3));
  add_spanner(tools, {1.5f, 1.78f, 0.045f}, 0.42f);
  add_hammer(tools, {0.62f, 1.76f, 0.07f}, 0.34f);
  add_vice(tools, {1.45f, bench_top, 0.72f});
  add_texcoords(tools.blades);
  stage.add("blades", std::move(tools.blades),
            paint_metal(stage, "tool steel", 0xd0d3d6, 0.38f, brushed, 0.25f));
  stage.add("rods", std::move(tools.rods), paint_metal(stage, "chrome", 0xdfe2e5, 0.36f));
  stage.add("handles", std::move(tools.handles), stage.paint("red handle", 0xb5362c, 0.45f));
  stage.add("wooden handles", std::move(tools.wood), stage.paint("ash wood", 0xcfa469, 0.6f));
  stage.add("vice", std::move(tools.cast), stage.paint("blue paint", 0x2f5a86, 0.5f));
}

/// Adds two lamps above the bench, as panels in housings on chains, a strip light, and a window's
/// light.
void add_panel_lamps(SceneAssembler& stage) {
  Mesh housing, panels, chains;
  for (const float x : {-1.15f, 1.15f}) {
    add_box(housing, {x - 0.66f, 3.3f, 0.62f}, {x + 0.66f, 3.38f, 0.98f});
    add_box(panels, {x - 0.6f, 3.29f, 0.66f}, {x + 0.6f, 3.305f, 0.94f});
    for (const float side : {-0.5f, 0.5f})
      add_frustum(chains, {x + side, 3.37f, 0.8f}, {x + side, 5.0f, 0.8f}, 0.006f, 0.006f, 6);
    stage.panel(x < 0.0f ? "left lamp" : "right lamp", {x, 3.285, 0.8}, {x, 0.0, 0.8}, {1.2, 0.28},
                0xfff3dc, 21.0f);
  }
  stage.add("lamp housings", std::move(housing), stage.paint("white enamel", 0xe8e8e4, 0.5f));
  stage.add("lamp chains", std::move(chains), stage.paint("chain", 0x6a6c70, 0.6f));
  stage.add("lamp panels", std::move(panels), stage.glow("lamp light", 0xfff3dc, 1.2f));
  stage.show_light();
  // A strip light under the tool board, whose highlight is visible on the bench.
  Mesh strip, strip_panel;
  add_box(strip, {-1.7f, 1.165f, 0.05f}, {1.7f, 1.2f, 0.11f});
  add_box(strip_panel, {-1.66f, 1.158f, 0.06f}, {1.66f, 1.17f, 0.1f});
  stage.panel("strip", {0.0, 1.152, 0.08}, {0.0, 0.0, 0.6}, {3.3, 0.035}, 0xfff0d8, 30.0f);
  stage.add("strip housing", std::move(strip), stage.paint("aluminium", 0xc8c8c6, 0.5f));
  stage.add("strip panel", std::move(strip_panel), stage.glow("strip light", 0xfff0d8, 1.2f));
  stage.show_light();
  stage.panel("window", {-4.6, 2.6, 4.4}, {-0.2, 1.0, 0.3}, {1.6, 2.0}, 0xcfe0ff, 5.0f);
}

}  // namespace

// Sheets, pipes and tools under area lamps. Normal maps break up their highlights.
Scene make_workshop() {
  SceneAssembler stage("workshop");
  const int hammered = stage.keep_texture(hammered_normals(1.0));
  const int brushed = stage.keep_texture(brushed_normals(1.0));
  add_workshop(stage);
  add_bench(stage, hammered);
  add_sheets(stage, brushed);
  add_pipes(stage, brushed);
  add_work(stage, hammered, brushed);
  add_tools(stage, brushed);
  add_panel_lamps(stage);
  stage.camera("bench", {0.75, 1.95, 4.6}, {0.0, 1.5, 0.2}, 43.0);
  stage.camera("copper", {-0.75, 1.6, 2.5}, {-0.8, 1.25, 0.3}, 48.0);
  return stage.take();
}

}  // namespace asos::builtin
