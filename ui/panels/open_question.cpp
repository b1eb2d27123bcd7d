#include "ui/panels/open_question.h"

#include "renderer/files/printable.h"
#include "ui/panels/dialog.h"

#include <fmt/format.h>
#include <imgui.h>

#include <filesystem>

namespace asos::ui {

namespace {

void open_wanted(OpenScene& scene, OpenChoice& choice) {
  scene.open(choice.wanted);
  choice = {};
}

std::string question(const OpenChoice& choice) {
  return fmt::format("Open {} and lose these changes?",
                     printable(std::filesystem::path(choice.wanted).filename().string()));
}

}  // namespace

void open_question(Controls& controls, OpenScene& scene, OpenChoice& choice,
                   const std::vector<std::string>& losses) {
  constexpr const char* title = "Open another scene?";
  const auto asked = [&] { return !choice.wanted.empty(); };
  if (asked() && losses.empty()) open_wanted(scene, choice);
  const Dialog dialog(title, asked(), 30.0f);
  if (!dialog.open()) return;
  ImGui::TextWrapped("%s", question(choice).c_str());
  dialog.losses(losses);
  ImGui::TextWrapped("A saved picture (P) or scene (Ctrl+Shift+S) keeps them.");
  ImGui::Spacing();
  const bool open = dialog.confirmed(controls, "Open", "Open it without your changes (Enter).");
  const bool stay = dialog.cancelled(controls, "Keep this scene (Esc).");
  if (open || stay || !asked()) dialog.close();
  if (open && asked()) open_wanted(scene, choice);
  if (stay) choice = {};
}

}  // namespace asos::ui
