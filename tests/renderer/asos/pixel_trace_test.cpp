#include "renderer/asos/pixel_trace.h"

#include "renderer/comparison/method.h"
#include "renderer/gltf/load.h"
#include "renderer/scene/builtin.h"
#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <set>
#include <tuple>

// The trace of a pixel agrees with rendering it: it is checked against the whole picture and for
// consistency.

namespace asos::test::pixel_trace_test {
namespace {

using SharedScene = std::shared_ptr<const RenderScene>;

Film render(const RenderScene& scene, const View& view, const RenderSettings& settings) {
  Film film(settings.width, settings.height);
  const int side = block_side(settings);
  for (int y = 0; y < settings.height; y += side) {
    for (int x = 0; x < settings.width; x += side) {
      const PixelRect block{x, y, std::min(side, settings.width - x),
                            std::min(side, settings.height - y)};
      film.put(render_block(scene, view, settings, block).tile);
    }
  }
  return film;
}

double area_of(const TracedCell& cell) {
  return static_cast<double>(cell.side) * static_cast<double>(cell.side);
}

bool is_marginal(CellFate fate) {
  return fate == CellFate::split || fate == CellFate::stopped || fate == CellFate::finest;
}

// Corner and side in 1/256 of the pixel; these are integers for all cells, except for rounding.
using Place = std::tuple<long, long, long>;
Place place_of(glm::vec2 corner, float side) {
  return {std::lround(256.0f * corner.x), std::lround(256.0f * corner.y),
          std::lround(256.0f * side)};
}

bool has_children(CellFate fate) {
  return fate == CellFate::split || fate == CellFate::uneven;
}

// Every split cell has four quarters, and every cell but the first has a parent.
void check_tree(const PixelTrace& trace) {
  std::set<Place> expected{place_of({0, 0}, 1.0f)};
  std::set<Place> found;
  for (const TracedCell& cell : trace.cells) {
    EXPECT_NEAR(cell.side, std::ldexp(1.0, -cell.level), 1e-5);
    EXPECT_TRUE(found.insert(place_of(cell.corner, cell.side)).second) << "twice";
    if (!has_children(cell.fate)) continue;
    EXPECT_TRUE(cell.samples.empty());
    const float half = 0.5f * cell.side;
    for (int i = 0; i < 4; ++i)
      expected.insert(place_of(
          cell.corner + half * glm::vec2(static_cast<float>(i & 1), static_cast<float>(i >> 1)),
          half));
  }
  EXPECT_EQ(found, expected);
}

double area_of(const std::vector<BorderEdge>& border) {
  double area = 0.0;
  for (const BorderEdge& side : border) {
    const glm::dvec2 a(side.from), b(side.to);
    area += 0.5 * (a.x * b.y - a.y * b.x);
  }
  return area;
}

// The weights of each finished cell's samples sum to its area; together they give the pixel.
void check_samples(const PixelTrace& trace) {
  double total = 0.0, unresolved = 0.0;
  glm::dvec3 colour(0.0);
  for (const TracedCell& cell : trace.cells) {
    double weight = 0.0;
    for (const TracedSample& s : cell.samples) {
      weight += s.weight;
      const double area = s.border.empty() ? area_of(cell) : area_of(s.border);
      EXPECT_NEAR(area, s.weight, 1e-5) << "the part's border encloses its area";
      colour += s.weight * glm::dvec3(s.radiance);
      const glm::vec2 in = (s.at - cell.corner) / cell.side;
      EXPECT_TRUE(in.x > -1e-4f && in.y > -1e-4f && in.x < 1.0001f && in.y < 1.0001f);
    }
    total += weight;
    if (has_children(cell.fate)) continue;
    EXPECT_NEAR(weight, area_of(cell), 1e-5);
    const bool resolved = cell.fate == CellFate::uniform || cell.fate == CellFate::cut ||
                          cell.fate == CellFate::sampled || cell.fate == CellFate::by_samples;
    if (!resolved) unresolved += area_of(cell);
  }
  EXPECT_NEAR(total, 1.0, 1e-6);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(colour[k], static_cast<double>(trace.radiance[k]), 1e-6);
  if (trace.cells.front().fate != CellFate::by_samples) {
    EXPECT_NEAR(trace.unresolved_area, unresolved, 1e-5);
  }
}

// The tables count the listed cells.
void check_levels(const PixelTrace& trace) {
  for (const LevelStatistics& tally : trace.levels) {
    const auto marginal =
        std::count_if(trace.cells.begin(), trace.cells.end(), [&](const TracedCell& cell) {
          return cell.level == tally.level && is_marginal(cell.fate);
        });
    EXPECT_EQ(static_cast<long>(tally.marginal), marginal);
    for (const ObjectStatistics& object : tally.objects)
      EXPECT_LE(object.marginal(), tally.marginal);
  }
  for (const TracedCell& cell : trace.cells) {
    if (is_marginal(cell.fate)) {
      EXPECT_TRUE(
          std::any_of(trace.levels.begin(), trace.levels.end(),
                      [&](const LevelStatistics& tally) { return tally.level == cell.level; }));
    }
  }
}

/// How far a cone extends beyond its cell, in cells. Its circle extends by (sqrt 2 - 1) / 2. Off
/// the axis it becomes an ellipse stretched by 1 / cos, most in the picture's corners. There the
/// inner corner of a cell also appears larger by 2 tan times half its diagonal, and the cone
/// extends farther by the same amount.
float reach_beyond(const Camera& camera, const RenderSettings& settings) {
  if (as_published(settings).asos.detect == Detection::square) return 1e-4f;
  const double half_height =
      camera.type == Camera::Type::perspective ? std::tan(0.5 * camera.fov_y_rad) : 0.0;
  const double pixel = 2.0 * half_height / settings.height;
  const double tangent =
      half_height * std::hypot(1.0, static_cast<double>(settings.width) / settings.height);
  const double half = 0.5 * std::sqrt(2.0 + tangent * tangent);
  return static_cast<float>(half * (1.0 + 4.0 * tangent * std::sqrt(0.5) * pixel) - 0.5) + 1e-3f;
}

void check_boundaries(const PixelTrace& trace, float beyond) {
  for (const TracedCell& cell : trace.cells) {
    for (const TracedBoundary& b : cell.boundaries) {
      for (const glm::vec2 end : {b.from, b.to}) {
        const glm::vec2 in = (end - cell.corner) / cell.side;
        EXPECT_TRUE(in.x > -beyond && in.y > -beyond && in.x < 1.0f + beyond &&
                    in.y < 1.0f + beyond)
            << in.x << ", " << in.y;
      }
    }
  }
}

/// Traces every `step`-th pixel, and the last row and column.
void check_picture(const RenderScene& scene, const Camera& camera, const RenderSettings& settings,
                   int step) {
  const View view(camera, settings.width, settings.height);
  const Film film = render(scene, view, settings);
  int split = 0;
  for (int y = 0; y < settings.height; ++y) {
    for (int x = 0; x < settings.width; ++x) {
      const bool last = x + 1 == settings.width || y + 1 == settings.height;
      if (!last && (x + settings.width * y) % step != 0) continue;
      SCOPED_TRACE(testing::Message() << "pixel " << x << "," << y);
      const PixelTrace trace = trace_pixel(scene, view, settings, x, y);
      ASSERT_EQ(std::memcmp(&trace.radiance, &film.radiance[film.index(x, y)], sizeof(glm::vec3)),
                0);
      ASSERT_FALSE(trace.cells.empty());
      check_tree(trace);
      check_samples(trace);
      check_levels(trace);
      check_boundaries(trace, reach_beyond(camera, settings));
      if (testing::Test::HasFailure()) return;
      split += trace.cells.size() > 1;
    }
  }
  EXPECT_GT(split, 0);
}

SharedScene boxes() {
  static const SharedScene scene =
      load_scene("builtin:boxes").and_then([](const Scene& s) { return prepare(s); }).value();
  return scene;
}

// 37 x 21 pixels: the last blocks are not complete.
TEST(PixelTrace, IsWhatRenderingDoes) {
  check_picture(*boxes(), boxes()->world().cameras.at(0), make_settings(37, 21), 7);
}

TEST(PixelTrace, IsWhatRenderingDoesAsPublished) {
  RenderSettings settings = make_settings(37, 21);
  settings.method = Method::asos_published;
  settings.asos.eps = 1.0 / 16.0;
  check_picture(*boxes(), boxes()->world().cameras.at(0), settings, 7);
}

TEST(PixelTrace, IsWhatRenderingDoesWhateverTheFatPyrays) {
  for (const int fat : {2, 4, 16}) {
    RenderSettings settings = make_settings(37, 21);
    settings.asos.fat = fat;
    settings.asos.max_level = 2;
    settings.asos.jitter = true;
    check_picture(*boxes(), boxes()->world().cameras.at(0), settings, 11);
  }
}

TEST(PixelTrace, IsWhatRenderingDoesForOrthographicCameras) {
  const auto scene = make_render_scene(still_life());
  for (const Detection detect : {Detection::square, Detection::cone}) {
    RenderSettings settings = make_settings(33, 26);
    settings.asos.detect = detect;
    check_picture(*scene, orthographic(4.0), settings, 5);
  }
}

// The outline of a cut-out is in its texture: there is no edge, and samples find it.
TEST(PixelTrace, TellsWhatSamplesFound) {
  World world;
  add_quad(world, {-5, -5, -1}, {10, 0, 0}, {0, 10, 0}, unlit({0.2f, 0.4f, 0.8f}));
  Image holes;
  holes.width = holes.height = 8;
  for (int i = 0; i < 64; ++i) {
    const std::uint8_t alpha = (i / 8 + i) % 2 ? 255 : 0;
    holes.rgba.own().insert(holes.rgba.own().end(), {255, 255, 255, alpha});
  }
  Material lattice = unlit({1, 1, 1});
  lattice.alpha_mode = AlphaMode::mask;
  lattice.base_color_texture.texture =
      add_texture(world, std::move(holes), Wrap::clamp_to_edge, Filter::nearest);
  add_quad(world, {-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, lattice);
  leave_cut_outs_to_samples(world);
  const auto scene = make_render_scene(std::move(world));
  const RenderSettings settings = make_settings(24, 24);
  const View view(orthographic(9.0), settings.width, settings.height);
  const Film film = render(*scene, view, settings);
  int sampled = 0;
  for (int y = 0; y < settings.height; ++y) {
    for (int x = 0; x < settings.width; ++x) {
      const PixelTrace trace = trace_pixel(*scene, view, settings, x, y);
      if (trace.cells.front().fate != CellFate::sampled) continue;
      ++sampled;
      ASSERT_EQ(std::memcmp(&trace.radiance, &film.radiance[film.index(x, y)], sizeof(glm::vec3)),
                0);
      check_samples(trace);
      EXPECT_EQ(trace.cells.front().samples.size(), 1u) << "represents all samples of the pixel";
      EXPECT_FALSE(trace.missed);  // there is no edge to miss
    }
  }
  EXPECT_GT(sampled, 0);
}

// A pixel that a corner cuts into three once had fewer rays than samples.
TEST(PixelTrace, HasARayForEachSample) {
  World world;
  add_quad(world, {-5, -5, -1}, {10, 0, 0}, {0, 10, 0}, unlit({0.2f, 0.4f, 0.8f}));
  add_quad(world, {-1.2f, -1.1f, 0}, {2, 0.3f, 0}, {-0.4f, 2, 0}, unlit({1, 1, 1}));
  add_quad(world, {0.3f, 0.4f, 1}, {1, -0.3f, 0}, {0.4f, 1, 0}, unlit({1, 0, 0}));
  const auto scene = make_render_scene(std::move(world));
  const RenderSettings settings = make_settings(16, 16);
  const View view(orthographic(4.0), settings.width, settings.height);
  const Film film = render(*scene, view, settings);
  std::size_t most = 0;
  for (int y = 0; y < settings.height; ++y) {
    for (int x = 0; x < settings.width; ++x) {
      const PixelTrace trace = trace_pixel(*scene, view, settings, x, y);
      std::size_t samples = 0;
      for (const TracedCell& cell : trace.cells) samples += cell.samples.size();
      EXPECT_GE(film.rays[film.index(x, y)], static_cast<float>(samples)) << x << ", " << y;
      most = std::max(most, samples);
    }
  }
  EXPECT_GE(most, 3u) << "some pixel is cut in three";
}

// Two intersecting planes, with the edges of a world in which they do not intersect.
TEST(PixelTrace, SaysWhereABoundaryWasMissed) {
  const auto world = [](float height) {
    World w;
    add_quad(w, {-50, -50, 0}, {100, 0, 0}, {0, 100, 0}, unlit({1, 1, 1}));
    add_quad(w, {-50, -50, height - 5.03f}, {100, 0, 10}, {0, 100, 0}, unlit({0, 0, 0}));
    return w;
  };
  const auto geometry = make_geometry(world(0));
  geometry->boundaries.set(FeatureSet(world(1000)));
  const auto scene = unedited_scene(geometry, {});
  const RenderSettings settings = make_settings(16, 16);
  const View view(orthographic(4.0), settings.width, settings.height);
  RenderStatistics statistics;
  for (int y = 0; y < 16; y += block_size)
    for (int x = 0; x < 16; x += block_size)
      statistics += render_block(*scene, view, settings, {x, y, block_size, block_size}).statistics;
  std::uint64_t missed = 0;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const PixelTrace trace = trace_pixel(*scene, view, settings, x, y);
      missed += trace.missed;
      EXPECT_EQ(trace.missed, trace.cells.front().fate == CellFate::by_samples);
    }
  }
  EXPECT_GT(missed, 0u);
  EXPECT_EQ(missed, statistics.missed_splits);
}

// Polished boxes under a sphere light: each leaf starts pyrays to the light and in the mirror
// direction.
TEST(PixelTrace, TellsThePyraysThatItsLeavesSendOn) {
  std::shared_ptr<const RenderScene> scene;
  for (const BuiltinScene& builtin : builtin_scenes()) {
    if (builtin.name != "boxes") continue;
    Scene polished = builtin.make();
    for (Material& material : polished.materials) {
      material.metallic = 0.0f;
      material.roughness = 0.0f;
    }
    const Light ball = make_bulb({1, 4, 3}, 40.0f, 0.5);
    polished.lights = {ball};
    scene = prepare(polished).value();
  }
  ASSERT_NE(scene, nullptr);
  RenderSettings settings = make_settings(8, 6);
  // A tolerance so small that penumbrae are split and not sampled.
  settings.asos.max_level = 5;
  settings.asos.eps = 0.0;
  const View view(scene->world().cameras.front(), settings.width, settings.height,
                  radius_around_origin(scene->world().bounds));
  const Film film = render(*scene, view, settings);
  int shadows = 0, mirrors = 0, nested = 0, partly_lit = 0;
  for (int y = 0; y < settings.height; ++y) {
    for (int x = 0; x < settings.width; ++x) {
      const PixelTrace trace = trace_pixel(*scene, view, settings, x, y);
      ASSERT_EQ(std::memcmp(&trace.radiance, &film.radiance[film.index(x, y)], sizeof(glm::vec3)),
                0)
          << "tracing does not change the result";
      for (int i = 0; i < static_cast<int>(trace.pyrays.size()); ++i) {
        const TracedPyray& pyray = trace.pyrays[static_cast<std::size_t>(i)];
        ASSERT_LT(pyray.parent, i);
        nested += pyray.parent >= 0;
        ASSERT_FALSE(pyray.cells.empty());
        double area = 0.0;
        for (const TracedCell& cell : pyray.cells)
          for (const TracedSample& sample : cell.samples) area += sample.weight;
        EXPECT_NEAR(area, 1.0, 1e-5);
        EXPECT_GE(std::min(pyray.from.x, pyray.from.y), -1e-3f);
        EXPECT_LE(std::max(pyray.from.x, pyray.from.y), 1.001f);
        if (pyray.kind == TracedPyray::Kind::mirror) {
          ++mirrors;
          continue;
        }
        ++shadows;
        EXPECT_LT(pyray.light, scene->lights().size());
        partly_lit += pyray.result.x > 0.01f && pyray.result.x < 0.99f;
        for (const TracedCell& cell : pyray.cells)
          for (const TracedSample& sample : cell.samples)
            EXPECT_TRUE(sample.radiance.x >= 0.0f && sample.radiance.x <= 1.0f);
      }
    }
  }
  EXPECT_GT(shadows, 0);
  EXPECT_GT(mirrors, 0);
  EXPECT_GT(nested, 0) << "reflected surfaces have shadows, too";
  EXPECT_GT(partly_lit, 0) << "a penumbra";
}

}  // namespace
}  // namespace asos::test::pixel_trace_test
