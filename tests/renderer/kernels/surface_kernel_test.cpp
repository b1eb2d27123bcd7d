#include "renderer/kernels/surface_kernel.h"

#include "renderer/shading/light_transport.h"
#include "renderer/shading/mip_chain.h"
#include "tests/support/every_target.h"
#include "tests/support/random_space.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <memory>
#include <vector>

// The kernels against the scalar functions.

namespace asos::test::surface_kernel_test {
namespace {

constexpr std::size_t points_of_a_batch = 251;

/// Random triangles, some degenerate, some with varying normals, and hits on them.
struct Subjects {
  World world;
  RenderFeatures render_features;
  PixelSpacing spacing;
  MipChains mips;
  std::vector<Hit> hits;
  std::vector<glm::vec3> directions;
  std::vector<float> sides;
  std::unique_ptr<TriangleBatch> batch = std::make_unique<TriangleBatch>();

  Subjects(std::uint64_t seed, double scale, bool perspective) {
    RandomSpace space(seed);
    render_features.punctual_lights = true;
    render_features.textures = true;
    spacing.perspective = perspective;
    spacing.forward = glm::vec3(space.direction());
    spacing.right = 0.01f * glm::vec3(space.direction());
    spacing.down = 0.01f * glm::vec3(space.direction());
    if (!perspective) {
      spacing.right *= static_cast<float>(scale);
      spacing.down *= static_cast<float>(scale);
    }
    spacing.start = static_cast<float>(space.between(0, scale));
    for (std::size_t i = 0; i < points_of_a_batch; ++i) add(space, i, scale);
  }

  void add(RandomSpace& space, std::size_t i, double scale) {
    Material material{.roughness = i % 3 == 0 ? 0.8f : 0.3f};
    if (i % 5 == 0) material.base_color_texture.texture = 0;
    const glm::vec3 normal(space.direction());
    std::vector<TinyVertex> vertices;
    for (int k = 0; k < 3; ++k) {
      const glm::vec3 turned(glm::normalize(glm::dvec3(normal) + 0.4 * space.direction()));
      vertices.push_back({glm::vec3(scale * (2.0 * space.direction() + 3.0 * space.direction())),
                          i % 2 == 0 ? normal : turned,
                          {0, 0}});
    }
    if (i % 4 == 1) {  // a smooth surface, from either side
      const glm::dvec3 a(vertices[0].position), b(vertices[1].position), c(vertices[2].position);
      const glm::dvec3 own = glm::normalize(glm::cross(b - a, c - a));
      for (TinyVertex& v : vertices)
        v.normal = glm::vec3(glm::normalize(own + 0.6 * space.direction()));
    }
    if (i % 17 == 0) vertices[2].position = vertices[1].position;  // no area
    if (i % 19 == 0) {                                             // no normal
      for (TinyVertex& v : vertices) v.normal = glm::vec3(0.0f);
    }
    add_part(world, vertices, {{0, 1, 2}}, material);
    const Hit hit{.triangle = static_cast<std::uint32_t>(i),
                  .t = static_cast<float>(space.between(0.1, 10.0) * scale),
                  .b1 = static_cast<float>(space.between(0, 0.6)),
                  .b2 = static_cast<float>(space.between(0, 0.4))};
    hits.push_back(hit);
    directions.emplace_back(space.direction());
    sides.push_back(i % 7 == 0 ? 0.0f : static_cast<float>(space.between(0.01, 2.0)));
    set_lane(batch->count++, i);
  }

  void set_lane(std::size_t lane, std::size_t i) const {
    TriangleBatch& lanes = *batch;
    const glm::uvec3 v = world.triangles[hits[i].triangle];
    lanes.corner_0.set(lane, world.positions[v.x]);
    lanes.corner_1.set(lane, world.positions[v.y]);
    lanes.corner_2.set(lane, world.positions[v.z]);
    lanes.normal_0.set(lane, world.normals[v.x]);
    lanes.normal_1.set(lane, world.normals[v.y]);
    lanes.normal_2.set(lane, world.normals[v.z]);
    Ray ray{.direction = directions[i]};
    lanes.set_hit(lane, hits[i], ray, sides[i]);
    const Material& material = world.material_of(hits[i].triangle);
    lanes.textured[lane] = material.base_color_texture.used() ? 1.0f : 0.0f;
    lanes.shiny[lane] = material.roughness <= least_broad_roughness ? 1.0f : 0.0f;
  }

  [[nodiscard]] SurfacePoint oracle(std::size_t i, bool filtered) const {
    const SampleExtent extent{&spacing, filtered ? &mips : nullptr, sides[i]};
    return surface_point(world, render_features, hits[i], -directions[i], extent);
  }
};

struct Found {
  SurfaceRest rest;
  ShadingPoints points;
  MaterialBatch materials;
};

SurfaceMaterial random_material(RandomSpace& space, std::size_t i) {
  const auto number = [&] { return static_cast<float>(space.between(0, 1)); };
  SurfaceMaterial material{.base_color = {number(), number(), number()},
                           .f0 = 0.3f * glm::vec3(number(), number(), number()),
                           .f90 = i % 4 == 0 ? number() : 1.0f,
                           .dielectric_f0 = i % 7 == 0 ? 1.0f : 0.5f * number(),
                           .dielectric_f90 = 0.5f + 0.5f * number()};
  material.roughness = i % 3 == 0 ? 0.15f * number() : number();  // below the roughness floor, too
  if (i % 11 == 0) material.roughness = 0.0f;
  material.metallic = i % 2 == 0 ? number() : 0.0f;
  return material;
}

constexpr double scales[] = {1.0, 1e-6, 1e6};

TEST(SurfaceKernel, PointsAreTheOnesMadeOneByOne) {
  for (const double scale : scales) {
    for (const bool filtered : {true, false}) {
      const Subjects subjects(static_cast<std::uint64_t>(std::log10(scale) + 20.0), scale,
                              filtered && scale < 10.0);
      const auto found = std::make_unique<Found>();
      place_surfaces(*subjects.batch, filtered ? &subjects.spacing : nullptr, found->rest,
                     found->points);
      ASSERT_EQ(found->points.count, points_of_a_batch);
      int spread = 0, lifted = 0;
      for (std::size_t i = 0; i < points_of_a_batch; ++i) {
        SCOPED_TRACE(i);
        const SurfacePoint point =
            surface_at(*subjects.batch, found->rest, found->points, subjects.hits[i].triangle, i);
        const SurfacePoint expected = subjects.oracle(i, filtered);
        EXPECT_EQ(point.position, expected.position);
        EXPECT_EQ(point.error, expected.error);
        EXPECT_EQ(point.extent, expected.extent);
        EXPECT_EQ(point.to_edge, expected.to_edge);
        EXPECT_EQ(point.geometric_normal, expected.geometric_normal);
        EXPECT_EQ(point.shading_normal, expected.shading_normal);
        EXPECT_EQ(point.lift, expected.lift);
        EXPECT_EQ(point.smooth_normal, expected.smooth_normal);
        EXPECT_EQ(found->points.position.at(i), expected.lit_position());
        EXPECT_EQ(found->points.geometric.at(i), expected.horizon());
        lifted += expected.lift != glm::vec3(0.0f);
        EXPECT_EQ(point.footprint.right, expected.footprint.right);
        EXPECT_EQ(point.footprint.down, expected.footprint.down);
        if (expected.spread.flat() || glm::length(expected.spread.right) < 1e30f) {
          EXPECT_EQ(point.spread.right, expected.spread.right);
          EXPECT_EQ(point.spread.down, expected.spread.down);
        }
        EXPECT_EQ(found->points.clear_height[i], clear_height(expected));
        spread += !expected.spread.flat();
      }
      EXPECT_EQ(spread > 40, filtered) << "some normals must vary";
      EXPECT_GT(lifted, 20);
    }
  }
}

// The material data that the lights' kernels use: see light_kernel_test.
TEST(SurfaceKernel, SpacingsOfTheirOwnAreAsOneForAll) {
  for (const bool perspective : {true, false}) {
    const Subjects subjects(11, 1.0, perspective);
    const auto one = std::make_unique<Found>(), own = std::make_unique<Found>();
    const auto spacings = std::make_unique<SpacingBatch>();
    for (std::size_t i = 0; i < points_of_a_batch; ++i) spacings->set(i, subjects.spacing);
    for_every_target([&] {
      place_surfaces(*subjects.batch, &subjects.spacing, one->rest, one->points);
      place_surfaces(*subjects.batch, *spacings, own->rest, own->points);
      for (std::size_t i = 0; i < points_of_a_batch; ++i) {
        EXPECT_EQ(own->points.patch_right.at(i), one->points.patch_right.at(i)) << i;
        EXPECT_EQ(own->points.patch_down.at(i), one->points.patch_down.at(i)) << i;
        EXPECT_EQ(own->points.viewer_nearness[i], one->points.viewer_nearness[i]) << i;
        EXPECT_EQ(own->points.spread_right.at(i), one->points.spread_right.at(i)) << i;
        EXPECT_EQ(own->rest.right_b1[i], one->rest.right_b1[i]) << i;
      }
    });
  }
}

TEST(SurfaceKernel, MaterialsAreTheOnesViewedOneByOne) {
  const Subjects subjects(3, 1.0, true);
  const auto found = std::make_unique<Found>();
  place_surfaces(*subjects.batch, &subjects.spacing, found->rest, found->points);
  RandomSpace space(4);
  std::vector<SurfaceMaterial> materials;
  for (std::size_t i = 0; i < points_of_a_batch; ++i) {
    materials.push_back(random_material(space, i));
    found->materials.set(i, materials.back());
    found->points.stretch.set(i, glm::vec3(9.0f));  // of points before these
  }
  EXPECT_TRUE(view_materials(found->rest, found->materials, found->points));
  const auto one = std::make_unique<ShadingPoints>();
  const ShadingPoints& points = found->points;
  double sum = 0.0;
  for (std::size_t i = 0; i < points_of_a_batch; ++i) {
    SCOPED_TRACE(i);
    const SurfacePoint point = subjects.oracle(i, true);
    ViewedPoint view{point, -subjects.directions[i], 0.0f};
    view.n_dot_v = std::max(glm::dot(point.shading_normal, view.to_viewer), grazing_cosine);
    const ViewedMaterial seen = viewed(materials[i], mirroring_cosine(view));
    // As in Shader: patches of surfaces without textures count only if normals vary.
    const bool shows = subjects.batch->textured[i] > 0.0f || subjects.batch->shiny[i] > 0.0f;
    if (subjects.sides[i] > 0.0f && materials[i].roughness < least_broad_roughness && shows) {
      view.patch = patch_on_plane(subjects.spacing, subjects.directions[i], subjects.hits[i].t,
                                  point.geometric_normal, subjects.sides[i]);
      view.distance = subjects.spacing.start + subjects.hits[i].t;
    }
    one->count = 0;
    one->add({{}, view, seen}, glm::vec3(1.0f));
    const glm::vec3 off = glm::abs(found->materials.specular.at(i) - seen.specular) +
                          glm::abs(found->materials.ambient.at(i) - seen.ambient) +
                          glm::abs(points.diffuse.at(i) - one->diffuse.at(0));
    EXPECT_LT(off.x + off.y + off.z, 3e-6f);
    EXPECT_NEAR(found->materials.below[i], seen.below, 1e-6f);
    EXPECT_EQ(points.stretch.at(i), glm::vec3(0.0f));
    sum += static_cast<double>(off.x + off.y + off.z);
    EXPECT_NEAR(points.falloff[i], one->falloff[0], 1e-6f);
    EXPECT_EQ(points.f0.at(i), one->f0.at(0));
    EXPECT_EQ(points.f90_less_f0.at(i), one->f90_less_f0.at(0));
    EXPECT_EQ(points.alpha[i], one->alpha[0]);
    EXPECT_EQ(points.n_dot_v[i], one->n_dot_v[0]);
    EXPECT_EQ(points.shows_lights[i], 0.0f);
    EXPECT_EQ(points.turns[i], one->turns[0]);
    if (one->turns[0] == 0.0f) continue;
    EXPECT_EQ(points.viewer_nearness[i], one->viewer_nearness[0]);
    EXPECT_EQ(points.patch_right.at(i), one->patch_right.at(0));
    EXPECT_EQ(points.patch_down.at(i), one->patch_down.at(0));
  }
  EXPECT_LT(sum / points_of_a_batch, 1e-6);
}

TEST(SurfaceKernel, WhatIsNotFiniteIsNoticed) {
  const Subjects subjects(5, 1.0, true);
  const auto found = std::make_unique<Found>();
  place_surfaces(*subjects.batch, nullptr, found->rest, found->points);
  RandomSpace space(6);
  for (std::size_t i = 0; i < points_of_a_batch; ++i)
    found->materials.set(i, random_material(space, i));
  EXPECT_TRUE(view_materials(found->rest, found->materials, found->points));
  // Unused lanes after the last point do not affect the result.
  found->materials.base_color.y[points_of_a_batch] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(view_materials(found->rest, found->materials, found->points));
  found->materials.base_color.y[points_of_a_batch - 1] = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(view_materials(found->rest, found->materials, found->points));
}

void append(std::vector<std::uint32_t>& bits, const ShadingPoints::Floats& of, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) bits.push_back(std::bit_cast<std::uint32_t>(of[i]));
}
void append(std::vector<std::uint32_t>& bits, const ShadingPoints::Vectors& of, std::size_t count) {
  append(bits, of.x, count);
  append(bits, of.y, count);
  append(bits, of.z, count);
}

TEST(SurfaceKernel, AllInstructionSetsGiveTheSameBits) {
  const Subjects subjects(7, 1.0, true);
  std::vector<std::uint32_t> first;
  for_every_target([&] {
    const auto found = std::make_unique<Found>();
    place_surfaces(*subjects.batch, &subjects.spacing, found->rest, found->points);
    RandomSpace space(8);
    for (std::size_t i = 0; i < points_of_a_batch; ++i)
      found->materials.set(i, random_material(space, i));
    EXPECT_TRUE(view_materials(found->rest, found->materials, found->points));
    std::vector<std::uint32_t> bits;
    const ShadingPoints& p = found->points;
    const SurfaceRest& r = found->rest;
    for (const ShadingPoints::Vectors* v : std::initializer_list<const ShadingPoints::Vectors*>{
             &p.position, &p.geometric, &p.normal, &p.to_viewer, &p.diffuse, &p.f0, &p.f90_less_f0,
             &p.patch_right, &p.patch_down, &found->materials.specular, &r.error})
      append(bits, *v, p.count);
    for (const ShadingPoints::Floats* f :
         {&p.clear_height, &p.to_edge, &p.n_dot_v, &p.alpha, &p.turns, &p.viewer_nearness,
          &r.extent, &r.normal_side, &r.right_b1, &r.right_b2, &r.down_b1, &r.down_b2})
      append(bits, *f, p.count);
    if (first.empty()) first = bits;
    EXPECT_EQ(first, bits);
  });
  EXPECT_FALSE(first.empty());
}

}  // namespace
}  // namespace asos::test::surface_kernel_test
