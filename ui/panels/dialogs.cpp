#include "renderer/study/ladders.h"
#include "ui/input.h"
#include "ui/panels/overlay_window.h"
#include "ui/panels/overlays.h"
#include "ui/panels/surface_panel.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <utility>

namespace asos::ui {

namespace {

struct HelpLine {
  const char* input;
  const char* meaning;
};
constexpr std::array help_lines{
    HelpLine{"Left drag", "orbit"},
    HelpLine{"Middle drag, Shift + left drag", "pan"},
    HelpLine{"Wheel", "move closer, farther"},
    HelpLine{"Double click", "orbit about this point"},
    HelpLine{"Right drag, with W A S D Q E", "look around, fly; Shift: faster"},
    HelpLine{"Shift + right drag", "turn lights and sky; up, down: brightness"},
    HelpLine{"Home; F", "frame the whole scene; the selected object"},
    HelpLine{"Keypad or Shift + 1, 3, 7; 5", "front, right, top, Ctrl: opposite; orthographic"},
    HelpLine{"T", "turntable on or off"},
    HelpLine{"Click", "select an object"},
    HelpLine{"Click again, Ctrl + click", "inspect a pixel"},
    HelpLine{"H, Shift + H, Alt + H", "hide, isolate object; show all"},
    HelpLine{nullptr, nullptr},
    HelpLine{"Ctrl + wheel, + and -", "zoom into the pixels"},
    HelpLine{"Right drag, zoomed", "move the picture"},
    HelpLine{"0", "zoom back to 1:1"},
    HelpLine{"S, X", "keep snapshot, switch to it and back"},
    HelpLine{"1 to 9", "show snapshot, and picture again"},
    HelpLine{"M", "split map"},
    HelpLine{"C", "split map by level, cause, rays, time"},
    HelpLine{"V", "last finished EPS and MAX, and back"},
    HelpLine{"Z, Z + left drag", "refine this part first; Z again: all"},
    HelpLine{"B, N, G, L", "base color, normal, roughness, metallic"},
    HelpLine{"K, I, U; Y", "occlusion, emission, UV checker; wireframe"},
    HelpLine{"[, ]", "previous, next layer in false colours"},
    HelpLine{"Space", "play or pause animation, else rendering"},
    HelpLine{"Ctrl + Z, Ctrl + Shift + Z", "undo, redo"},
    HelpLine{"Double click on a control", "reset it"},
    HelpLine{"Tab", "hide or show the panel"},
    HelpLine{"Ctrl + F", "search the panel's controls"},
    HelpLine{"F6, arrows, Space, Enter", "use the panel by keyboard"},
    HelpLine{nullptr, nullptr},
    HelpLine{"Ctrl + O, drop a file", "open a scene; drop .hdr, .exr: sky"},
    HelpLine{"Page Up, Page Down", "previous, next model of the folder"},
    HelpLine{"R", "reload the file"},
    HelpLine{"P, F12", "save the picture as PNG"},
    HelpLine{"Ctrl + S", "save as EXR, larger, or with the window"},
    HelpLine{"Ctrl + Shift + S", "save the scene with lights and DFRs"},
    HelpLine{"Ctrl + C", "copy the picture"},
    HelpLine{"F1, ?", "this help"},
    HelpLine{"Esc; Ctrl + Q", "close what is open; quit"},
};

}  // namespace

// Centred over the picture where there is room, else over the window. It scrolls if it is higher.
void help_overlay(Controls& controls, UiState& state, const WindowRect& area) {
  if (!state.show_help) return;
  const float em = ImGui::GetFontSize(), padding = 1.2f * em;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float usual = 42.0f * em;
  const float height = 2.0f * padding + ImGui::GetTextLineHeightWithSpacing() *
                                            static_cast<float>(help_lines.size());
  const bool fits = usual <= area.size.x && height <= area.size.y;
  const ImVec2 centre = fits
                            ? ImVec2(area.lo.x + 0.5f * area.size.x, area.lo.y + 0.5f * area.size.y)
                            : ImVec2(0.5f * window.x, 0.5f * window.y);
  const float width = std::min(usual, window.x - em);
  ImGui::SetNextWindowPos(centre, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, window.y - em});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {padding, padding});
  const OverlayWindow help("help", ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PopStyleVar();
  const float column = 0.45f * ImGui::GetContentRegionAvail().x;
  for (const HelpLine& line : help_lines) {
    if (!line.input) {
      ImGui::Dummy({0.0f, 0.4f * em});
      continue;
    }
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(column);
    ImGui::TextUnformatted(line.input);
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
    ImGui::SameLine(column + 0.5f * em);
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(0.0f);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
    ImGui::TextUnformatted(line.meaning);
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
  }
  controls.placed_window("Help");
}

namespace {

void say_flipped(UiState& state, const Film& film) {
  const Frames& frames = state.frames;
  state.said = frames.flipped ? frames.compared_title() : std::string("Current picture");
  if (!frames.flipped) return;
  if (frames.with != CompareWith::reference)
    state.said = fmt::format("Snapshot {}: {}", frames.chosen + 1, state.said);
  const Film& other = frames.film(*frames.compared());
  if (other.width != film.width || other.height != film.height)
    state.said += fmt::format(", resampled from {} x {}", other.width, other.height);
}

// Toggles between the picture and the one that it is compared with.
void flip(UiState& state, const Film& film) {
  Frames& frames = state.frames;
  const bool shown = frames.comparison == Comparison::flip && frames.flipped;
  const Comparison before = std::exchange(frames.comparison, Comparison::flip);
  if (!frames.compared()) {
    frames.comparison = before;
    state.said = frames.with == CompareWith::reference ? "No reference yet"
                                                       : "No snapshot yet: press S to keep one";
    return;
  }
  frames.flipped = state.shows_layer() || !shown;
  state.leave_layer();
  say_flipped(state, film);
}

// Shows the snapshot of a number key, or the picture again.
void snapshot_keys(UiState& state, const Film& film) {
  constexpr std::array keys{Key::one, Key::two,   Key::three, Key::four, Key::five,
                            Key::six, Key::seven, Key::eight, Key::nine};
  static_assert(keys.size() == Frames::most);
  if (ImGui::GetIO().KeyShift) return;  // Shift + digit: camera views
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!shortcut_pressed(keys[i])) continue;
    if (i >= state.frames.stored.size()) {
      state.said = fmt::format("No snapshot {} yet: press S to keep one", i + 1);
      return;
    }
    state.leave_layer();
    state.frames.flip_to(static_cast<int>(i));
    say_flipped(state, film);
  }
}

// Toggles between the picture and that of the last finished EPS and MAX.
void show_before(UiState& state, const PreviewRender& render) {
  const PreviewRender::FinishedPicture* before = render.finished_before();
  if (!before) {
    state.said = "Change EPS or MAX first";
    return;
  }
  state.show_before = state.shows_layer() || !state.show_before;
  state.leave_layer();
  state.said = state.show_before
                   ? fmt::format("Before: EPS {}, MAX {}", eps_text(before->settings.asos.eps),
                                 before->settings.asos.max_level)
                   : std::string("Current picture");
}

// Opens another model of the folder.
void page(UiState& state, Previewer& previewer, int step) {
  if (previewer.scene().asked_for().empty()) return;
  // A file that cannot be opened was asked for, too, so that the next one follows it.
  const std::optional<NextModel> next = next_model(previewer.scene().asked_for(), step);
  if (!next) {
    state.said = "No other model in this folder";
    return;
  }
  state.opening = {next->path};
  state.said = fmt::format("{} of {}: {}", next->number, next->count,
                           std::filesystem::path(next->path).filename().string());
}

// Plays the animation if there is one, and pauses rendering otherwise.
void play_or_pause(Previewer& previewer) {
  Playback& playback = previewer.playback();
  if (playback.available()) return playback.set_playing(!playback.playing());
  Refinement& refinement = previewer.refinement();
  if (refinement.at_limit() && !refinement.paused()) {
    refinement.go_on();
  } else {
    refinement.set_paused(!refinement.paused());
  }
}

// Returns whether a view's key was pressed: on the keypad, or a digit with Shift.
bool view_key(Key pad, Key digit, bool opposite) {
  return shortcut_pressed(pad, opposite) ||
         (ImGui::GetIO().KeyShift && shortcut_pressed(digit, opposite));
}

void camera_shortcuts(Viewpoint& viewpoint) {
  using Side = Viewpoint::Side;
  constexpr std::array pads{Key::pad_one, Key::pad_three, Key::pad_seven};
  constexpr std::array digits{Key::one, Key::three, Key::seven};
  constexpr std::array sides{Side::front, Side::right, Side::top};
  constexpr std::array opposites{Side::back, Side::left, Side::bottom};
  for (std::size_t i = 0; i < pads.size(); ++i) {
    if (view_key(pads[i], digits[i], false)) viewpoint.look_from(sides[i]);
    if (view_key(pads[i], digits[i], true)) viewpoint.look_from(opposites[i]);
  }
  if (!view_key(Key::pad_five, Key::five, false)) return;
  OrbitCamera& camera = viewpoint.camera();
  const bool perspective = camera.camera().type == Camera::Type::perspective;
  camera.set_projection(perspective ? Camera::Type::orthographic : Camera::Type::perspective);
}

// The split map, which layers and the error hide.
void map_shortcuts(UiState& state) {
  const bool map = shortcut_pressed(Key::m), colour = shortcut_pressed(Key::c);
  if (!map && !colour) return;
  const bool hidden = state.frames.comparison >= Comparison::difference || state.shows_layer();
  state.leave_difference();
  state.leave_layer();
  if (map) state.display.show_split_map = hidden || !state.display.show_split_map;
  if (!colour) return;
  SplitMapColours& colours = state.display.split_colours;
  colours = colours == SplitMapColours::time
                ? SplitMapColours::level
                : static_cast<SplitMapColours>(static_cast<int>(colours) + 1);
}

// Toggles the display of surface properties.
void surface_shortcuts(UiState& state) {
  constexpr std::array keys{Key::b, Key::n, Key::g, Key::l, Key::k, Key::i, Key::u};
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!shortcut_pressed(keys[i])) continue;
    toggle(state.surfaces, static_cast<SurfaceProperty>(i));
    const char* title = surface_title(state.surfaces);
    state.said = title ? title : "Shaded picture";
  }
  if (shortcut_pressed(Key::y)) state.surfaces.wireframe = !state.surfaces.wireframe;
}

// Hides and frames objects.
void object_shortcuts(UiState& state, Previewer& previewer) {
  OpenScene& scene = previewer.scene();
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.NavVisible && shortcut_pressed(Key::home)) previewer.viewpoint().frame_all();
  if (shortcut_pressed(Key::f)) {
    Box box;
    for (const int part : selected_objects(scene, state.outline))
      box.grow(scene->world().parts[static_cast<std::size_t>(part)].bounds);
    box.empty() ? previewer.viewpoint().frame_all() : previewer.viewpoint().frame_box(box);
  }
  if (io.KeyAlt && !io.WantTextInput && ImGui::IsKeyPressed(static_cast<int>(Key::h), false))
    state.said = show_hidden(scene);
  if (shortcut_pressed(Key::h))
    state.said =
        io.KeyShift ? isolate_selected(scene, state.outline) : hide_selected(scene, state.outline);
}

// Shows the next or previous layer of the film in place of the picture.
void layer_shortcuts(UiState& state) {
  const int by = shortcut_pressed(Key::right_bracket)  ? 1
                 : shortcut_pressed(Key::left_bracket) ? -1
                                                       : 0;
  if (by == 0) return;
  show_next_layer(state.display, by);
  state.surfaces.property.reset();
  state.leave_difference();
  state.said = layer_title(state.display);
}

// Escape closes, one thing after the other, and never quits.
void close_something(UiState& state, Previewer& previewer) {
  if (state.show_help) {
    state.show_help = false;
  } else if (previewer.scene().error()) {
    previewer.scene().dismiss_error();
  } else if (state.tour.card) {
    end_tour(state, previewer);
  } else if (state.picked) {
    state.picked.reset();
  } else if (state.lights.selected >= 0) {
    state.lights.selected = -1;
  } else {
    state.outline.selected = state.outline.node = -1;
  }
}

}  // namespace

void handle_shortcuts(UiState& state, Previewer& previewer) {
  if (shortcut_pressed(Key::q, true)) state.leaving.asked = true;
  if (state.show_open || state.save.show || state.save_scene.show || state.popup_was_open) return;
  // While the panel has the keyboard focus, it uses some of the keys itself.
  const bool in_panel = ImGui::GetIO().NavVisible;
  if (shortcut_pressed(Key::o, true)) state.show_open = true;
  if (shortcut_pressed(Key::s, true)) {
    const bool scene = ImGui::GetIO().KeyShift;
    (scene ? state.save_scene.show : state.save.show) = !scene || previewer.scene();
  }
  if (!ImGui::GetIO().WantTextInput && shortcut_pressed(Key::c, true)) state.copy_requested = true;
  if (shortcut_pressed(Key::f, true)) {
    state.show_panel = true;
    state.focus_search = true;
  }
  if (shortcut_pressed(Key::f1) || shortcut_pressed(Key::question)) {
    state.show_help = !state.show_help;
  }
  if (shortcut_pressed(Key::f12) || shortcut_pressed(Key::p)) state.screenshot_requested = true;
  object_shortcuts(state, previewer);
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Right) && shortcut_pressed(Key::s) && previewer.scene())
    state.said = keep_snapshot(state.frames, previewer);
  if (shortcut_pressed(Key::r)) previewer.scene().reload();
  if (!in_panel && shortcut_pressed(Key::page_down)) page(state, previewer, 1);
  if (!in_panel && shortcut_pressed(Key::page_up)) page(state, previewer, -1);
  if (shortcut_pressed(Key::x)) flip(state, previewer.render().film());
  snapshot_keys(state, previewer.render().film());
  map_shortcuts(state);
  if (shortcut_pressed(Key::v)) show_before(state, previewer.render());
  if (shortcut_pressed(Key::z)) refine_here_first(state, previewer.render());
  if (!in_panel && shortcut_pressed(Key::space)) play_or_pause(previewer);
  if (shortcut_pressed(Key::f6)) state.focus_panel = true;
  if (shortcut_pressed(Key::tab)) state.show_panel = !state.show_panel;
  if (shortcut_pressed(Key::zero)) state.view.reset();
  if (previewer.scene()) camera_shortcuts(previewer.viewpoint());
  surface_shortcuts(state);
  layer_shortcuts(state);
  Turntable& turntable = previewer.turntable();
  if (previewer.scene() && shortcut_pressed(Key::t)) turntable.set_turning(!turntable.turning());
  const glm::vec2 middle = state.view.area_middle();
  if (shortcut_pressed(Key::plus)) state.view.zoom_at(middle, 1);
  if (shortcut_pressed(Key::minus)) state.view.zoom_at(middle, -1);

  if (shortcut_pressed(Key::escape)) close_something(state, previewer);
}

}  // namespace asos::ui
