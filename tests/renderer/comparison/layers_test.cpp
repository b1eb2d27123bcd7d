#include "renderer/film/layers.h"

#include "renderer/gltf/load.h"
#include "renderer/pyray/error_budget.h"
#include "renderer/shading/sky.h"
#include "tests/renderer/comparison/rival_scenes.h"
#include "tests/support/polygon.h"
#include "tests/support/shape_world.h"
#include "tests/support/shared_dir.h"
#include "tests/support/textured_scene.h"
#include "tests/support/tiny_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

// Layers against closed forms. MAX 3 throughout.

namespace asos::test::layers_test {
namespace {

RenderSettings with_layers(Method method = Method::asos, int spp = 16) {
  RenderSettings settings = settings_for(method, spp);
  settings.asos.max_level = 3;
  settings.layers = LayerSet::all();
  return settings;
}

double share_of(const IdShares& shares, std::uint32_t id) {
  const auto found =
      std::find_if(shares.begin(), shares.end(), [&](const IdShare& s) { return s.id == id; });
  return found == shares.end() ? 0.0 : static_cast<double>(found->share);
}

const LayerPlane& plane(const BlockResult& result, Layer layer) {
  const LayerPlane* found = find_plane(result.tile.layers, layer);
  EXPECT_NE(found, nullptr) << row_of(layer).name;
  return *found;
}

void expect_shares_add_up(const BlockResult& result) {
  for (const Layer layer : {Layer::object, Layer::material})
    for (const IdShares& shares : plane(result, layer).ids) {
      double sum = 0.0;
      for (const IdShare& share : shares) sum += static_cast<double>(share.share);
      EXPECT_NEAR(sum, 1.0, 1e-6);
    }
}

Polygon pixel_square(int x, int y) {
  return {{x, y}, {x + 1.0, y}, {x + 1.0, y + 1.0}, {x, y + 1.0}};
}

/// The area of a pixel where both lines are positive.
template <typename A, typename B>
double area_between(int x, int y, const A& a, const B& b) {
  const Polygon first = clip(pixel_square(x, y), a);
  if (first.size() < 3) return 0.0;
  const Polygon both = clip(first, b);
  return both.size() < 3 ? 0.0 : area(both);
}

glm::vec3 at(double x, double y, double z = 0.0) {
  return glm::vec3(glm::dvec3(x - 4.0, 4.0 - y, z));
}

// Below the line y = 3.21 + 0.37 x lies object 0; above it nothing.
TEST(Layers, HalfPlaneIsCoveredExactly) {
  World world;
  add_triangle(world, at(-90.0, 3.21 - 90.0 * 0.37), at(0.0, 300.0), at(90.0, 3.21 + 90.0 * 0.37),
               matte(glm::vec3(0.5f)));
  const auto scene = make_render_scene(std::move(world));
  const BlockResult result = render_small(*scene, with_layers());
  const auto below = [](glm::dvec2 p) { return p.y - 3.21 - 0.37 * p.x; };
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const auto i = static_cast<std::size_t>(8 * y + x);
      const double covered = area_between(x, y, below, [](glm::dvec2) { return 1.0; });
      EXPECT_NEAR(share_of(plane(result, Layer::object).ids[i], 0), covered, 1e-4);
      EXPECT_NEAR(share_of(plane(result, Layer::material).ids[i], no_id), 1.0 - covered, 1e-4);
      EXPECT_NEAR(plane(result, Layer::alpha).at(i)[0], covered, 1e-4);
      EXPECT_NEAR(plane(result, Layer::albedo).at(i)[1], 0.5 * covered, 1e-4);
      EXPECT_NEAR(plane(result, Layer::normal).at(i)[2], covered, 1e-4) << "faces the camera";
    }
  expect_shares_add_up(result);
}

// A sliver 0.013 pixels wide: thinner than a cell at MAX 3.
TEST(Layers, SliverIsCoveredExactly) {
  World world;
  const double slope = 0.29, width = 0.013;
  add_part(world,
           {{at(-1.0, 2.4 - slope), {0, 0, 1}, {0, 0}},
            {at(9.0, 2.4 + 9.0 * slope), {0, 0, 1}, {1, 0}},
            {at(9.0, 2.4 + width + 9.0 * slope), {0, 0, 1}, {1, 1}},
            {at(-1.0, 2.4 + width - slope), {0, 0, 1}, {0, 1}}},
           {{0, 2, 1}, {0, 3, 2}}, unlit(glm::vec3(1.0f)));
  const auto scene = make_render_scene(std::move(world));
  const BlockResult result = render_small(*scene, with_layers());
  const auto top = [&](glm::dvec2 p) { return p.y - 2.4 - slope * p.x; };
  const auto bottom = [&](glm::dvec2 p) { return 2.4 + width + slope * p.x - p.y; };
  double all = 0.0;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const auto i = static_cast<std::size_t>(8 * y + x);
      const double seen = share_of(plane(result, Layer::object).ids[i], 0);
      EXPECT_NEAR(seen, area_between(x, y, top, bottom), 1e-4) << x << ", " << y;
      EXPECT_NEAR(plane(result, Layer::alpha).at(i)[0], seen, 1e-6);
      all += seen;
    }
  EXPECT_NEAR(all, 8.0 * width, 1e-4);
  expect_shares_add_up(result);
}

TEST(Layers, DiskCoversItsArea) {
  World world;
  const glm::dmat4 facing{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0.3, -0.2, 0, 1}};
  Material white = unlit(glm::vec3(1.0f));
  white.double_sided = true;
  add_shape(world, disk(2.5), facing, white);
  const auto scene = make_render_scene(std::move(world));
  const BlockResult result = render_small(*scene, with_layers());
  constexpr int n = 400;  // strips of each pixel
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      double covered = 0.0;
      for (int k = 0; k < n; ++k) {
        const double v = 4.2 - (y + (k + 0.5) / n);  // from the centre
        const double half = std::sqrt(std::max(0.0, 2.5 * 2.5 - v * v));
        const double from = std::max(x - 4.3, -half), to = std::min(x - 3.3, half);
        covered += std::max(0.0, to - from) / n;
      }
      const auto i = static_cast<std::size_t>(8 * y + x);
      EXPECT_NEAR(share_of(plane(result, Layer::object).ids[i], 0), covered, 2e-4)
          << x << ", " << y;
    }
  expect_shares_add_up(result);
}

// A half-plane before another one, whose lines cross within pixels.
TEST(Layers, TwoLayersHideEachOtherExactly) {
  World world;
  add_triangle(world, at(-90.0, 2.3 - 90.0 * 0.21), at(0.0, 300.0), at(90.0, 2.3 + 90.0 * 0.21),
               matte(glm::vec3(0.5f)));
  add_triangle(world, at(4.55 - 90.0 * 0.13, -90.0, 2.0), at(-300.0, 0.0, 2.0),
               at(4.55 + 90.0 * 0.13, 90.0, 2.0), matte(glm::vec3(0.1f)));
  const auto scene = make_render_scene(std::move(world));
  const auto below = [](glm::dvec2 p) { return p.y - 2.3 - 0.21 * p.x; };
  const auto left = [](glm::dvec2 p) { return 4.55 + 0.13 * p.y - p.x; };
  const auto right = [&](glm::dvec2 p) { return -left(p); };
  const BlockResult result = render_small(*scene, with_layers());
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const auto i = static_cast<std::size_t>(8 * y + x);
      const IdShares& seen = plane(result, Layer::object).ids[i];
      EXPECT_NEAR(share_of(seen, 1), area_between(x, y, left, left), 1e-4) << x << ", " << y;
      EXPECT_NEAR(share_of(seen, 0), area_between(x, y, below, right), 1e-4) << x << ", " << y;
      // The camera is 10 above the plane z = 0.
      const float depth = plane(result, Layer::depth).at(i)[0];
      const bool front = share_of(seen, 1) > 0.0, back = share_of(seen, 0) > 0.0;
      if (front)
        EXPECT_NEAR(depth, 8.0f, 1e-5f);
      else if (back)
        EXPECT_NEAR(depth, 10.0f, 1e-5f);
      else
        EXPECT_TRUE(std::isinf(depth));
    }
  expect_shares_add_up(result);
}

// Samplers count samples, so their fractions differ from the areas by noise.
TEST(Layers, SamplersCount) {
  World world;
  add_triangle(world, at(-90.0, 3.21 - 90.0 * 0.37), at(0.0, 300.0), at(90.0, 3.21 + 90.0 * 0.37),
               matte(glm::vec3(0.5f)));
  const auto scene = make_render_scene(std::move(world));
  const BlockResult exact = render_small(*scene, with_layers());
  for (const Method method : {Method::uniform, Method::stochastic, Method::sobol}) {
    const BlockResult counted = render_small(*scene, with_layers(method, 256));
    double most = 0.0;
    for (std::size_t i = 0; i < 64; ++i) {
      const double share = share_of(plane(counted, Layer::object).ids[i], 0);
      EXPECT_EQ(std::round(256.0 * share), 256.0 * share) << "whole samples";
      most = std::max(most, std::abs(share - share_of(plane(exact, Layer::object).ids[i], 0)));
    }
    EXPECT_LT(most, 2.0 / 16.0);
    EXPECT_GT(most, 1e-5);
    expect_shares_add_up(counted);
  }
}

TEST(Layers, BeautyIsTheSameBits) {
  const FlattenedScene still = still_life();
  const auto scene = make_render_scene(still);
  const View view(look_at({1, 2, 5}, {0, 0.6, 0}, 0.7), 32, 32);
  for (const Method method : {Method::asos, Method::asos_published, Method::sobol,
                              Method::sobol_adaptive, Method::whitted, Method::mitchell}) {
    RenderSettings settings = settings_for(method, 8, 32);
    const PixelRect rect{8, 8, 16, 16};
    const BlockResult plain = render_block(*scene, view, settings, rect);
    EXPECT_TRUE(plain.tile.layers.empty()) << "nothing that nobody asked for";
    settings.layers = LayerSet::all();
    const BlockResult layered = render_block(*scene, view, settings, rect);
    EXPECT_EQ(plain.tile.radiance, layered.tile.radiance);
    EXPECT_EQ(plain.tile.split_level, layered.tile.split_level);
    EXPECT_EQ(plain.tile.cause, layered.tile.cause);
    EXPECT_EQ(layered.tile.layers.size(), 16u);
  }
}

// Methods with other weights of their samples than one each.
TEST(Layers, EveryMethodOfSamplesWeighsThemAsItsPicture) {
  World world;
  add_card(world, {-9, -9}, {4.37f, 17}, unlit(glm::vec3(1.0f)));
  const auto scene = make_render_scene(std::move(world));
  for (const Method method : {Method::sobol_adaptive, Method::whitted, Method::mitchell,
                              Method::ray_bound, Method::average}) {
    RenderSettings settings = with_layers(method, 16);
    settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
    const BlockResult result = render_small(*scene, settings);
    double parts = 0.0;
    for (std::size_t i = 0; i < 64; ++i) {
      const auto white = static_cast<double>(result.tile.radiance[i].x);
      EXPECT_NEAR(plane(result, Layer::alpha).at(i)[0], white, 1e-6) << row_of(method).name;
      EXPECT_NEAR(share_of(plane(result, Layer::object).ids[i], 0), white, 1e-6);
      EXPECT_NEAR(plane(result, Layer::emission).at(i)[0], white, 1e-6);
      parts += white > 0.0 && white < 1.0;
    }
    EXPECT_GE(parts, 8.0) << "an edge is seen";
    expect_shares_add_up(result);
  }
}

// A blended card hides by its opacity, in alpha as in the coverage of its id.
TEST(Layers, AlphaOfBlendedSurfacesIsTheirOpacity) {
  World world;
  add_card(world, {-9, -9}, {4, 17}, unlit(glm::vec3(0.5f), 0.25f), 1.0f);
  const auto scene = make_render_scene(std::move(world));
  for (const Method method : {Method::asos, Method::sobol}) {
    const BlockResult result = render_small(*scene, with_layers(method));
    EXPECT_NEAR(plane(result, Layer::alpha).at(8 * 3 + 2)[0], 0.25f, 1e-6f);
    EXPECT_NEAR(share_of(plane(result, Layer::object).ids[8 * 3 + 2], 0), 0.25, 1e-6);
    EXPECT_NEAR(share_of(plane(result, Layer::object).ids[8 * 3 + 2], no_id), 0.75, 1e-6);
    EXPECT_EQ(plane(result, Layer::alpha).at(8 * 3 + 6)[0], 0.0f);
    expect_shares_add_up(result);
  }
}

// Cards of opacity 1/4 and 1/2, and a wall behind the left half: 0.25, 0.75 * 0.5 and the rest.
TEST(Layers, CoveragesOfBlendedSurfacesAreWeightedFromFrontToBack) {
  World world;
  add_card(world, {-9, -9}, {17, 17}, unlit(glm::vec3(0.5f), 0.25f), 2.0f);
  add_card(world, {-9, -9}, {17, 17}, unlit(glm::vec3(0.5f), 0.5f), 1.0f);
  add_card(world, {-9, -9}, {4, 17}, unlit(glm::vec3(0.5f)));
  const auto scene = make_render_scene(std::move(world));
  for (const Method method : {Method::asos, Method::sobol, Method::whitted}) {
    const BlockResult result = render_small(*scene, with_layers(method));
    for (const Layer layer : {Layer::object, Layer::material}) {
      const IdShares& left = plane(result, layer).ids[8 * 3 + 2];
      EXPECT_NEAR(share_of(left, 0), 0.25, 1e-6);
      EXPECT_NEAR(share_of(left, 1), 0.375, 1e-6);
      EXPECT_NEAR(share_of(left, 2), 0.375, 1e-6);
      const IdShares& right = plane(result, layer).ids[8 * 3 + 6];
      EXPECT_NEAR(share_of(right, 0) + share_of(right, 1), 0.625, 1e-6);
    }
    EXPECT_NEAR(plane(result, Layer::alpha).at(8 * 3 + 2)[0], 1.0f, 1e-6f);
    EXPECT_NEAR(plane(result, Layer::alpha).at(8 * 3 + 6)[0], 0.625f, 1e-6f);
    EXPECT_NEAR(plane(result, Layer::depth).at(8 * 3 + 2)[0], 8.0f, 1e-5f) << "the first counts";
    expect_shares_add_up(result);
  }
}

// A card of opacity 0 before the left half of a wall: the wall owns all layers there, too.
TEST(Layers, SurfacesOfOpacityZeroAreNotThere) {
  for (const bool by_texture : {false, true}) {
    World world;
    Material card = unlit(glm::vec3(0.02f, 0.35f, 0.05f), by_texture ? 1.0f : 0.0f);
    card.alpha_mode = AlphaMode::blend;
    if (by_texture)
      card.base_color_texture.texture = add_texture(world,
                                                    make_image(2, 2,
                                                               [](int, int) {
                                                                 return Texel{255, 255, 255, 0};
                                                               }),
                                                    Wrap::repeat, Filter::nearest);
    add_card(world, {-9, -9}, {4, 17}, card, 1.0f);
    add_card(world, {-9, -9}, {17, 17}, unlit({0.9f, 0.3f, 0.3f}));
    const auto scene = make_textured_scene(std::move(world));
    for (const Method method : {Method::asos, Method::sobol}) {
      const BlockResult result = render_small(*scene, with_layers(method));
      for (const int x : {2, 6}) {
        const auto i = static_cast<std::size_t>(8 * 3 + x);
        EXPECT_EQ(share_of(plane(result, Layer::object).ids[i], 1), 1.0) << x;
        EXPECT_EQ(share_of(plane(result, Layer::material).ids[i], 1), 1.0) << x;
        EXPECT_NEAR(plane(result, Layer::depth).at(i)[0], 10.0f, 1e-5f) << x;
        EXPECT_NEAR(plane(result, Layer::position).at(i)[2], 0.0f, 1e-5f) << x;
        EXPECT_NEAR(plane(result, Layer::albedo).at(i)[0], 0.9f, 1e-5f) << x;
        EXPECT_NEAR(plane(result, Layer::alpha).at(i)[0], 1.0f, 1e-6f) << x;
      }
    }
  }
}

// Positions are in the author's coordinates, however the world is recentred.
TEST(Layers, PositionAndDistanceArePlaces) {
  World world;
  add_card(world, {-9, -9}, {17, 17}, matte(glm::vec3(0.5f)), 1.5f);
  world.origin = {100.0, 200.0, 300.0};
  const auto scene = make_render_scene(std::move(world));
  for (const Method method : {Method::asos, Method::uniform}) {
    const BlockResult result = render_small(*scene, with_layers(method, 1));
    const auto position = plane(result, Layer::position).at(8 * 2 + 5);
    EXPECT_NEAR(position[0], 101.5f, 1e-4f);
    EXPECT_NEAR(position[1], 201.5f, 1e-4f);
    EXPECT_NEAR(position[2], 301.5f, 1e-4f);
    EXPECT_NEAR(plane(result, Layer::distance).at(8 * 2 + 5)[0], 8.5f, 1e-5f);
    EXPECT_NEAR(plane(result, Layer::uv).at(8 * 2 + 5)[0], 14.5f / 26.0f, 1e-5f);
  }
}

// Sobol samples differ from a coverage by about 0.35 n^-3/4: 7e-4 for the 4096 here, and 5.5e-3 for
// the 256 that ASOS takes in pixels with many edges.
TEST(Layers, AgreeWithManySamplesOnModels) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << "the shared folder is missing";
  for (const auto& [name, noise] : {std::pair{"Box/Box.glb", 7e-4},
                                    std::pair{"NegativeScaleTest/NegativeScaleTest.glb", 5.5e-3},
                                    std::pair{"VertexColorTest/VertexColorTest.glb", 5.5e-3}}) {
    const auto path = *shared / "scenes" / name;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << name;
    const auto scene = with_boundaries(prepare(load_scene(path.string()).value()).value()).value();
    const Camera camera = first_camera(scene->world(), 1.0);
    RenderSettings settings = settings_for(Method::asos, 4096, 12);
    settings.layers = {Layer::object, Layer::material, Layer::alpha};
    settings.shadow.cast = false;
    const Film exact = render_picture(*scene, camera, settings).film;
    settings.method = Method::sobol;
    const Film counted = render_picture(*scene, camera, settings).film;
    double sum = 0.0, most = 0.0;
    for (std::size_t i = 0; i < exact.radiance.size(); ++i)
      for (const Layer layer : {Layer::object, Layer::material})
        for (const IdShare& share : find_plane(exact.layers, layer)->ids[i]) {
          const double off = static_cast<double>(share.share) -
                             share_of(find_plane(counted.layers, layer)->ids[i], share.id);
          sum += off * off;
          most = std::max(most, std::abs(off));
        }
    EXPECT_LT(most, 4.0 * noise) << name;
    EXPECT_LT(std::sqrt(sum / static_cast<double>(2 * exact.radiance.size())), noise) << name;
    EXPECT_GT(most, 0.0) << name << ": edges are seen";
  }
}

// A picture with an edge, a shadow and smooth shading: at most 5 % of the pixels have an error
// above twice the estimate, and the mean estimate exceeds the mean error by less than
// ErrorBudget::invisible.
TEST(Layers, ErrorEstimateIsOfTheErrorsSize) {
  const auto scene = make_render_scene(still_life());
  const Camera camera = look_at({1, 2, 5}, {0, 0.6, 0}, 0.7);
  RenderSettings settings = settings_for(Method::asos, 4096, 24);
  settings.layers = {Layer::error};
  const Film film = render_picture(*scene, camera, settings).film;
  settings.method = Method::sobol;
  const Film reference = render_picture(*scene, camera, settings).film;
  double estimated = 0.0, found = 0.0;
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    const glm::vec3 off = glm::abs(glm::min(film.radiance[i], glm::vec3(1.0f)) -
                                   glm::min(reference.radiance[i], glm::vec3(1.0f)));
    const double error = static_cast<double>(std::max({off.x, off.y, off.z}));
    const double estimate = static_cast<double>(find_plane(film.layers, Layer::error)->at(i)[0]);
    EXPECT_GT(estimate, 0.0);
    estimated += estimate;
    found += error;
    beyond += error > 2.0 * estimate;
  }
  const auto pixels = static_cast<double>(film.radiance.size());
  EXPECT_LT(static_cast<double>(beyond), 0.05 * pixels);
  EXPECT_LT(estimated / pixels, found / pixels + ErrorBudget::invisible);
  EXPECT_GT(estimated, 0.5 * found);
}

TEST(Layers, MethodsWithoutThemSaySo) {
  const auto scene = make_render_scene(two_colours(4.0f, {1, 0, 0}, {0, 1, 0}));
  RenderSettings settings = with_layers(Method::beam);
  const auto checked = check_method(*scene, settings);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().subject, "layers");
  EXPECT_NE(checked.error().reason.find("asos, asos-published, uniform"), std::string::npos);
  settings.layers = {Layer::rays};
  EXPECT_TRUE(check_method(*scene, settings)) << "which every method has";
}

}  // namespace
}  // namespace asos::test::layers_test
