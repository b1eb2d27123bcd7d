#include "renderer/comparison/method.h"
#include "ui/panels/panels.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace asos {

namespace {

std::string duration(double seconds) {
  if (seconds < 10.0) return fmt::format("{:.1f} s", seconds);
  if (seconds < 60.0) return fmt::format("{:.0f} s", seconds);
  const int whole = static_cast<int>(seconds);
  if (seconds < 3600.0) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

// An estimate says no more than it knows.
std::string rough_duration(double seconds) {
  if (seconds < 10.0) return fmt::format("{:.0f} s", std::max(1.0, std::ceil(seconds)));
  if (seconds < 60.0) return fmt::format("{:.0f} s", 5.0 * std::ceil(seconds / 5.0));
  if (seconds < 3600.0) return fmt::format("{:.0f} min", std::ceil(seconds / 60.0));
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

const char* doing(Rest rest) {
  switch (rest) {
    case Rest::none:
      break;
    case Rest::paused:
      return "Paused at";
    case Rest::time:
      return "Rests at its time limit,";
    case Rest::quality:
      return "Rests at its quality,";
    case Rest::stopped:
      return "Stopped at";
  }
  return "Rendering";
}

/// Whether the picture is as good as rays alone can make it, until the boundaries are known.
bool looks_for_boundaries(const Previewer& previewer) {
  return needs_boundaries(previewer.render().settings().method) &&
         !previewer.scene()->geometry->boundaries.known();
}

std::string words(const Progress& progress, Rest rest, bool without_boundaries) {
  if (progress.failed) return "Not enough memory for the boundaries";
  if (without_boundaries && rest == Rest::none)
    return "Looking for boundaries   " + duration(progress.seconds);
  if (progress.finished) return "Finished in " + duration(progress.seconds);
  std::string text = fmt::format("{} {:.0f} %   {}", doing(rest), 100.0 * progress.fraction,
                                 duration(progress.seconds));
  if (progress.seconds_left >= 0.0) {
    text += fmt::format("   about {} to wait", rough_duration(progress.seconds_left));
  }
  return text;
}

}  // namespace

void progress_panel(Controls& controls, const Previewer& previewer, const StatusLine& status) {
  // A thin bar along the upper rim, full width, so that a glance is enough.
  const Progress progress = previewer.render().progress();
  if (previewer.scene() && !progress.finished) {
    const ImVec2 corner = ImGui::GetWindowPos();
    const float width = ImGui::GetWindowWidth();
    const float height = std::max(2.0f, ImGui::GetFontSize() * 0.15f);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->PushClipRect(corner, {corner.x + width, corner.y + height});  // ours ends at the padding
    draw->AddRectFilled(
        corner, {corner.x + width * static_cast<float>(progress.fraction), corner.y + height},
        theme::packed(theme::accent_bright));
    draw->PopClipRect();
  }

  if (!status.message.empty()) {
    ImGui::TextUnformatted(status.message.c_str());
  } else if (previewer.scene()) {
    ImGui::TextDisabled(
        "%s",
        words(progress, previewer.refinement().rest(), looks_for_boundaries(previewer)).c_str());
  } else {
    ImGui::TextDisabled("%s", previewer.scene().loading() ? "Loading" : "No scene");
  }
  controls.placed("Progress",
                  "Seconds of the clock, which is what you wait. All threads together take more of "
                  "their processors' time; \"Equal time\" and the split map by time count that.");

  const std::string right = fmt::format(
      "{}   F1 help", status.zoom > 1 ? fmt::format("zoom {}x", status.zoom) : std::string());
  const float width = ImGui::CalcTextSize(right.c_str()).x;
  const float left = ImGui::GetWindowWidth() - width - ImGui::GetStyle().WindowPadding.x;
  const float used = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
  if (left < used + ImGui::GetFontSize()) return;
  ImGui::SameLine(left);
  ImGui::TextDisabled("%s", right.c_str());
}

}  // namespace asos
