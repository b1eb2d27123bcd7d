#include "renderer/shading/sky.h"
#include "tests/ui/every_control_fixture.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

// Uses every control of the window, in as many states as are needed to show them all.

namespace asos {
using namespace ui;
namespace {

using test::parts;

/// The states, by topic. Each starts from the one before, so their order matters.
class EveryControlTest : public test::EveryControlFixture {
 protected:
  // States are entered again later, so they refer to no variables of these functions.
  void use_lights_and_methods() {
    use_all("a pixel was clicked", [&] {
      lights().selected = 0;
      s.picked = glm::ivec2(rig.film().width, rig.film().height) / 2;
    });
    for (const auto kind :
         {LightKind::point, LightKind::sphere, LightKind::spot, LightKind::directional,
          LightKind::linear, LightKind::rectangle, LightKind::disk, LightKind::polygon})
      use_all("light of kind " + std::to_string(static_cast<int>(kind)),
              [&, kind] { select_kind(kind); });
    for (const int selected : {0, 1})
      use_all("lights outside the picture", [&, selected] {
        std::vector<EditedLight>& all = rig.edits().edit_lights();
        all.push_back(all[0]);
        all[0].light.position = {50, 0, 0};
        all[1].light.position = {-50, 0, 0};
        lights().selected = selected;
      });
    // A light that becomes a polygon is a hexagon; the star needs a state of its own.
    use_all("a star", [&] {
      select_kind(LightKind::polygon);
      set_polygon_shape(rig.edits().edit_lights()[0].light, PolygonShape::star);
    });
    for (const auto method :
         {Method::sobol, Method::sobol_adaptive, Method::stochastic, Method::asos_published})
      use_all("method " + std::to_string(static_cast<int>(method)),
              [&, method] { settings().method = method; });
    use_all("soft shadows, divided", [&] {
      select_kind(LightKind::sphere);
      settings().shadow.quality = ShadowQuality::extended_divided;
      // The features of the lights come from another thread.
      (void)rig.frames_until([&] { return rig.controls().contains("Divisions"); });
    });
  }

  void use_maps_tour_and_bar() {
    for (const auto colours : {SplitMapColours::level, SplitMapColours::cause})
      use_all("split map", [&, colours] {
        s.display.show_split_map = true;
        s.display.split_colours = colours;
        // Without a finished picture there are no split pixels to explain.
        (void)rig.settle();
      });
    for (int card = 0; card < Tour::cards; ++card)
      use_all("card " + std::to_string(card) + " of the tour", [&, card] {
        start_tour(s, rig.previewer(), 0.0);
        show_card(s, rig.previewer(), card, 0.0);
        // Replaying needs a pixel, which another thread finds.
        if (card == static_cast<int>(Tour::Card::split))
          (void)rig.frames_until([&] { return rig.controls().contains("Replay"); });
        // Fills the list of snapshots, so that no comparison starts, which would take long.
        while (card == 4 && s.frames.store(rig.film(), "full", "")) continue;
      });
    use_all("the map's card, by causes", [&] {
      start_tour(s, rig.previewer(), 0.0);
      show_card(s, rig.previewer(), static_cast<int>(Tour::Card::map), 0.0);
      s.display.split_colours = SplitMapColours::cause;
    });
    for (const bool changed : {false, true})
      for (const bool before : {false, true})
        use_all("a bar of two rows", [&, changed, before] {
          rig.resize({1250, 480});
          s.look.show_bar = true;
          s.frames.store(rig.film(), "one", "");
          s.display.show_split_map = before;
          (void)rig.settle();
          if (!changed) return;
          // Makes a picture of the previous EPS available.
          settings().asos.eps = 0.3;
          (void)rig.settle();
          s.show_before = before;
          s.view.zoom_at(s.view.area_middle(), 1);
        });
  }

  void use_comparisons() {
    use_all("turning", [&] { rig.previewer().turntable().set_turning(true); });
    use_all("light and large", [&] { s.look = {theme::Look::light, 1.25f}; });
    for (const auto comparison : {Comparison::none, Comparison::wipe, Comparison::flip,
                                  Comparison::difference, Comparison::error})
      use_all("compare", [&, comparison] {
        rig.unfold("Compare");
        s.frames.store(rig.film(), "one", "");
        s.frames.store(rig.film(), "two", "");
        s.frames.comparison = comparison;
      });
  }

  void use_textures_and_mirrors() {
    const auto open = [&](const std::string& source) {
      ASSERT_TRUE(rig.opens(source) && rig.settle());
    };
    open("textured");
    use_all("textures", [] {});
    use_all("textures looked up at points",
            [&] { settings().texture.filter = TextureFilter::point; });
    open("mirrors");
    use_all("a blur for each colour", [&] {
      settings().mirror.dfr.emplace();
      settings().mirror.dfr->rgb = {DfrCurve{0.1, 1.0, 2.0}, DfrCurve{0.2, 0.8, 8.0},
                                    DfrCurve{0.3, 0.7, 4.0}};
      rig.frame();
      s.reflections.channel = DfrChannel::blue;
    });
    for (const DfrChannel channel : {DfrChannel::blue, DfrChannel::all})
      use_all("one blur for all", [&, channel] {
        s.reflections.channel = channel;
        settings().mirror.dfr.emplace();
        settings().mirror.dfr->rgb.fill({0.3, 0.7, 4.0});
      });
    for (const int pyray : {-1, 0})
      use_all("mirrors", [&, pyray] {
        s.picked = glm::ivec2(rig.film().width, rig.film().height) / 2;
        s.picked_pyray = pyray;
        // The report on the pixel comes from another thread.
        (void)rig.frames_until(
            [&] { return rig.controls().contains("Pyray/1") || rig.controls().contains("Back"); },
            2.0);
        s.picked_pyray = pyray;
      });
    use_all("curved mirrors", [&] { settings().mirror.curved = CurvedMirror::adaptive; });
    use_all("a material's own blur", [&] { rig.edits().edit_dfrs()[0].emplace(); });
  }

  void use_rivals_limits_and_lens() {
    use_all("a rival of a finished picture", [&] {
      rig.unfold("Compare");
      s.frames.with = CompareWith::method;
      (void)rig.settle();
    });
    use_all("another rival", [&] {
      for (const char* section : {"Refinement", "Sky", "Compare"}) rig.unfold(section);
      s.frames.with = CompareWith::method;
      s.equal_time.method = Method::stochastic;
      rig.refinement().limits().rmse = 0.01;
    });
    for (const bool paused : {false, true})
      use_all("refinement", [&, paused] {
        rig.refinement().set_paused(paused);
        s.frames.with = CompareWith::reference;
        s.check.check = !paused;
      });
    for (const bool waits : {false, true})
      use_all("a lens", [&, waits] {
        set_lens({0.01, 2.0, 6, 0.0});
        s.lens.click_to_focus = waits;
      });
    use_all("no lens", [&] { set_lens({}); });
    use_all("surfaces", [&] { rig.unfold("Surfaces"); });
    use_all("stopped", [&] {
      rig.refinement().set_paused(false);
      ASSERT_TRUE(rig.settle());
    });
  }

  void use_skies() {
    use_all("a sky of one colour",
            [&] { settings().sky = std::make_shared<const Sky>(glm::vec3(2.0f)); });
    use_all("a background of colours",
            [&] { settings().background.kind = BackgroundKind::colours; });
    settings().background = {};
    use_all("a preset sky",
            [&] { settings().sky = std::make_shared<const Sky>(Environment::studio); });
    use_all("a gradient", [&] { s.sky.gradient = true; });
    use_all("a gradient of two colours", [&] {
      settings().sky = std::make_shared<const Sky>(glm::vec3(0.2f), glm::vec3(0.5f));
    });
    use_all("a sky from a file", [&] {
      s.sky.path = "missing.hdr";
      settings().sky = std::make_shared<const Sky>(
          SkyMap(2, 1, std::vector<glm::vec3>(2, glm::vec3(0.5f))), 0.0, "half");
    });
  }

  void use_sections() {
    use_all("outline", [&] {
      rig.unfold("Objects");
      // The list is laid out only if it is visible.
      (void)rig.control("section/Scene");
    });
    rig.click("section/Objects");
    use_all("study", [&] { rig.unfold("Error vs. time"); });
    use_all("study, custom", [&] {
      s.study.automatic = false;
      rig.unfold("Error vs. time");
    });
    use_all("other choices", [&] {
      settings().asos.leaf = LeafKind::point;
      settings().asos.rule = StoppingRule::published;
      settings().asos.detect = Detection::cone;
      settings().texture.filter = TextureFilter::point;
      s.display.tone = ToneCurve::none;
      settings().shadow.light_rule = LightRule::published;
      s.study.automatic = false;
      s.study.reduction = 1;
      s.frames.store(rig.film(), "one", "");
      s.frames.store(rig.film(), "two", "");
      s.frames.chosen = 0;
    });
  }

  void use_dialogs() {
    use_all("open dialog", [&] {
      s.show_open = true;
      s.browser.folder = files_.path();
      s.recent = {"third"};
    });
    use_all("open dialog, filtered", [&] {
      s.show_open = true;
      s.browser.folder = files_.path();
      rig.frame();
      s.browser.typed = "boxes";
    });
    use_all("open dialog, folders", [&] {
      s.show_open = true;
      s.browser.folder = files_.path() / "deep";
    });
    use_all("leaving", [&] {
      s.frames.store(rig.film(), "one", "");
      s.leaving.asked = true;
    });
    use_all("save dialog", [&] {
      s.save.show = true;
      s.save.size = {64, 32};
    });
    use_all("save dialog, turntable", [&] {
      s.save.show = true;
      s.save.what = SaveChoice::What::turntable;
      // MP4 is offered only if there is an ffmpeg.
      std::filesystem::create_directories(files_.path() / "programs");
      files_.write("programs/ffmpeg", "#!/bin/sh\n");
      std::filesystem::permissions(files_.path() / "programs" / "ffmpeg",
                                   std::filesystem::perms::owner_all);
      setenv("PATH", (files_.path() / "programs").c_str(), 1);
    });
    use_all("save dialog, MP4", [&] {
      s.save.show = true;
      s.save.what = SaveChoice::What::turntable;
      s.save.mp4 = true;
    });
    use_all("checked splits", [&] {
      s.check.check = true;
      s.frames.with = CompareWith::reference;
      rig.unfold("Compare");
      (void)rig.frames_until([&] { return s.frames.reference.film != nullptr; });
    });
    use_all("save scene dialog", [&] { s.save_scene.show = true; });
    use_all("save dialog, EXR", [&] {
      s.save.show = true;
      s.save.exr = true;
    });
    use_all("save dialog, EXR with all layers", [&] {
      s.save.show = true;
      s.save.exr = true;
      s.save.layers = SaveChoice::Layers::all;
    });
    use_all("save dialog, window", [&] {
      s.save.show = true;
      s.save.what = SaveChoice::What::window;
    });
    use_all("error", [&] {
      rig.scene().open("missing");
      ASSERT_TRUE(rig.frames_until([&] { return rig.scene().error().has_value(); }));
    });
  }

  void set_lens(const Lens& lens) {
    rig.camera().set_lens(lens);
    rig.unfold("Lens");
  }

  UiState& s = rig.state();
};

TEST_F(EveryControlTest, ChangesWhatItSaysAndHasATooltip) {
  ASSERT_TRUE(rig.opens("point light"));
  use_lights_and_methods();
  use_maps_tour_and_bar();
  use_comparisons();
  use_textures_and_mirrors();
  use_rivals_limits_and_lens();
  use_skies();
  use_sections();
  use_dialogs();
  use_what_did_nothing();
  for (const auto& [name, states] : states_)
    EXPECT_TRUE(used_.contains(name)) << name << " did nothing";
  enter([] {});
  if (rig.content().study().busy()) rig.click("Stop measuring");  // a drag elsewhere started one
  ASSERT_TRUE(rig.frames_until([&] { return !rig.content().study().busy(); }));
  // Opening another scene later would end the study.
  ASSERT_TRUE(rig.settle());
  const auto offers = [&](const char* name) { return rig.controls().contains(name); };
  rig.unfold("Error vs. time");
  rig.click("Measure");
  EXPECT_TRUE(rig.content().study().busy())
      << s.study.error << (offers("Measure") ? "still offered" : "gone") << ", "
      << s.study.rivals.size() << " rivals";
  rig.frame();
  rig.click("Stop measuring");
  EXPECT_TRUE(rig.frames_until([&] { return !rig.content().study().busy(); }));
  for (const auto& [name, part] : parts)
    // Whether a render reaches its limit before it is finished depends on timing.
    EXPECT_TRUE(reached_.contains(name) || name == "Copy warnings" || name == "Continue")
        << name << " was not seen";
}

}  // namespace
}  // namespace asos
