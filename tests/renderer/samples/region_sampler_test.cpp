#include "renderer/samples/region_sampler.h"

#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/sample_lights.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <stop_token>
#include <utility>

namespace asos::test::region_sampler_test {
namespace {

RegionSampler::Goal goal_of(double standard_error, std::uint32_t most, std::uint32_t least = 16,
                            double share = 0.0) {
  RegionSampler::Goal goal;
  goal.standard_error = standard_error;
  goal.most = most;
  goal.least = least;
  goal.share = share;
  return goal;
}

Material glowing(glm::vec3 color) {
  Material material = matte(color);
  material.unlit = true;
  material.double_sided = true;
  return material;
}

/// A wall across the view of 8x8 pixels, 8 units wide: red left of x = 0.3, green right of it.
class TwoColours : public testing::Test {
 protected:
  TwoColours() { show({1, 0, 0}, {0, 1, 0}); }

  void show(glm::vec3 left, glm::vec3 right) {
    World world;
    add_quad(world, {-50, -50, 0}, {50.3f, 0, 0}, {0, 100, 0}, glowing(left));
    add_quad(world, {0.3f, -50, 0}, {50, 0, 0}, {0, 100, 0}, glowing(right));
    show(std::move(world));
  }

  /// A strip on black, starting at x = 0.3.
  void show_strip(float width, glm::vec3 color) {
    World world;
    add_quad(world, {-50, -50, 0}, {50.3f, 0, 0}, {0, 100, 0}, glowing(glm::vec3(0.0f)));
    add_quad(world, {0.3f, -50, 0}, {width, 0, 0}, {0, 100, 0}, glowing(color));
    add_quad(world, {0.3f + width, -50, 0}, {50, 0, 0}, {0, 100, 0}, glowing(glm::vec3(0.0f)));
    show(std::move(world));
  }

  void show(World world) {
    scene_ = make_render_scene(std::move(world));
    settings_.width = settings_.height = 8;
    Camera camera = look_at({0, 0, 4}, {0, 0, 0}, 2.0 * std::atan(1.0));
    view_.emplace(camera, 8, 8);
    shader_.emplace(shader_of(*scene_, settings_, *view_));
    viewer_.emplace(ViewContext::camera(*view_, *shader_));
  }

  [[nodiscard]] RegionSampler::Mean sample(const LeafRegion& region,
                                           const RegionSampler::Goal& goal) {
    RegionSampler sampler(*scene_, *viewer_, settings_, {0, 0, 8, 8}, settings_.seed);
    return sampler.sample(region, goal, counts_);
  }

  std::shared_ptr<const RenderScene> scene_;
  RenderSettings settings_;
  std::optional<View> view_;
  std::optional<Shader> shader_;
  std::optional<ViewContext> viewer_;
  RenderStatistics counts_;
};

// The pixel in column 4 covers x from 0 to 1.
constexpr Square crossed{4.0f / 8.0f, 3.0f / 8.0f, 1.0f / 8.0f};

TEST_F(TwoColours, MeanMatchesTheAreas) {
  const auto found = sample({crossed, {}}, goal_of(-1.0, 1024));
  EXPECT_EQ(found.cost, 1024.0);
  // A net of 1024 points has 32 columns of 32 points; the line crosses one column.
  EXPECT_NEAR(found.value.x, 0.3, 1.0 / 32.0);
  EXPECT_NEAR(found.value.x + found.value.y, 1.0, 1e-6);
  EXPECT_EQ(counts_.eye_rays, 1024u);
}

TEST_F(TwoColours, StopOnceTheGoalIsMet) {
  const auto even = sample({{0.0f, 0.0f, 1.0f / 8.0f}, {}}, goal_of(1e-3, 1024));
  EXPECT_EQ(even.cost, 16.0);
  EXPECT_EQ(even.value.x, 1.0);
  const auto rough = sample({crossed, {}}, goal_of(0.05, 1024));
  const auto fine = sample({crossed, {}}, goal_of(0.005, 1024));
  EXPECT_LT(rough.cost, fine.cost);
  const auto allowed = [](double goal, const RegionSampler::Mean& found) {
    return goal * std::sqrt(found.cost / 16.0);
  };
  EXPECT_LE(rough.error, allowed(0.05, rough));
  EXPECT_LE(fine.error, allowed(0.005, fine));
  EXPECT_NEAR(rough.value.x, 0.3, 3.0 * 0.05);
  EXPECT_NEAR(fine.value.x, 0.3, 3.0 * 0.005);
}

// A bright strip of a twentieth of the pixel: each sample that hits it changes the mean noticeably.
TEST_F(TwoColours, SamplingContinuesForLargeErrors) {
  show_strip(0.05f, glm::vec3(60.0f));
  const auto few = sample({crossed, {}}, goal_of(0.004, 512, 64));
  const auto many = sample({crossed, {}}, goal_of(0.004, 4096, 64));
  EXPECT_EQ(few.cost, 512.0);
  EXPECT_EQ(many.cost, 4096.0);
  EXPECT_LT(std::abs(many.value.x - 3.0), 0.03);
  EXPECT_GT(many.error, 0.0);
  EXPECT_LT(many.error, 0.5 * few.error) << "estimated from all samples";
  // The error allowed grows with the sample count (Neyman allocation): more samples are better
  // spent elsewhere.
  const double goal = few.error / std::sqrt(512.0 / 64.0);
  EXPECT_EQ(sample({crossed, {}}, goal_of(1.01 * goal, 4096, 64)).cost, 512.0);
  EXPECT_GT(sample({crossed, {}}, goal_of(0.99 * goal, 4096, 64)).cost, 512.0);
}

// Variance that a few samples all miss is likely next to a pixel whose samples found it.
TEST_F(TwoColours, SamplingContinuesNextToNoise) {
  show_strip(0.1f, glm::vec3(60.0f));
  RegionSampler::Goal goal = goal_of(0.02, 1024);
  goal.share = 1.0;
  // Number of samples of a black pixel that is `columns` to the left of the strip's pixel.
  const auto samples_of = [&](float columns) {
    const Square black{crossed.u - columns * crossed.side, crossed.v, crossed.side};
    RegionSampler sampler(*scene_, *viewer_, settings_, {0, 0, 8, 8}, settings_.seed);
    sampler.add({black, {}}, goal);
    sampler.add({crossed, {}}, goal);
    return sampler.run(counts_).front().cost;
  };
  EXPECT_EQ(samples_of(2.0f), 16u);
  EXPECT_GT(samples_of(1.0f), 64u);
  // A region that is a small part of its pixel says nothing about others.
  goal.share = 0.25;
  EXPECT_EQ(samples_of(1.0f), 16u);
}

// Samples that agree by chance may stop too early; this has to be rare.
TEST_F(TwoColours, EstimatesMeetTheGoal) {
  constexpr double goal = 0.02;
  constexpr int squares = 512;
  constexpr float side = 1.0f / 64.0f, edge = 4.3f / 8.0f;
  double sum = 0.0;
  int far_off = 0;
  for (int i = 0; i < squares; ++i) {
    const float red = (static_cast<float>(i) + 0.5f) / squares;
    const float v = static_cast<float>(i * 37 % 512) / 540.0f;
    const auto found = sample({{edge - red * side, v, side}, {}}, {goal, 1024});
    // The error allowed grows with the sample count.
    const double allowed = goal * std::sqrt(found.cost / 16.0);
    const double off = (found.value.x - static_cast<double>(red)) / allowed;
    sum += off * off;
    far_off += std::abs(off) > 2.0;
  }
  EXPECT_LT(std::sqrt(sum / squares), 0.55);
  EXPECT_LE(far_off, 4);
}

// A blurred reflection has more weight at its centre, also within a part that an edge leaves of a
// square.
TEST_F(TwoColours, SamplesFollowTheKernel) {
  const BlurKernel kernel({0.4, 0.4});
  const Square all{0.0f, 0.0f, 1.0f};
  const float edge = 4.3f / 8.0f;  // where red ends
  const auto rectangle = [](float u0, float u1) {
    return std::array<BorderEdge, 4>{
        {{{u0, 0}, {u1, 0}}, {{u1, 0}, {u1, 1}}, {{u1, 1}, {u0, 1}}, {{u0, 1}, {u0, 0}}}};
  };
  for (const float u1 : {1.0f, 0.7f}) {
    const auto border = rectangle(0.05f, u1), red = rectangle(0.05f, edge);
    const double expected = kernel.integral({all, red}) / kernel.integral({all, border});
    ASSERT_GT(std::abs(expected - (edge - 0.05) / (u1 - 0.05)), 0.02)
        << "differs from a uniform kernel";
    RegionSampler sampler(*scene_, *viewer_, settings_, {0, 0, 8, 8}, settings_.seed);
    const auto found = sampler.sample({all, border}, goal_of(-1.0, 4096), counts_, &kernel);
    EXPECT_NEAR(found.value.x, expected, 1.0 / 64.0) << u1;
  }
  const double squared = kernel.integral({all, rectangle(0.0f, edge)});
  RegionSampler sampler(*scene_, *viewer_, settings_, {0, 0, 8, 8}, settings_.seed);
  EXPECT_NEAR(sampler.sample({all, {}}, goal_of(-1.0, 4096), counts_, &kernel).value.x, squared,
              1.0 / 64.0);
}

// A change of settings need not wait for a block of samples.
TEST_F(TwoColours, SamplingStopsOnRequest) {
  std::stop_source stop;
  RegionSampler sampler(*scene_, *viewer_, settings_, {0, 0, 8, 8}, settings_.seed, nullptr,
                        stop.get_token());
  const RegionSampler::Goal all = goal_of(-1.0, 1u << 20, 1u << 20);
  stop.request_stop();
  EXPECT_EQ(sampler.sample({crossed, {}}, all, counts_).cost, 0.0);
  EXPECT_EQ(counts_.eye_rays, 0u);
}

// Values above white have the same relative error as white; a value is weighted by its region's
// fraction of the pixel.
TEST_F(TwoColours, GoalIsRelativeAboveWhite) {
  show(glm::vec3(3), glm::vec3(2.5));
  const auto error_of = [&](double share) {
    return sample({crossed, {}}, goal_of(-1.0, 16, 16, share));
  };
  const auto part = error_of(0.1), pixel = error_of(1.0), half = error_of(0.5);
  ASSERT_GT(part.error, 0.01);
  ASSERT_GT(part.value.x, 2.0);
  EXPECT_NEAR(pixel.error, part.error / part.value.x, 1e-9);
  EXPECT_NEAR(half.error, part.error / (0.5 * part.value.x), 1e-9);
}

TEST_F(TwoColours, OnlySamplesInTheRegionCount) {
  // The part of the crossed pixel that is left of the seam, minus a tiny margin.
  const float u0 = crossed.u, u1 = crossed.u + 0.299f * crossed.side;
  const float v0 = crossed.v, v1 = crossed.v + crossed.side;
  const std::array<BorderEdge, 4> sides = {BorderEdge{{u0, v0}, {u1, v0}},
                                           {{u1, v0}, {u1, v1}},
                                           {{u1, v1}, {u0, v1}},
                                           {{u0, v1}, {u0, v0}}};
  const auto found = sample({crossed, sides}, goal_of(-1.0, 256));
  EXPECT_EQ(found.value.x, 1.0);
  EXPECT_EQ(found.value.y, 0.0);
  EXPECT_EQ(found.cost, 256.0);
}

// Samples are spread over the bounding rectangle; a thin region covers a small part of it.
TEST_F(TwoColours, ThinRegionsGetAsManySamples) {
  // A strip from corner to corner of a red pixel, an eleventh of its area.
  const Square pixel{1.0f / 8.0f, 3.0f / 8.0f, 1.0f / 8.0f};
  const auto at = [&](float u, float v) {
    return glm::vec2(pixel.u, pixel.v) + pixel.side * glm::vec2(u, v);
  };
  const std::array<BorderEdge, 4> sides = {BorderEdge{at(0, 0), at(0.1f, 0)},
                                           {at(0.1f, 0), at(1, 1)},
                                           {at(1, 1), at(0.9f, 1)},
                                           {at(0.9f, 1), at(0, 0)}};
  const auto all = sample({pixel, sides}, goal_of(-1.0, 256));
  EXPECT_GT(all.cost, 128.0);
  EXPECT_LT(all.cost, 512.0);
  const auto even = sample({pixel, sides}, goal_of(1e-3, 256));
  EXPECT_GT(even.cost, 8.0) << "a few equal samples are not enough";
  EXPECT_LT(even.cost, 32.0);
}

TEST_F(TwoColours, AreTheSameWhateverWasSampledBefore) {
  RegionSampler sampler(*scene_, *viewer_, settings_, {0, 0, 8, 8}, settings_.seed);
  const RegionSampler::Goal goal = goal_of(-1.0, 64);
  const auto first = sampler.sample({crossed, {}}, goal, counts_);
  (void)sampler.sample({{0.25f, 0.25f, 0.5f}, {}}, goal, counts_);
  const auto again = sampler.sample({crossed, {}}, goal, counts_);
  EXPECT_EQ(first.value, again.value);
}

TEST_F(TwoColours, AreTheSameTogetherAsAlone) {
  const std::array<Square, 3> squares = {crossed, Square{0.25f, 0.25f, 0.5f},
                                         Square{4.0f / 8.0f, 4.0f / 8.0f, 1.0f / 8.0f}};
  const std::array<RegionSampler::Goal, 3> goals = {goal_of(-1.0, 64), goal_of(0.02, 256),
                                                    goal_of(-1.0, 16)};
  RegionSampler sampler(*scene_, *viewer_, settings_, {0, 0, 8, 8}, settings_.seed);
  for (std::size_t i = 0; i < squares.size(); ++i)
    EXPECT_EQ(sampler.add({squares[i], {}}, goals[i]), i);
  const auto together = sampler.run(counts_);
  ASSERT_EQ(together.size(), squares.size());
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const auto alone = sample({squares[i], {}}, goals[i]);
    EXPECT_EQ(together[i].cost, alone.cost);
    EXPECT_EQ(together[i].value, alone.value);
  }
}

/// A floor whose normals oscillate from pixel to pixel, under a panel.
FlattenedScene swinging(float amplitude) {
  FlattenedScene scene;
  World& world = scene.world;
  constexpr int n = 64;
  std::vector<TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  for (int z = 0; z <= n; ++z) {
    for (int x = 0; x <= n; ++x) {
      const auto u = static_cast<float>(x) / n, v = static_cast<float>(z) / n;
      const float slope = amplitude * std::sin(40.0f * u);
      vertices.push_back(
          {{8.0f * u - 4.0f, 0, 4.0f - 8.0f * v}, glm::normalize(glm::vec3(slope, 1, 0)), {u, v}});
    }
  }
  for (unsigned z = 0; z < n; ++z) {
    for (unsigned x = 0; x < n; ++x) {
      const unsigned i = z * (n + 1) + x;
      triangles.push_back({i, i + 1, i + n + 2});
      triangles.push_back({i, i + n + 2, i + n + 1});
    }
  }
  add_part(world, vertices, triangles, matte({0.8f, 0.8f, 0.8f}));
  const Light light = make_panel({3, 3, 0}, {0, -1, 0}, {0.4, 0, 0}, {0, 0, 0.4}, 12.0f);
  scene.lights = {light};
  return scene;
}

Picture picture_of(float amplitude, Method method) {
  RenderSettings settings = make_settings(32, 32, method, 256);
  settings.asos.max_level = 3;
  settings.cull = false;
  return render_picture(*make_render_scene(swinging(amplitude)), look_at({0, 3, 3}, {0, 0, 0}, 0.6),
                        settings);
}

// Parts that were split for shading only share one shadow test: one ray per light and pixel.
TEST(SharedShadows, PartsOfABumpyPixelTakeOneShadowRayTogether) {
  const Picture bumpy = picture_of(0.5f, Method::asos);
  const double pixels = 32.0 * 32.0;
  EXPECT_GT(static_cast<double>(bumpy.statistics.uneven_pixels), 0.25 * pixels);
  EXPECT_GT(static_cast<double>(bumpy.statistics.eye_rays), 2.0 * pixels);
  EXPECT_LE(static_cast<double>(bumpy.statistics.shadow_rays), pixels);
  // The picture is correct: within the tolerance of a pixel at MAX 3 of the sampled picture.
  const Picture sampled = picture_of(0.5f, Method::sobol);
  for (std::size_t i = 0; i < bumpy.film.radiance.size(); ++i)
    EXPECT_NEAR(bumpy.film.radiance[i].y, sampled.film.radiance[i].y, 1.0 / 256.0) << i;
}

// Two stages, the second by another sampler: within four times the goal, then within the goal.
TEST_F(TwoColours, TwoStagesMatchAcrossSamplers) {
  const auto sampler = [&] {
    return std::make_unique<RegionSampler>(*scene_, *viewer_, settings_, PixelRect{0, 0, 8, 8},
                                           settings_.seed);
  };
  const RegionSampler::Goal strict = goal_of(0.002, 4096), easy = goal_of(0.2, 4096);
  const auto both_stages = [&](bool anew) {
    auto own = sampler();
    own->add({crossed, {}}, strict);
    own->add({crossed, {}}, easy);
    const auto first = own->start(counts_, 4.0);
    EXPECT_LT(first[0].error, 4.0 * 0.002 * std::sqrt(first[0].cost / 16.0));
    EXPECT_TRUE(own->open(0));
    EXPECT_FALSE(own->open(1)) << "it is within its goal";
    const double taken = first[0].cost;
    RegionSampler::Open open = own->take_open();
    EXPECT_FALSE(open.empty());
    EXPECT_GT(open.bytes(), 100u);
    if (anew) own = sampler();
    const auto second = own->resume(std::move(open), counts_);
    EXPECT_EQ(second.size(), 1u);
    EXPECT_GT(second[0].cost, taken);
    return second[0];
  };
  const RegionSampler::Mean kept = both_stages(false), anew = both_stages(true);
  EXPECT_EQ(kept.value, anew.value);
  EXPECT_EQ(kept.error, anew.error);
  EXPECT_EQ(kept.cost, anew.cost);
  EXPECT_NEAR(kept.value.g, 0.7, 0.01);
}

// A strip along the pixel's diagonal, of a millionth of its area.
TEST_F(TwoColours, PlaceInsideCountsWhereNoSampleMeetsTheRegion) {
  const Square pixel{1.0f / 8.0f, 3.0f / 8.0f, 1.0f / 8.0f};
  const auto at = [&](float u, float v) {
    return glm::vec2(pixel.u, pixel.v) + pixel.side * glm::vec2(u, v);
  };
  const std::array<BorderEdge, 4> sides = {BorderEdge{at(0, 0), at(1e-6f, 0)},
                                           {at(1e-6f, 0), at(1, 1)},
                                           {at(1, 1), at(1.0f - 1e-6f, 1)},
                                           {at(1.0f - 1e-6f, 1), at(0, 0)}};
  RegionSampler sampler(*scene_, *viewer_, settings_, {0, 0, 8, 8}, settings_.seed);
  sampler.add({pixel, sides}, goal_of(-1.0, 64));
  EXPECT_EQ(sampler.run(counts_)[0].cost, 0.0);
  sampler.set_inside(sampler.add({pixel, sides}, goal_of(-1.0, 64)), at(0.5f, 0.5f));
  sampler.set_inside(sampler.add({crossed, {}}, goal_of(-1.0, 64)), at(0.5f, 0.5f));
  const auto found = sampler.run(counts_);
  EXPECT_EQ(found[0].cost, 1.0);
  EXPECT_EQ(found[0].value, glm::dvec3(1, 0, 0));
  EXPECT_EQ(found[1].cost, 64.0) << "the place is one more sample only where there is no other";
}

// A noisy pixel may take no more samples. The samples of its even neighbour agree, but it needs
// more, since the noisy surface may reach into it.
TEST_F(TwoColours, SecondStageCountsFinishedNeighbours) {
  constexpr Square even{5.0f / 8.0f, 3.0f / 8.0f, 1.0f / 8.0f};
  const double noise = sample({crossed, {}}, goal_of(-1.0, 16, 16, 1.0)).error;
  ASSERT_GT(noise, 0.0);
  RegionSampler sampler(*scene_, *viewer_, settings_, {0, 0, 8, 8}, settings_.seed);
  sampler.add({crossed, {}}, goal_of(-1.0, 16, 16, 1.0));
  sampler.add({even, {}}, goal_of(noise / 6.0, 4096, 16, 1.0));
  (void)sampler.start(counts_, 4.0);
  ASSERT_FALSE(sampler.open(0));
  ASSERT_TRUE(sampler.open(1));
  const auto found = sampler.resume(sampler.take_open(), counts_);
  // The neighbour's part of the error, noise / 2, falls with the root of the number of samples; the
  // allowed error grows with it.
  EXPECT_EQ(found[0].cost, 64.0);
}

}  // namespace
}  // namespace asos::test::region_sampler_test
