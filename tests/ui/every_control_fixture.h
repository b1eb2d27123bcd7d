#pragma once

#include "tests/support/temporary_folder.h"
#include "tests/ui/control_parts.h"
#include "tests/ui/panels_fixture.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace asos::test {

/// Uses all controls that a state of the window shows, each once. Each has a tooltip, and changes
/// the part of the state that the table of parts names. A control that is missing in the table
/// fails the test.
class EveryControlFixture : public PanelsTest {
 protected:
  EveryControlFixture() : PanelsTest(8, small) {
    ImGui::GetIO().ClipboardUserData = &clipboard_;
    ImGui::GetIO().SetClipboardTextFn = [](void* to, const char* text) {
      *static_cast<std::string*>(to) = text;
    };
    initial_ = settings();
    setenv("XDG_PICTURES_DIR", testing::TempDir().c_str(), 1);
    files_.write("model.glb", "no model");
    std::filesystem::create_directories(files_.path() / "deep" / "deeper");
  }

  static constexpr glm::ivec2 small{646, 480};  // many frames are drawn

  /// The state that a control of this part changes.
  [[nodiscard]] std::string state_of(Part part) {
    UiState& s = rig.state();
    Previewer& p = rig.previewer();
    const auto numbers = [](auto... values) {
      std::string text;
      ((text += fmt::format("{} ", values)), ...);
      return text;
    };
    const RenderSettings& r = p.edits().settings();
    const DisplaySettings& d = s.display;
    switch (part) {
      case Part::settings:
        return numbers(
            static_cast<int>(r.method), r.asos.eps, r.asos.max_level, static_cast<int>(r.asos.leaf),
            static_cast<int>(r.asos.rule), static_cast<int>(r.asos.detect), r.asos.refine_shading,
            r.asos.jitter, r.filter_width, r.line_width, r.sampling.spp, r.seed,
            static_cast<int>(r.texture.filter), r.cull, r.shadow.cast,
            static_cast<int>(r.shadow.quality), r.shadow.bounces, r.shadow.divisions,
            static_cast<int>(r.shadow.light_rule), r.texture.resolution, r.mirror.bounces,
            r.mirror.roughest, static_cast<int>(r.mirror.curved), r.mirror.widest_angle_deg);
      case Part::mirrors: {
        std::string text = numbers(p.edits().state().look.dfrs_revision, r.mirror.dfr.has_value());
        for (const DfrCurve& c : r.mirror.dfr.value_or(Dfr{}).rgb)
          text += numbers(c.min, c.max, c.exponent);
        return text + numbers(r.mirror.dfr.value_or(Dfr{}).perturbation);
      }
      case Part::sky:
        return s.sky.error + (r.sky ? r.sky->name() : "") +
               numbers(s.sky.file, r.sky.use_count(), r.shadow.sky,
                       static_cast<int>(r.background.kind), static_cast<int>(r.ground),
                       r.background.top.x, r.background.top.y, r.background.top.z,
                       r.background.bottom.x, r.background.bottom.y, r.background.bottom.z);
      case Part::check:
        return numbers(static_cast<int>(s.equal_time.method), s.equal_time.restarts, s.check.check,
                       s.check.alarm, s.check.mark_missed, s.check.mark_wasted);
      case Part::limits:
        return numbers(s.marks_part, p.render().preferred().width, p.refinement().paused(),
                       static_cast<int>(p.refinement().rest()), p.refinement().limits().seconds,
                       p.refinement().limits().rmse, p.render().restarts());
      case Part::window:
        return numbers(static_cast<int>(s.look.theme), s.look.scale, s.look.show_bar);
      case Part::tour:
        return numbers(s.tour.card ? static_cast<int>(*s.tour.card) : -1, s.tour.since_seconds);
      case Part::display:
        return numbers(d.exposure_ev, d.auto_exposure, static_cast<int>(d.tone), d.show_split_map,
                       d.show_legend, d.show_grid, d.show_axes, d.show_scale, d.split_dimming,
                       static_cast<int>(d.split_colours));
      case Part::lights:
        return numbers(p.edits().state().look.lights_revision);
      case Part::camera:
        return numbers(p.viewpoint().camera().revision());
      case Part::turntable:
        return numbers(p.turntable().turning(), p.turntable().seconds_a_turn);
      case Part::view:
        return s.browser.folder.string() + numbers(s.show_open, s.leaving.quit,
                                                   static_cast<int>(s.tab),
                                                   ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup),
                                                   ImGui::GetIO().WantTextInput);
      case Part::choice:
        return numbers(s.lights.selected, s.lights.show_marks, s.lights.keep_power, s.watch,
                       s.show_boundaries, s.picked.has_value(),
                       static_cast<int>(s.reflections.channel), s.picked_pyray, s.outline.selected,
                       s.lens.click_to_focus, s.surfaces.wireframe);
      case Part::frames:
        return numbers(s.frames.stored.size(), s.frames.chosen, static_cast<int>(s.frames.with),
                       static_cast<int>(s.frames.comparison), s.frames.wipe, s.frames.flipped,
                       s.frames.scale_stops);
      case Part::study:
        return numbers(s.study.rivals.size(), s.study.budget_seconds, s.study.repetitions,
                       s.study.reduction, s.study.automatic, rig.content().study().busy()) +
               s.study.error;
      case Part::files:
        return numbers(p.scene().times_opened(), p.scene().loading().has_value()) +
               p.scene().asked_for() + s.opening.wanted;
      case Part::save:
        return numbers(static_cast<int>(s.save.what), s.save.exr, s.save.size.x, s.save.size.y,
                       s.save.show, s.save_scene.show, s.save.frames, s.save.fps, s.save.mp4,
                       static_cast<int>(s.save.layers));
      case Part::picture:
        return numbers(d.show_split_map, static_cast<int>(d.split_colours), s.show_before,
                       s.view.zoom(), static_cast<int>(s.frames.comparison),
                       ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
      case Part::message:
        return s.message + clipboard_ + numbers(p.scene().error().has_value());
    }
    return {};
  }

  /// Scrolls to the control; none if it has vanished meanwhile, as *Pause* does once the render has
  /// finished.
  [[nodiscard]] std::optional<Controls::Placed> still_there(const std::string& name) {
    if (!rig.controls().contains(name)) return std::nullopt;
    try {
      return rig.control(name);
    } catch (const std::runtime_error&) {
      return std::nullopt;
    }
  }

  /// Drags, and clicks at several places, until the control's part of the state has changed.
  [[nodiscard]] bool changes(const std::string& name, Part part) {
    const std::string before = state_of(part);
    // A control tried before needs another state to change something; a single click is enough
    // then.
    const bool again = !tried_.insert(name).second;
    // Drags first, because a click may open something over the control.
    for (const glm::vec2 way : {glm::vec2(-40, -20), glm::vec2(25, 20)}) {
      if (again) break;
      const std::optional<Controls::Placed> at = still_there(name);
      if (!at) return false;
      rig.drag(at->centre(), at->centre() + way);
      if (state_of(part) != before) return true;
      rig.rest();  // so that no double click resets
    }
    for (const float share : {0.5f, 0.15f, 0.85f}) {
      const std::optional<Controls::Placed> at = still_there(name);
      if (!at) return false;
      rig.move_to({glm::mix(at->lo.x, at->hi.x, share), at->centre().y});
      rig.press(MouseButton::left);
      rig.release(MouseButton::left);
      rig.frame();
      if (state_of(part) != before) return true;
      if (again) return false;
    }
    return false;
  }

  /// Restores the initial state, then enters the given one.
  void enter(const std::function<void()>& state) {
    if (rig.size() != small) rig.resize(small);
    if (rig.scene().error()) rig.scene().dismiss_error();
    rig.key(Key::escape);
    // An open list closes when something else is clicked: the status line.
    rig.move_to({3.0f, static_cast<float>(rig.size().y) - 3.0f});
    rig.press(MouseButton::left);
    rig.release(MouseButton::left);
    rig.state() = UiState{};
    // "Reset/Window" folds sections.
    StoredSettings stored = rig.content().stored_settings();
    stored.tab = PanelTab::all;
    stored.sections["Advanced (papers)"] = true;
    rig.content().apply(stored);
    clipboard_.clear();
    rig.state().display.exposure_ev = 1.0f;  // so that there is something to reset
    settings() = initial_;
    rig.edits().reset_lights();
    if (rig.edits().dfrs() != dfrs_of(rig.scene()->world())) rig.edits().reset_dfrs();
    rig.refinement().set_paused(false);
    rig.refinement().limits() = {};
    rig.previewer().turntable() = {};
    state();
    for (int i = 0; i < 2; ++i) rig.frame();
  }

  /// `state` is called again later, so it must not refer to the caller's loop variables.
  void use_all(const std::string& where, const std::function<void()>& state) {
    enter(state);
    std::vector<std::string> names;
    for (const auto& [name, placed] : rig.controls()) {
      if (!placed.edits) continue;
      EXPECT_TRUE(placed.has_tooltip) << name << ", " << where;
      // Some of the built-in scenes take long to load.
      if (name.starts_with("Built-in/") && name != "Built-in/boxes") continue;
      if (name == "Measure") continue;            // comes last
      if (name == "Cancel comparison") continue;  // exists only during a comparison: EqualTimeTest
      if (name == "Continue") continue;           // exists only at a render's limit: RefinementTest
      states_[name].push_back(state);
      if (!used_.contains(name)) names.push_back(name);
    }
    for (const std::string& name : names) use(name, state);
  }

  void use(const std::string& name, const std::function<void()>& state) {
    const std::string head = name.substr(0, name.find('/'));
    const auto known = parts.contains(name) ? parts.find(name) : parts.find(head);
    ASSERT_TRUE(known != parts.end()) << name << " has no test";
    enter(state);
    if (!rig.controls().contains(name)) return;
    // The chosen option changes nothing; in another state, another option is chosen.
    if (changes(name, known->second)) {
      used_.insert(name);
      reached_.insert(known->first);
    }
    ASSERT_TRUE(rig.frames_until([&] { return !rig.scene().loading(); }));
  }

  /// A row moved by another thread's results may have been missed, so try again.
  void use_what_did_nothing() {
    for (const auto& [name, states] : states_) {
      for (const std::function<void()>& state : states)
        if (!used_.contains(name)) use(name, state);
    }
  }

  [[nodiscard]] LightChoice& lights() { return rig.state().lights; }
  void select_kind(LightKind kind) {
    lights().selected = 0;
    Light& light = rig.edits().edit_lights()[0].light;
    light = as_kind(light, kind, SceneSize{});
    move_light(light, glm::dvec3(0, 0, 1) - light.position);
  }

  RenderSettings initial_;
  std::map<std::string, std::vector<std::function<void()>>> states_;  // states that show it
  std::set<std::string> tried_;
  std::set<std::string> used_;
  std::set<std::string> reached_;  // entries of the table
  TemporaryFolder files_;
  std::string clipboard_;
};

}  // namespace asos::test
