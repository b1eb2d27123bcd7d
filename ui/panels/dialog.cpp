#include "ui/panels/dialog.h"

#include "ui/input.h"
#include "ui/theme.h"

#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace asos::ui {

namespace {

bool pressed(Key key) {
  return ImGui::IsKeyPressed(static_cast<int>(key), false);
}

}  // namespace

Dialog::Dialog(const char* title, bool wanted, float across_em, float middle) {
  if (wanted && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * window.x, middle * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(across_em * ImGui::GetFontSize(), 0.94f * window.x), 0.0f});
  open_ = ImGui::BeginPopupModal(title, nullptr,
                                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                     ImGuiWindowFlags_NoSavedSettings |
                                     ImGuiWindowFlags_AlwaysAutoResize);
  appearing_ = open_ && ImGui::IsWindowAppearing();
}

Dialog::~Dialog() {
  if (open_) ImGui::EndPopup();
}

// With a visible keyboard focus, Enter presses the focused control.
bool Dialog::confirmed(Controls& controls, const char* name, const char* tooltip) const {
  const bool button = controls.button(name, tooltip, 8.0f * ImGui::GetFontSize());
  const bool enter = !appearing_ && !ImGui::GetIO().NavVisible &&
                     (pressed(Key::enter) || pressed(Key::keypad_enter));
  return button || enter;
}

bool Dialog::cancelled(Controls& controls, const char* tooltip) const {
  ImGui::SameLine();
  return controls.button("Cancel", tooltip, 6.0f * ImGui::GetFontSize()) || pressed(Key::escape);
}

void Dialog::close() const {
  ImGui::CloseCurrentPopup();
}

void Dialog::losses(const std::vector<std::string>& lines) const {
  ImGui::PushTextWrapPos(0.0f);
  for (const std::string& line : lines) ImGui::BulletText("%s", line.c_str());
  ImGui::PopTextWrapPos();
}

void Dialog::path_words(const std::string& path, const char* fault) const {
  std::error_code ignored;
  const bool replaces = !fault && std::filesystem::exists(path, ignored);
  ImGui::PushStyleColor(ImGuiCol_Text, theme::packed(theme::warning));
  ImGui::TextUnformatted(fault ? fault : replaces ? "File exists and will be replaced." : " ");
  ImGui::PopStyleColor();
}

}  // namespace asos::ui
