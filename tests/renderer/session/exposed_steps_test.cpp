// Progressive renders with a shutter, a lens and unlit surfaces: the steps that follow the rounds,
// and the final picture.

#include "renderer/session/render_session.h"
#include "tests/support/expect_same.h"
#include "tests/support/exposed_picture.h"
#include "tests/support/quad_mesh.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace asos::test::exposed_steps_test {
namespace {

constexpr int width = 48, height = 32;

/// A card of 2 x 2 at this place, facing +z.
void add_card(Scene& scene, glm::dvec3 at, bool unlit) {
  Material material{.base_color = {0.8f, 0.5f, 0.2f, 1.0f}, .double_sided = true, .unlit = unlit};
  add_object(scene, quad_mesh({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), material, "card",
             glm::rotate(glm::translate(glm::dmat4(1.0), at), 0.3, {0, 0, 1}));
}

/// A card before another, both turned against the pixels; the nearer one moves to the right.
Snapshot picture_of(bool unlit, double shutter, double lens_radius) {
  Scene scene{.source = "cards"};
  add_card(scene, {-0.9, 0.1, -3.0}, unlit);
  add_card(scene, {0.4, -0.2, -5.0}, false);
  const auto rig = std::make_shared<PosedBy>(scene, 1.0, [](double seconds, Scene& posed) {
    glm::dmat4& place = posed.instances[0].world_from_mesh;
    place = glm::translate(glm::dmat4(1.0), {seconds, 0.0, 0.0}) * place;
  });
  Camera camera{.fov_y_rad = 0.8, .lens = {.radius = lens_radius}};
  if (lens_radius > 0.0) camera.lens.focus = 5.0;
  Snapshot snapshot{.settings = {.width = width,
                                 .height = height,
                                 .asos = {.max_level = 2},
                                 .shutter = {.seconds = shutter},
                                 .threads = 2}};
  const ExposedScene exposed = exposed_at(*rig, 0.5, camera, snapshot.settings);
  EXPECT_EQ(exposed.scene->exposure && exposed.exposure().moves(), shutter > 0.0);
  snapshot.scene = exposed.scene;
  snapshot.camera = exposed.camera;
  if (snapshot.scene->exposure)
    for (const auto& moment : snapshot.scene->exposure->moments) (void)moment->features();
  (void)snapshot.scene->features();
  return snapshot;
}

/// Tiles of blocks: of sampled pixels or of a first stage, and final ones.
struct Steps {
  Film film{width, height};
  int early = 0, final = 0;
};

Steps steps_of(const Snapshot& snapshot) {
  RenderSession session;
  session.restart(snapshot);
  session.wait();
  Steps steps;
  for (const FinishedTile& tile : session.take_finished()) {
    steps.film.put(tile);
    if (tile.rect.width > block_size) continue;
    ++(tile.coarse ? steps.early : steps.final);
  }
  return steps;
}

/// Changes over the picture, horizontally: a picture without them tests nothing.
int changes_in(const Film& film) {
  int changes = 0;
  for (std::size_t i = 1; i < film.radiance.size(); ++i)
    changes += film.radiance[i] != film.radiance[i - 1];
  return changes;
}

void expect_steps_and_the_final_picture(const Snapshot& snapshot) {
  const Steps steps = steps_of(snapshot);
  EXPECT_GT(steps.early, 0) << "no pixel took further samples";
  EXPECT_EQ(steps.final, width * height / (block_size * block_size));
  const Film direct = render_to_end(snapshot).film;
  expect_same(steps.film, direct);
  EXPECT_EQ(steps.film.rays, direct.rays);
  EXPECT_TRUE(steps.film.unlit == direct.unlit);
  EXPECT_GT(changes_in(direct), width);
}

TEST(ExposedSteps, OfAShutterEndAsADirectRender) {
  const Snapshot snapshot = picture_of(false, 0.4, 0.0);
  expect_steps_and_the_final_picture(snapshot);
  Snapshot still = snapshot;
  still.settings.shutter.seconds = 0.0;
  EXPECT_NE(render_to_end(still).film.radiance, render_to_end(snapshot).film.radiance);
}

TEST(ExposedSteps, OfALensEndAsADirectRender) {
  const Snapshot snapshot = picture_of(false, 0.0, 0.2);
  expect_steps_and_the_final_picture(snapshot);
  Snapshot sharp = snapshot;
  sharp.camera.lens.radius = 0.0;
  EXPECT_NE(render_to_end(sharp).film.radiance, render_to_end(snapshot).film.radiance);
}

TEST(ExposedSteps, OfUnlitSurfacesEndAsADirectRender) {
  const Snapshot snapshot = picture_of(true, 0.0, 0.0);
  expect_steps_and_the_final_picture(snapshot);
  const Film film = render_to_end(snapshot).film;
  EXPECT_TRUE(std::any_of(film.unlit.begin(), film.unlit.end(),
                          [](glm::vec4 part) { return part.w > 0.0f && part.w < 1.0f; }));
}

TEST(ExposedSteps, OfAllTogetherEndAsADirectRender) {
  Snapshot snapshot = picture_of(true, 0.4, 0.2);
  snapshot.settings.asos.max_level = 1;  // a third of the time
  expect_steps_and_the_final_picture(snapshot);
}

}  // namespace
}  // namespace asos::test::exposed_steps_test
