#include "ui/panels/side_panel.h"

#include "ui/panels/scenes_panel.h"
#include "ui/panels/surface_panel.h"
#include "ui/panels/timeline_panel.h"
#include "ui/panels/variants_panel.h"
#include "ui/screenshot.h"
#include "ui/split_check.h"
#include "ui/theme.h"
#include "ui/view_study.h"

#include <imgui.h>

#include <array>
#include <utility>

namespace asos::ui {

namespace {

void headline(Controls& controls, const RenderScene* scene) {
  theme::push_title();
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(scene ? file_title(scene->geometry->source).c_str() : "ASOS");
  ImGui::PopTextWrapPos();
  theme::pop_title();
  if (scene) controls.placed("Source", scene->geometry->source.c_str());
}

void file_buttons(Controls& controls, Previewer& previewer, UiState& state) {
  const RenderScene* scene = previewer.scene().get();
  // Less padding, so that three names fit into a row.
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {2.0f, ImGui::GetStyle().FramePadding.y});
  const int upper = controls.buttons(
      {{"Open...", "Open a scene (Ctrl+O), or drop a file on the window."},
       {"Save picture", "Save as PNG, with the split map if shown (P, F12)."},
       {"Save as...", "Save as EXR, at another size, with the window, or as a movie (Ctrl+S)."}});
  const int lower =
      controls.buttons({{"Save scene...", "Save as glTF with your lights and DFRs (Ctrl+Shift+S)."},
                        {"Copy picture", "Copy the picture to the clipboard (Ctrl+C)."},
                        {"Tour", "Five cards that explain the program."}});
  ImGui::PopStyleVar();
  state.show_open |= upper == 0;
  state.screenshot_requested |= upper == 1;
  state.save.show |= upper == 2;
  state.save_scene.show |= lower == 0 && scene;
  state.copy_requested |= lower == 1;
  state.tour_asked |= lower == 2;
  // A built-in scene cannot change.
  if (scene && !scene->geometry->source.starts_with("builtin:")) {
    if (controls.button("Reload", "Reload the file and keep the view (R).",
                        Controls::button_width(2)))
      previewer.scene().reload();
    ImGui::SameLine();
    ImGui::Checkbox("Watch file", &state.watch);
    controls.placed("Watch file", "Reload automatically when the file changes.",
                    Controls::Use::edits);
  }
}

void antialias_tab(Controls& controls, Previewer& previewer, UiState& state,
                   const PanelJobs& jobs) {
  antialiasing_panel(controls, previewer, jobs.forecast, state.bar, state.causes, state.max_turn);
  advanced_panel(controls, previewer);
  refinement_panel(controls, previewer, state.marks_part);
  display_panel(controls, state.display, state.bar);
  window_panel(controls, state.look);
}

void scene_tab(Controls& controls, Previewer& previewer, UiState& state, const PanelJobs& jobs) {
  const RenderScene* scene = previewer.scene().get();
  // The timeline comes first, so that its buttons stay in place while warnings come and go.
  timeline_panel(controls, previewer.playback(), previewer.edits().settings(),
                 state.bar.timeline && !controls.searches());
  scenes_panel(controls, previewer.scene());
  variants_panel(controls, previewer.scene());
  lights_panel(controls, previewer, state.lights, {state.pointed(), state.display.exposure_ev});
  shadows_panel(controls, previewer.edits().settings(), scene);
  reflections_panel(controls, previewer, state.reflections, state.pointed());
  sky_panel(controls, previewer.edits(), state.sky, jobs.sky_reader);
  camera_panel(controls, previewer);
  lens_panel(controls, previewer, state.lens);
  if (!scene) return;
  if (std::string said = outline_panel(controls, previewer, state.outline); !said.empty())
    state.said = std::move(said);
  surface_panel(controls, state.surfaces);
  scene_panel(controls, *scene, previewer.render().settings(), previewer.scene().load_seconds());
}

void measure_tab(Controls& controls, Previewer& previewer, UiState& state, const PanelJobs& jobs) {
  const RenderScene* scene = previewer.scene().get();
  compare_panel(controls, previewer, state, jobs);
  if (!scene) return;
  statistics_panel(controls, previewer.render().statistics(), previewer.render().settings(), *scene,
                   previewer.render().final_share());
  study_panel(controls, state.study, jobs.study, previewer);
  if (!state.study.said.empty()) state.said = std::exchange(state.study.said, {});
}

void tab_choice(Controls& controls, UiState& state) {
  constexpr std::array tabs{
      Controls::Option{"Antialias", "Method, EPS, MAX, rendering limits, display."},
      Controls::Option{"Scene", "Animation, lights, sky, materials, camera, objects."},
      Controls::Option{"Measure", "Snapshots, equal time, checks, statistics, study."},
  };
  // A search covers all tabs; choosing a tab ends it.
  const bool one = state.tab != PanelTab::all && state.search.empty();
  int tab = one ? static_cast<int>(state.tab) : -1;
  if (!controls.options("Tab", tabs, tab, {false, std::nullopt})) return;
  state.tab = static_cast<PanelTab>(tab);
  state.search.clear();
}

// Draws the search field. Escape empties it.
void search_field(Controls& controls, UiState& state) {
  if (std::exchange(state.focus_search, false)) ImGui::SetKeyboardFocusHere();
  std::array<char, 64> text{};
  state.search.copy(text.data(), text.size() - 1);
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##search", "Search controls (Ctrl+F)", text.data(), text.size());
  const bool left =
      ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  controls.placed("Search", "Show the sections whose controls have this in their names.",
                  Controls::Use::edits);
  state.search = left ? std::string() : std::string(text.data());
  controls.search(state.search);
}

void sections(Controls& controls, Previewer& previewer, UiState& state, const PanelJobs& jobs) {
  if (const RenderScene* scene = previewer.scene().get()) {
    // Animations and variants have their own sections.
    SceneNotes notes = notes_of(*scene);
    notes.not_shown.clear();
    warnings_panel(controls, notes, previewer.scene());
  }
  search_field(controls, state);
  tab_choice(controls, state);
  const auto shows = [&](PanelTab tab) {
    return state.tab == tab || state.tab == PanelTab::all || !state.search.empty();
  };
  if (shows(PanelTab::antialias)) antialias_tab(controls, previewer, state, jobs);
  if (shows(PanelTab::scene)) scene_tab(controls, previewer, state, jobs);
  if (shows(PanelTab::measure)) measure_tab(controls, previewer, state, jobs);
  if (!state.search.empty() && !controls.found_any()) {
    ImGui::TextDisabled("No match");
    controls.placed("No match", nullptr);
  }
  controls.search({});
}

void reset_choice(Controls& controls, Previewer& previewer, UiState& state) {
  constexpr std::array parts{
      Controls::Option{"Settings",
                       "Restore method, lights, shadows, reflections, sky and materials. The view "
                       "stays. Undo with Ctrl+Z."},
      Controls::Option{"Lights", "Restore the scene's lights."},
      Controls::Option{"Mirrors", "Restore the materials and the default reflection settings."},
      Controls::Option{"Window", "Restore display and panel, and clear recent files."},
  };
  ImGui::Spacing();
  int part = -1;
  if (!controls.options("Reset", parts, part)) return;
  SceneEdits& edits = previewer.edits();
  if (part == 0) edits.reset();
  if (part == 1) edits.reset_lights();
  if (part == 2) {
    edits.reset_dfrs();
    edits.settings().mirror = RenderSettings{}.mirror;
  }
  if (part == 3) state.forget = true;
  // The editor closes if its light was an added one.
  if (state.lights.selected >= static_cast<int>(edits.lights().size())) state.lights.selected = -1;
}

}  // namespace

void side_panel(Controls& controls, Previewer& previewer, UiState& state, const PanelJobs& jobs) {
  headline(controls, previewer.scene().get());
  file_buttons(controls, previewer, state);
  sections(controls, previewer, state, jobs);
  reset_choice(controls, previewer, state);
}

}  // namespace asos::ui
