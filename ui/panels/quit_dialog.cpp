#include "ui/panels/quit_dialog.h"

#include "ui/panels/dialog.h"

#include <imgui.h>

#include <utility>

namespace asos::ui {

void quit_dialog(Controls& controls, QuitChoice& choice, const std::vector<std::string>& losses,
                 bool saving) {
  constexpr const char* title = "Quit?";
  if (choice.after_save && !saving) choice.quit = true;
  if (choice.asked && losses.empty()) choice.quit = true;
  if (choice.quit) return;
  const bool open = ImGui::IsPopupOpen(title);
  // A second request quits without asking.
  if (choice.asked && open) choice.quit = true;
  const Dialog dialog(title, std::exchange(choice.asked, false), 30.0f);
  if (!dialog.open()) return;
  ImGui::TextUnformatted("Quit and lose these changes?");
  dialog.losses(losses);
  ImGui::Spacing();
  choice.quit |= dialog.confirmed(controls, "Quit", "Close the window (Enter, Ctrl+Q again).");
  if (saving) {
    ImGui::SameLine();
    if (controls.button("Quit when saved", "Close the window when the picture is complete."))
      choice.after_save = true;
  }
  const bool stay = dialog.cancelled(controls, "Return to the window (Esc).");
  if (choice.quit || choice.after_save || stay || losses.empty()) dialog.close();
}

}  // namespace asos::ui
