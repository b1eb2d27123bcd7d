#include "renderer/film/split_cause.h"
#include "tests/support/quad_mesh.h"
#include "tests/ui/ui_rig.h"
#include "ui/legend_strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

// The split map by cause: a wall with a crease, and a card in front of it that casts a hard shadow.

namespace asos {
using namespace ui;
namespace {

using test::add_object;
using test::quad_mesh;
using test::UiRig;

constexpr double view_height = 8.0;  // in world units, around the origin
constexpr float kink_x = -1.53125f, card_left = 1.029f, card_right = 2.029f;

Result<Scene> kinked_wall(const std::string& source) {
  Scene scene{.source = source};
  Material matte{.base_color = {0.6f, 0.6f, 0.6f, 1.0f}, .metallic = 0.0f};
  scene.materials.push_back(matte);
  add_object(scene, quad_mesh({kink_x - 20.0f, -20, -4}, {20, 0, 4}, {0, 40, 0}));
  add_object(scene, quad_mesh({kink_x, -20, 0}, {20, 0, 0}, {0, 40, 0}));
  add_object(scene, quad_mesh({card_left, -1, 1}, {card_right - card_left, 0, 0}, {0, 2, 0}));
  Light light{.name = "sun",
              .type = Light::Type::directional,
              .intensity = 3.0f,
              .direction = glm::normalize(glm::dvec3(-1, 0, -1))};
  scene.lights.push_back(light);
  Camera camera{.type = Camera::Type::orthographic, .height = view_height};
  camera.world_from_camera[3] = glm::dvec4(0, 0, 10, 1);
  scene.cameras.push_back(camera);
  return scene;
}

class SplitMapTest : public testing::Test {
 protected:
  SplitMapTest() { EXPECT_TRUE(rig.opens("wall") && rig.settle()); }

  DisplaySettings& display() { return rig.state().display; }

  void show(SplitMapColours colours) {
    display().show_split_map = true;
    display().show_legend = false;
    display().split_dimming = 1.0f;
    display().split_colours = colours;
    rig.frame();
  }
  /// The pixel that shows a point of the world.
  [[nodiscard]] glm::ivec2 pixel_of(double x, double y) {
    const Film& film = rig.film();
    const double scale = film.height / view_height;
    return {static_cast<int>(std::floor(0.5 * film.width + x * scale)),
            static_cast<int>(std::floor(0.5 * film.height - y * scale))};
  }
  [[nodiscard]] glm::u8vec3 shown(glm::ivec2 at) {
    return rig.pixels()[static_cast<std::size_t>(at.y * rig.size().x + at.x)];
  }

  UiRig rig{kinked_wall, UiRig::with_bar({905, 604})};  // the picture has 577 x 576 pixels
};

TEST_F(SplitMapTest, ShowsTheCauseOfKnownPixels) {
  show(SplitMapColours::cause);
  // The card's shadow is one unit to its left.
  for (const auto& [x, cause] : {std::pair<double, SplitCause>{kink_x, SplitCause::crease},
                                 {card_right, SplitCause::outline},
                                 {card_left - 1.0, SplitCause::shadow},
                                 {card_left - 0.5, SplitCause::none}}) {
    const glm::ivec2 at = pixel_of(x, 0.13);
    const Film& film = rig.film();
    EXPECT_EQ(film.cause[film.index(at.x, at.y)], cause) << x;
    EXPECT_EQ(shown(at), split_cause_colour(cause)) << x;
  }
  // The edge of the hard shadow cuts pixels that are not split.
  const glm::ivec2 shadow = pixel_of(card_left - 1.0, 0.13);
  show(SplitMapColours::level);
  EXPECT_EQ(shown(shadow), exact_colour);
  EXPECT_EQ(shown(pixel_of(card_right, 0.13)), exact_colour) << "one line cuts it";
  EXPECT_EQ(shown(pixel_of(card_left - 0.5, 0.13)), glm::u8vec3(0));
}

TEST_F(SplitMapTest, EveryPixelHasItsCausesColour) {
  show(SplitMapColours::cause);
  const Film& film = rig.film();
  const std::vector<glm::u8vec3> pixels = rig.pixels();
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      ASSERT_EQ(pixels[static_cast<std::size_t>(y * rig.size().x + x)],
                split_cause_colour(film.cause[film.index(x, y)]))
          << x << ' ' << y;
    }
  }
}

TEST_F(SplitMapTest, TheKeysChooseItAndRestartNothing) {
  const std::uint64_t restarts = rig.render().restarts();
  const glm::ivec2 kink = pixel_of(kink_x, 0.13);
  display().split_dimming = 1.0f;
  rig.key(Key::m);
  const glm::u8vec3 by_level = shown(kink);
  rig.key(Key::c);
  EXPECT_EQ(shown(kink), split_cause_colour(SplitCause::crease));
  for (const auto cost : {SplitMapColours::rays, SplitMapColours::time}) {
    rig.key(Key::c);
    EXPECT_EQ(display().split_colours, cost);
    const Film& film = rig.film();
    const SplitMapKey key{cost};
    EXPECT_EQ(shown(kink), key.colour(key.value(film, film.index(kink.x, kink.y))));
  }
  rig.key(Key::c);
  EXPECT_EQ(shown(kink), by_level);
  EXPECT_NE(by_level, split_cause_colour(SplitCause::crease));
  EXPECT_EQ(rig.render().restarts(), restarts);
}

TEST_F(SplitMapTest, TheLegendHasTheCausesThatOccur) {
  show(SplitMapColours::cause);
  display().show_legend = true;
  for (int i = 0; i < 3; ++i) rig.frame();
  const std::vector<SplitCause>& causes = rig.film().cause;
  const auto& all = rig.controls();
  int occur = 0;
  for (std::size_t i = 1; i < split_cause_count; ++i) {
    const auto cause = static_cast<SplitCause>(i);
    const bool occurs = std::find(causes.begin(), causes.end(), cause) != causes.end();
    occur += occurs;
    const std::string name = std::string("Cause/") + title_of(cause);
    ASSERT_EQ(all.contains(name), occurs) << name;
    if (!occurs) continue;
    const Controls::Placed entry = rig.control(name);
    EXPECT_TRUE(entry.has_tooltip) << name;
    EXPECT_LT(entry.hi.x, static_cast<float>(rig.size().x)) << name;
    EXPECT_EQ(shown(glm::ivec2(entry.lo) + 4), split_cause_colour(cause)) << name;
  }
  EXPECT_GE(occur, 3);
  EXPECT_LT(occur, static_cast<int>(split_cause_count) - 1) << "no lens and no motion";
  CauseCounts counts;
  counts.pixels[static_cast<std::size_t>(SplitCause::shadow)] = 1;
  const std::vector<LegendEntry> saved = legend_entries(SplitMapColours::cause, counts);
  ASSERT_EQ(saved.size(), 1u);
  EXPECT_EQ(saved[0].words, "shadow");
}

// For each colouring, while the map is shown: the legend is on the picture, visible without
// scrolling, with the quantity and its unit.
TEST_F(SplitMapTest, TheLegendStandsOnThePictureAndNamesItsUnit) {
  const auto& all = rig.controls();
  EXPECT_FALSE(all.contains("Map legend"));
  for (const auto& [colours, title] :
       {std::pair<SplitMapColours, std::string>{SplitMapColours::level,
                                                "Deepest level of each pixel (MAX = 2)"},
        {SplitMapColours::cause, "Why pixels were split"},
        {SplitMapColours::rays, "Rays per pixel"},
        {SplitMapColours::time, "CPU time per pixel"}}) {
    SCOPED_TRACE(title);
    show(colours);
    display().show_legend = true;
    for (int i = 0; i < 3; ++i) rig.frame();
    ASSERT_TRUE(all.contains("Map legend"));
    EXPECT_EQ(all.at("Legend title").words, title);
    const Controls::Placed legend = all.at("Map legend");
    const PixelRect picture = rig.content().picture_rect();
    EXPECT_GE(std::min(legend.lo.x, legend.lo.y), 0.0f);
    EXPECT_LE(legend.hi.x, static_cast<float>(picture.width));
    EXPECT_LE(legend.hi.y, static_cast<float>(picture.height));
    if (colours == SplitMapColours::rays) {
      EXPECT_EQ(all.at("Scale").words, "1 ray 4 16 64 256 1024 4096");
    }
    if (colours == SplitMapColours::time) {
      EXPECT_EQ(all.at("Scale").words, "0.1 \u00b5s 1 \u00b5s 10 \u00b5s 0.1 ms 1 ms 10 ms");
    }
    // The pixel panel does not overlap the legend.
    rig.click("Why is this pixel like this?");
    ASSERT_TRUE(rig.frames_until([&] { return all.contains("Verdict"); }));
    for (int i = 0; i < 3; ++i) rig.frame();
    if (all.contains("Map legend")) {
      const Controls::Placed beside = all.at("Map legend"), panel = all.at("Pixel panel");
      EXPECT_TRUE(beside.lo.x >= panel.hi.x || beside.hi.x <= panel.lo.x ||
                  beside.lo.y >= panel.hi.y || beside.hi.y <= panel.lo.y);
    }
    rig.click("Close inspector");
    rig.key(Key::m);
    EXPECT_FALSE(all.contains("Map legend"));
  }
}

TEST_F(SplitMapTest, TheStatisticsListCausesAndLights) {
  rig.click_each({"Tab/Measure"});
  const auto& controls = rig.controls();
  for (const char* name : {"   silhouette", "   crease, seam", "   shadow", "   1 directional"})
    EXPECT_TRUE(controls.contains(name)) << name;
  for (const char* name : {"   2 directional", "   ..."})
    EXPECT_FALSE(controls.contains(name)) << name;
  // The causes' fractions add up to the fraction of split pixels.
  EXPECT_FALSE(controls.contains("Split, by cause"));
  const auto percent = [&](const char* name) { return std::stod(controls.at(name).words); };
  const RenderStatistics statistics = rig.render().statistics();
  double in_map = 0.0;
  for (std::size_t i = 1; i < split_cause_count; ++i)
    in_map += static_cast<double>(statistics.pixels_by_cause[i]);
  EXPECT_EQ(static_cast<double>(statistics.split_pixels), in_map);
  EXPECT_NEAR(percent("Split pixels"), 100.0 * rig.render().split_share(), 0.006);
}

// The frame that processes a slider's change shows its map, although no pixel is rendered yet.
TEST_F(SplitMapTest, FollowsEpsAndMaxAtOnce) {
  Previewer& previewer = rig.previewer();
  previewer.refinement().set_paused(true);  // no final pixels come
  show(SplitMapColours::level);
  const Film before = previewer.render().film();
  const RenderSettings rendered = previewer.render().settings();
  const auto share = [&] { return previewer.render().split_share(); };
  const double whole = share();
  ASSERT_GT(whole, 0.0);
  RenderSettings& settings = previewer.edits().settings();
  for (const auto& [eps, max_level] : {std::pair(0.5, 2), {1e-3, 4}, {1e-4, 6}, {1e-4, 0}}) {
    SCOPED_TRACE(eps);
    settings.asos.eps = eps;
    settings.asos.max_level = max_level;
    rig.frame();
    EXPECT_GE(share(), 0.5 * whole) << "pixels that an edge cuts are cut at any EPS";
    const Film& film = previewer.render().film();
    EXPECT_LE(*std::max_element(film.split_level.begin(), film.split_level.end()), max_level);
  }
  settings.asos = rendered.asos;
  rig.frame();
  const Film& film = previewer.render().film();
  EXPECT_EQ(film.split_level, before.split_level);
  EXPECT_EQ(film.cause, before.cause);
}

// The map is hatched until the pixels are final, and not afterwards.
TEST_F(SplitMapTest, AnUnfinishedMapIsHatched) {
  show(SplitMapColours::level);
  const auto hatched = [&] {
    const std::vector<glm::u8vec3> pixels = rig.pixels();
    const Film& film = rig.film();
    std::size_t lines = 0;
    for (int y = 0; y < film.height; ++y)
      for (int x = 0; x < film.width; ++x)
        lines += pixels[static_cast<std::size_t>(y * rig.size().x + x)] == glm::u8vec3(96);
    return static_cast<double>(lines) / (film.width * film.height);
  };
  EXPECT_EQ(hatched(), 0.0);
  rig.refinement().set_paused(true);
  rig.settings().asos.eps = 0.01;
  rig.frame();
  ASSERT_TRUE(rig.frames_until([&] { return !rig.render().first_picture_pending(); }));
  EXPECT_NEAR(hatched(), 1.0 / 12.0, 0.01);
  display().show_legend = true;
  for (int i = 0; i < 3; ++i) rig.frame();
  EXPECT_TRUE(rig.controls().contains("Unfinished"));
  display().show_legend = false;
  rig.refinement().set_paused(false);
  ASSERT_TRUE(rig.settle());
  rig.frame();
  EXPECT_EQ(hatched(), 0.0);
}

}  // namespace
}  // namespace asos
