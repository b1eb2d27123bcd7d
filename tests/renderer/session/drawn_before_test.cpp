#include "renderer/comparison/method.h"
#include "renderer/scene/builtin.h"
#include "renderer/session/render_session.h"
#include "renderer/session/work_plan.h"
#include "tests/support/expect_same.h"
#include "tests/support/make_settings.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <thread>
#include <vector>

// Buffers that a thread reuses between blocks must not carry anything over from earlier pictures.

namespace asos::test {
namespace {

/// Adds every lobe to all materials that are not glass.
void add_lobes(std::vector<Material>& materials) {
  for (Material& m : materials) {
    if (m.transmission > 0.0f) continue;
    m.metallic = 0.6f;
    m.roughness = 0.5f;
    m.sheen = {{0.9f, 0.3f, 0.1f}, 0.4f, {}, {}};
    m.coat.factor = 0.8f;
    m.coat.roughness = 0.3f;
    m.film.factor = 1.0f;
    m.anisotropy = {0.8f, 0.5f, {}};
    m.diffuse_transmission.factor = 0.3f;
  }
}

struct Subject {
  std::string name;
  std::shared_ptr<const RenderScene> scene;
  RenderSettings settings;
};

void add_subject(std::vector<Subject>& subjects, const std::string& name, bool lobes = false) {
  auto loaded = builtin_scene(name);
  ASSERT_TRUE(loaded) << loaded.error().message();
  if (lobes) add_lobes(loaded->materials);
  const auto scene = prepare(*loaded);
  ASSERT_TRUE(scene) << scene.error().message();
  RenderSettings settings = make_settings(24, 16);
  settings.sampling.spp = 4;
  settings.asos.max_level = 2;
  subjects.push_back({name, *scene, settings});
  settings.method = Method::sobol;
  subjects.push_back({name + ", sobol", *scene, settings});
}

RenderResult drawn_here(const Subject& subject) {
  const RenderSettings& settings = subject.settings;
  const View view(subject.scene->world().cameras.front(), settings.width, settings.height);
  RenderResult result;
  result.film = Film(settings.width, settings.height);
  for (const WorkPlan::Block& planned : WorkPlan(settings).blocks) {
    const BlockResult block = render_block(*subject.scene, view, settings, planned.rect);
    result.film.put(block.tile);
    result.statistics += block.statistics;
  }
  return result;
}

TEST(DrawnBefore, LeavesNoTraceInLaterPictures) {
  std::vector<Subject> subjects;
  for (const char* name : {"boxes", "workshop", "office-metal", "glass", "neon"})
    add_subject(subjects, name);
  if (!sanitized)
    for (const char* name : {"house-textured", "foliage", "primitives-ball", "primitives-linear"})
      add_subject(subjects, name);
  std::vector<Subject> dirty;  // those that leave the most data behind
  for (const char* name : {"mixed", "office"}) add_subject(dirty, name, true);
  ASSERT_FALSE(HasFatalFailure());

  for (std::size_t i = 0; i < subjects.size(); ++i) {
    SCOPED_TRACE(subjects[i].name);
    RenderResult alone;
    std::thread([&] { alone = drawn_here(subjects[i]); }).join();
    drawn_here(dirty[i % dirty.size()]);
    const RenderResult after = drawn_here(subjects[i]);
    expect_same(after.film, alone.film);
    expect_same(after.statistics, alone.statistics);
  }
}

}  // namespace
}  // namespace asos::test
