#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

// Uses every control that the window shows, in as many states as it takes to see them all: each has
// a tooltip, and changes what the table below says of it. A control that the table does not know
// fails the test.

namespace asos {
namespace {

using test::PanelsTest;

enum class Part { settings, display, lights, camera, view, choice, frames, study, files, message };

/// By the name, or by its beginning up to a slash.
const std::map<std::string, Part> parts{
    {"Method", Part::settings},
    {"EPS", Part::settings},
    {"MAX", Part::settings},
    {"Leaf", Part::settings},
    {"Rule", Part::settings},
    {"Detection", Part::settings},
    {"Shading", Part::settings},
    {"Jitter", Part::settings},
    {"Samples", Part::settings},
    {"Seed", Part::settings},
    {"Textures", Part::settings},
    {"Culling", Part::settings},
    {"Shadows", Part::settings},
    {"Quality", Part::view},
    {"Divisions", Part::settings},
    {"Light rule", Part::settings},
    {"Exposure", Part::display},
    {"Split map", Part::display},
    {"Dimming", Part::display},
    {"Colours", Part::display},
    {"Light on", Part::lights},
    {"Light", Part::choice},
    {"Add light", Part::lights},
    {"Remove light", Part::lights},
    {"Face to light", Part::lights},
    {"Reset lights", Part::lights},
    {"Type", Part::lights},
    {"Colour", Part::lights},
    {"Intensity", Part::lights},
    {"Radius", Part::lights},
    {"Length", Part::lights},
    {"Width", Part::lights},
    {"Height", Part::lights},
    {"Sun's angle", Part::lights},
    {"Cone", Part::lights},
    {"Full inside", Part::lights},
    {"Outline", Part::lights},
    {"Position", Part::lights},
    {"Azimuth", Part::lights},
    {"Elevation", Part::lights},
    {"Roll", Part::lights},
    {"Two-sided", Part::lights},
    {"Shadowing", Part::lights},
    {"Marks", Part::choice},
    {"Mark", Part::lights},
    {"Store frame", Part::frames},
    {"Remove frame", Part::frames},
    {"Frame", Part::frames},
    {"Compare", Part::frames},
    {"Wipe", Part::frames},
    {"Wipe line", Part::frames},
    {"Stored shown", Part::frames},
    {"Scale", Part::frames},
    {"View", Part::view},
    {"Frame all", Part::camera},
    {"Reset view", Part::camera},
    {"Study", Part::study},
    {"Size", Part::study},
    {"Budget", Part::study},
    {"Repetitions", Part::study},
    {"Open...", Part::view},
    {"Save picture", Part::message},
    {"Reload", Part::files},
    {"Watch file", Part::choice},
    {"Forget settings", Part::display},
    {"Open", Part::files},
    {"Cancel", Part::view},
    {"Built-in", Part::files},
    {"Recent", Part::files},
    {"Copy", Part::message},
    {"Close", Part::message},
    {"Copy warnings", Part::message},
    {"Boundaries", Part::choice},
    {"Close pixel", Part::choice},
};

class EveryControlTest : public PanelsTest {
 protected:
  EveryControlTest() {
    ImGui::GetIO().ClipboardUserData = &clipboard_;
    ImGui::GetIO().SetClipboardTextFn = [](void* to, const char* text) {
      *static_cast<std::string*>(to) = text;
    };
    rig.resize({646, 480});  // small: many frames are drawn
    EXPECT_TRUE(rig.settle());
    initial_ = settings();
    setenv("XDG_PICTURES_DIR", testing::TempDir().c_str(), 1);
  }

  /// What a control of this part changes.
  [[nodiscard]] std::string state_of(Part part) {
    UiState& s = rig.content().state();
    Previewer& p = rig.previewer();
    const auto numbers = [](auto... values) {
      std::string text;
      ((text += std::to_string(values) + " "), ...);
      return text;
    };
    const RenderSettings& r = p.settings();
    const DisplaySettings& d = s.display;
    switch (part) {
      case Part::settings:
        return numbers(static_cast<int>(r.method), r.eps, r.max_level, static_cast<int>(r.leaf),
                       static_cast<int>(r.rule), static_cast<int>(r.detect), r.refine_shading,
                       r.jitter, r.spp, r.seed, static_cast<int>(r.texture_filter), r.cull,
                       r.shadows, static_cast<int>(r.shadow_quality), r.shadow_divisions,
                       static_cast<int>(r.light_rule));
      case Part::display:
        return numbers(d.exposure_ev, d.show_split_map, d.split_dimming,
                       static_cast<int>(d.split_colours));
      case Part::lights:
        return numbers(p.edits().lights_revision);
      case Part::camera:
        return numbers(p.camera().revision());
      case Part::view:
        return numbers(s.show_open, ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup),
                       ImGui::GetIO().WantTextInput);
      case Part::choice:
        return numbers(s.lights.selected, s.lights.show_marks, s.watch, s.show_boundaries,
                       s.picked.has_value());
      case Part::frames:
        return numbers(s.frames.stored.size(), s.frames.chosen,
                       static_cast<int>(s.frames.comparison), s.frames.wipe, s.frames.flipped,
                       s.frames.scale_stops);
      case Part::study:
        return numbers(s.study.rivals.size(), s.study.budget_seconds, s.study.repetitions,
                       s.study.reduction, rig.content().study().busy()) +
               s.study.error;
      case Part::files:
        return numbers(p.scenes_opened(), p.loading().has_value()) + p.asked_for();
      case Part::message:
        return s.message + clipboard_ + numbers(p.error().has_value());
    }
    return {};
  }

  /// Clicks, at several places, and drags, until what the control belongs to has changed.
  [[nodiscard]] bool changes(const std::string& name, Part part) {
    const std::string before = state_of(part);
    // What was tried in full once is a choice that waits for another state: a click tells.
    const bool again = !tried_.insert(name).second;
    // First, because a click may open something over the control.
    for (const float pixels : {-40.0f, 25.0f}) {
      if (again) break;
      if (!rig.content().controls().all().contains(name)) return false;
      const glm::vec2 from = rig.control(name).centre();
      rig.drag(from, from + glm::vec2(pixels, 0.0f));
      if (state_of(part) != before) return true;
    }
    for (const float share : {0.5f, 0.15f, 0.85f}) {
      if (!rig.content().controls().all().contains(name)) return false;
      const Controls::Placed at = rig.control(name);
      rig.move_to({glm::mix(at.lo.x, at.hi.x, share), at.centre().y});
      rig.press(MouseButton::left);
      rig.release(MouseButton::left);
      rig.frame();
      if (state_of(part) != before) return true;
      if (again) return false;
    }
    return false;
  }

  /// Back to the beginning, then into the state.
  void enter(const std::function<void()>& state) {
    if (rig.previewer().error()) rig.previewer().dismiss_error();
    rig.key(Key::escape);
    // A list that is open closes when something else is clicked: the status line.
    rig.move_to({3.0f, static_cast<float>(rig.size().y) - 3.0f});
    rig.press(MouseButton::left);
    rig.release(MouseButton::left);
    rig.content().state() = UiState{};
    clipboard_.clear();
    rig.content().state().display.exposure_ev = 1.0f;  // so that there is something to forget
    settings() = initial_;
    rig.previewer().reset_lights();
    state();
    for (int i = 0; i < 2; ++i) rig.frame();
  }

  void use_all(const std::string& where, const std::function<void()>& state) {
    enter(state);
    std::vector<std::string> names;
    for (const auto& [name, placed] : rig.content().controls().all()) {
      if (!placed.edits) continue;
      EXPECT_TRUE(placed.has_tooltip) << name << ", " << where;
      // Some of the built-in scenes take long to load.
      if (name.starts_with("Built-in/") && name != "Built-in/boxes") continue;
      if (name == "Start study") continue;  // comes last
      seen_.insert(name);
      if (!used_.contains(name)) names.push_back(name);
    }
    for (const std::string& name : names) {
      const std::string head = name.substr(0, name.find('/'));
      const auto known = parts.contains(name) ? parts.find(name) : parts.find(head);
      ASSERT_TRUE(known != parts.end()) << name << " has no test";
      enter(state);
      if (!rig.content().controls().all().contains(name)) continue;
      // What is chosen already changes nothing; another state has another choice.
      if (changes(name, known->second)) {
        used_.insert(name);
        reached_.insert(known->first);
      }
      ASSERT_TRUE(rig.frames_until([&] { return !rig.previewer().loading(); }));
    }
  }

  [[nodiscard]] LightChoice& lights() { return rig.content().state().lights; }
  void select_kind(LightKind kind) {
    lights().selected = 0;
    Light& light = rig.previewer().edit_lights()[0].light;
    light = as_kind(light, kind, SceneSize{});
    move_light(light, glm::dvec3(0, 0, 1) - light.position);
  }

  RenderSettings initial_;
  std::set<std::string> seen_;
  std::set<std::string> tried_;
  std::set<std::string> used_;
  std::set<std::string> reached_;  // of the table
  std::string clipboard_;
};

TEST_F(EveryControlTest, ChangesWhatItSaysAndHasATooltip) {
  rig.previewer().open("point light");
  ASSERT_TRUE(rig.frames_until([&] { return rig.previewer().scene()->source == "point light"; }));
  UiState& s = rig.content().state();
  use_all("a pixel was clicked", [&] {
    lights().selected = 0;
    s.picked = glm::ivec2(rig.previewer().film().width, rig.previewer().film().height) / 2;
  });
  for (const auto kind :
       {LightKind::point, LightKind::sphere, LightKind::spot, LightKind::directional,
        LightKind::linear, LightKind::rectangle, LightKind::disk, LightKind::polygon})
    use_all("light of kind " + std::to_string(static_cast<int>(kind)), [&] { select_kind(kind); });
  for (const auto method : {Method::sobol, Method::stochastic, Method::asos_published})
    use_all("method " + std::to_string(static_cast<int>(method)),
            [&] { settings().method = method; });
  use_all("soft shadows, divided", [&] {
    select_kind(LightKind::sphere);
    settings().shadow_quality = ShadowQuality::extended_divided;
  });
  for (const auto colours : {SplitMapColours::level, SplitMapColours::cause})
    use_all("split map", [&] {
      s.display.show_split_map = true;
      s.display.split_colours = colours;
    });
  rig.click("section/Compare");
  for (const auto comparison :
       {Comparison::none, Comparison::wipe, Comparison::flip, Comparison::difference})
    use_all("compare", [&] {
      s.frames.store(rig.previewer().film(), "one");
      s.frames.store(rig.previewer().film(), "two");
      s.frames.comparison = comparison;
    });
  rig.click("section/Error against run time");
  use_all("study", [] {});
  use_all("other choices", [&] {
    settings().leaf = Leaf::point;
    settings().rule = StoppingRule::published;
    settings().detect = Detection::cone;
    settings().texture_filter = TextureFilter::point;
    settings().light_rule = LightRule::published;
    s.study.reduction = 1;
    s.frames.store(rig.previewer().film(), "one");
    s.frames.store(rig.previewer().film(), "two");
    s.frames.chosen = 0;
  });
  use_all("open dialog", [&] {
    s.show_open = true;
    s.open_path = "second";
    s.recent = {"third"};
  });
  use_all("error", [&] {
    rig.previewer().open("missing");
    ASSERT_TRUE(rig.frames_until([&] { return rig.previewer().error().has_value(); }));
  });
  for (const std::string& name : seen_) EXPECT_TRUE(used_.contains(name)) << name << " did nothing";
  rig.click("Start study");
  EXPECT_TRUE(rig.content().study().busy());
  rig.frame();
  rig.click("Stop study");
  EXPECT_TRUE(rig.frames_until([&] { return !rig.content().study().busy(); }));
  for (const auto& [name, part] : parts)
    EXPECT_TRUE(reached_.contains(name) || name == "Copy warnings") << name << " was not seen";
}

}  // namespace
}  // namespace asos
