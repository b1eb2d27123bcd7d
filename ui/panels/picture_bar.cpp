#include "renderer/comparison/method.h"
#include "ui/panels/overlays.h"
#include "ui/panels/surface_panel.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace asos::ui {

namespace {

constexpr float wide_em = 44.0f;    // of a bar with all controls
constexpr float layers_em = 10.5f;  // of the list of layers

constexpr std::array contents{
    Controls::Option{"Picture", "The picture alone (M)."},
    Controls::Option{"Level", "Split map: deepest level of each pixel (M, C)."},
    Controls::Option{"Cause", "Split map: why pixels are split (M, C)."},
    Controls::Option{"Rays", "Split map: rays per pixel (M, C)."},
    Controls::Option{"Time", "Split map: CPU time per pixel (M, C)."},
    Controls::Option{"Error",
                     "Error in display steps against a reference of 256 samples. Starts the "
                     "reference once the picture is finished."},
    Controls::Option{"Difference", "Difference from the chosen snapshot (S keeps one)."},
};
constexpr int error_content = static_cast<int>(contents.size()) - 2;
constexpr int difference_content = static_cast<int>(contents.size()) - 1;
constexpr int layer_content = -1;  // a layer or a surface property: none of the others

int shown_content(const UiState& state) {
  if (state.shows_layer()) return layer_content;
  if (state.frames.comparison == Comparison::error) return error_content;
  if (state.frames.compared() && state.frames.comparison == Comparison::difference)
    return difference_content;
  if (!state.display.show_split_map) return 0;
  return 1 + static_cast<int>(state.display.split_colours);
}

void show_content(UiState& state, int content) {
  state.leave_layer();
  Frames& frames = state.frames;
  if (content == difference_content && frames.stored.empty()) {
    state.said = "No snapshot yet: press S to keep one";
    return;
  }
  if (content >= error_content) {
    const bool error = content == error_content;
    frames.with = error ? CompareWith::reference : CompareWith::snapshot;
    frames.comparison = error ? Comparison::error : Comparison::difference;
    return;
  }
  state.leave_difference();
  state.display.show_split_map = content > 0;
  if (content > 0) state.display.split_colours = static_cast<SplitMapColours>(content - 1);
}

// The layers of the film, then the surface properties. The first entry shows none of them.
std::vector<std::string> layer_entries(const char* first) {
  std::vector<std::string> entries = layer_titles();
  entries.front() = first;
  for (int i = 0; i < surface_properties; ++i) entries.push_back(surface_entry(i));
  return entries;
}

int shown_layer(const UiState& state) {
  if (state.surfaces.property) return layer_count + static_cast<int>(*state.surfaces.property);
  return state.display.layer ? static_cast<int>(*state.display.layer) : 0;
}

void show_layer(UiState& state, int entry) {
  state.leave_layer();
  if (entry > 0) state.leave_difference();
  if (entry >= layer_count)
    state.surfaces.property = static_cast<SurfaceProperty>(entry - layer_count);
  else if (entry > 0)
    state.display.layer = static_cast<Layer>(entry);
}

// Places the controls of a row in cells.
class Cells {
 public:
  Cells(const char* row, float height) : row_(row), height_(height) {}
  template <typename F>
  void add(float width, const F& draw) {
    if (count_ > 0) ImGui::SameLine();
    ImGui::BeginChild(fmt::format("{}{}", row_, count_++).c_str(), {width, height_}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                          ImGuiWindowFlags_NoBackground);
    draw();
    ImGui::EndChild();
  }

 private:
  const char* row_;
  float height_;
  int count_ = 0;
};

// Marks the slider's value of the last finished picture. `share`: fraction of its width.
void ghost(const Controls& controls, const char* name, float share) {
  const Controls::Placed& at = controls.all().at(name);
  const float em = ImGui::GetFontSize();
  const float x = std::round(at.lo.x + std::clamp(share, 0.0f, 1.0f) * (at.hi.x - at.lo.x));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddLine({x, at.hi.y - 0.4f * em}, {x, at.hi.y}, theme::packed(theme::text, 0.7f),
               0.12f * em);
  draw.AddTriangleFilled({x - 0.3f * em, at.lo.y}, {x + 0.3f * em, at.lo.y},
                         {x, at.lo.y + 0.35f * em}, theme::packed(theme::text, 0.7f));
}

std::string eps_text(double eps) {
  if (eps <= 0.0) return "EPS 0";
  return eps > 0.1 ? fmt::format("EPS {:.2f}", eps) : fmt::format("EPS 1/{:.0f}", 1.0 / eps);
}

std::string level_text(int level) {
  return fmt::format("MAX {}", level);
}

void splitting_sliders(Controls& controls, Previewer& previewer, MaxTurn& turn, Cells& cells,
                       float width) {
  RenderSettings& settings = previewer.edits().settings();
  const RenderSettings usual;
  const PreviewRender::FinishedPicture* before = previewer.render().finished_before();
  cells.add(0.6f * width, [&] {
    controls.log_slider("EPS in bar",
                        "Largest error allowed per pixel, 0 to 1. Larger is faster. The mark is "
                        "the last finished value.",
                        settings.asos.eps, {0.0, 1.0, usual.asos.eps}, eps_text);
    if (before && before->settings.asos.eps != settings.asos.eps)
      ghost(controls, "EPS in bar", Controls::log_share(before->settings.asos.eps, 1.0));
  });
  cells.add(0.4f * width, [&] {
    const std::string tooltip =
        turn.added_to("Maximum splits per pixel, 0 to 8. The mark is the last finished value.");
    controls.slider("MAX in bar", tooltip.c_str(), settings.asos.max_level,
                    {0, max_level_limit, usual.asos.max_level}, level_text);
    explain_turned_max(controls, "MAX in bar", turn);
    if (before && before->settings.asos.max_level != settings.asos.max_level)
      ghost(controls, "MAX in bar",
            static_cast<float>(before->settings.asos.max_level) / max_level_limit);
  });
}

void before_button(Controls& controls, const Previewer& previewer, UiState& state) {
  const bool any = previewer.render().finished_before() != nullptr;
  const char* tooltip = any ? "Switch to the last finished EPS and MAX, and back (V)."
                            : "Comes with the second finished EPS or MAX.";
  if (controls.button(state.show_before ? "Now" : "Before", tooltip, -1.0f) && any)
    state.show_before = !state.show_before;
}

void zoom_buttons(Controls& controls, PictureView& view) {
  const float width = 1.7f * ImGui::GetFontSize();
  if (controls.button("-", "Zoom out (-).", width)) view.zoom_at(view.area_middle(), -1);
  ImGui::SameLine(0.0f, 2.0f);
  const std::string zoom = fmt::format("{}x", view.zoom());
  if (ImGui::Button(zoom.c_str(), {2.4f * ImGui::GetFontSize(), 0.0f})) view.reset();
  controls.placed("Zoom", "Zoom back to 1:1 (0).", Controls::Use::edits);
  ImGui::SameLine(0.0f, 2.0f);
  if (controls.button("+", "Zoom in (+).", width)) view.zoom_at(view.area_middle(), 1);
}

void layer_list(Controls& controls, UiState& state) {
  int entry = shown_layer(state);
  const ImVec4* colours = ImGui::GetStyle().Colors;
  ImGui::PushStyleColor(ImGuiCol_FrameBg,
                        colours[entry > 0 ? ImGuiCol_SliderGrab : ImGuiCol_Button]);
  if (controls.list("Layers in bar", "Layer or surface property ([ and ]).",
                    layer_entries(entry > 0 ? "None" : "View"), entry))
    show_layer(state, entry);
  ImGui::PopStyleColor();
}

// A list of everything that the picture area can show.
void content_list(Controls& controls, UiState& state) {
  std::vector<std::string> names;
  for (const Controls::Option& content : contents) names.emplace_back(content.name);
  const auto first_layer = static_cast<int>(names.size());
  // A layer may have the name of a split map: "Level".
  const std::vector<std::string> entries = layer_entries("");
  for (std::size_t i = 1; i < entries.size(); ++i)
    names.push_back((i < layer_count ? "Layer: " : "") + entries[i]);
  const int content = shown_content(state);
  int chosen = content == layer_content ? first_layer + shown_layer(state) - 1 : content;
  const char* tooltip = content == layer_content
                            ? "Layer or surface property ([ and ])."
                            : contents[static_cast<std::size_t>(content)].tooltip;
  if (!controls.list("Layer", tooltip, names, chosen)) return;
  if (chosen < first_layer)
    show_content(state, chosen);
  else
    show_layer(state, chosen - first_layer + 1);
}

// The contents as buttons and the layers as a list; one list if there is no room.
void content_cells(Controls& controls, Cells& cells, UiState& state, float width) {
  const float em = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemSpacing.x;
  const float buttons = width - layers_em * em - gap;
  if (buttons < Controls::least_width(contents)) {
    cells.add(width, [&] { content_list(controls, state); });
    return;
  }
  cells.add(buttons, [&] {
    int content = shown_content(state);
    if (controls.options("Layer", contents, content, {false, std::nullopt}))
      show_content(state, content);
  });
  cells.add(layers_em * em, [&] { layer_list(controls, state); });
}

void upper_row(Controls& controls, Previewer& previewer, UiState& state, float width,
               float height) {
  const float em = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemSpacing.x;
  const bool wide = state.bar.method;
  Cells cells("upper", height);
  const float method = wide ? 10.0f * em : 0.0f, snapshot = wide ? 6.5f * em : 0.0f;
  content_cells(controls, cells, state, width - method - snapshot - (wide ? 2.0f * gap : 0.0f));
  if (!wide) return;
  cells.add(method, [&] {
    method_list(controls, "Method in bar", previewer.edits().settings(), previewer.scene().get());
  });
  cells.add(snapshot, [&] {
    if (controls.button("Snapshot", "Keep the picture to compare with (S).", -1.0f))
      state.said = keep_snapshot(state.frames, previewer);
  });
}

void lower_row(Controls& controls, Previewer& previewer, UiState& state, float width,
               float height) {
  const float em = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemSpacing.x;
  const bool wide = state.bar.exposure;
  const Method method = previewer.edits().settings().method;
  const bool splits = in_object_space(method) || row_of(method).samples_by_eps;
  Cells cells("lower", height);
  const float before = 5.0f * em, exposure = wide ? 9.0f * em : 0.0f,
              zoom = wide ? 6.4f * em : 0.0f;
  const float sliders = width - before - exposure - zoom - (wide ? 4.0f : 2.0f) * gap;
  if (splits) {
    splitting_sliders(controls, previewer, state.max_turn, cells, sliders);
    cells.add(before, [&] { before_button(controls, previewer, state); });
  } else {
    cells.add(sliders + before + 2.0f * gap, [&] {
      ImGui::AlignTextToFramePadding();
      ImGui::TextDisabled("%s", row_of(method).about);
    });
  }
  if (!wide) return;
  cells.add(exposure, [&] {
    controls.slider("Exposure in bar", "Exposure in stops.", state.display.exposure_ev,
                    {-DisplaySettings::exposure_limit_ev, DisplaySettings::exposure_limit_ev, 0.0f},
                    [](float ev) { return fmt::format("{:+.1f} EV", ev); });
  });
  cells.add(zoom, [&] { zoom_buttons(controls, state.view); });
}

// A single row: the contents as a list, EPS and MAX.
void compact_row(Controls& controls, Previewer& previewer, UiState& state, float width,
                 float height) {
  const float em = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemSpacing.x;
  Cells cells("compact", height);
  const float list = 7.0f * em;
  cells.add(list, [&] { content_list(controls, state); });
  const Method method = previewer.edits().settings().method;
  if (in_object_space(method) || row_of(method).samples_by_eps)
    splitting_sliders(controls, previewer, state.max_turn, cells, width - list - 2.0f * gap);
}

}  // namespace

BarParts bar_parts(glm::vec2 size) {
  const float em = ImGui::GetFontSize();
  const float width = size.x - 2.0f * ImGui::GetStyle().WindowPadding.x;
  const bool two_rows = size.y >= std::round(theme::bar_height_em * em);
  return {size.y > 0.0f, two_rows && width >= (wide_em + layers_em) * em,
          two_rows && width >= wide_em * em};
}

void picture_bar(Controls& controls, Previewer& previewer, UiState& state) {
  controls.placed_window("Picture bar");
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight();
  const Controls::Unlabelled unlabelled(controls);
  if (ImGui::GetContentRegionAvail().y < 2.0f * height) {
    compact_row(controls, previewer, state, width, height);
  } else {
    upper_row(controls, previewer, state, width, height);
    lower_row(controls, previewer, state, width, height);
  }
}

}  // namespace asos::ui
