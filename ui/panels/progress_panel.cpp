#include "renderer/comparison/method.h"
#include "renderer/film/split_map.h"
#include "renderer/world/ground.h"
#include "ui/panels/panels.h"
#include "ui/panels/time_words.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

namespace asos::ui {

namespace {

/// Whether edges are still being searched; until then only rays are used.
bool looks_for_boundaries(const Previewer& previewer) {
  return needs_boundaries(previewer.render().settings().method) &&
         !previewer.scene()->geometry->boundaries.known();
}

/// Whether the ground is being added or removed, which takes seconds in large scenes.
bool changes_ground(const Previewer& previewer) {
  const World& world = previewer.scene()->world();
  return previewer.edits().settings().ground != ground_of(world) && !world.bounds.empty() &&
         !previewer.scene().error();
}

std::string status_words(const Previewer& previewer, const StatusLine& status) {
  if (!status.message.empty()) return status.message;
  if (!previewer.scene()) return previewer.scene().loading() ? "Loading" : "No scene";
  if (const std::size_t missing = previewer.scene().textures_missing(); missing > 0) {
    const auto loading = previewer.scene().loading();
    const std::size_t decoded = loading ? std::min(missing, loading->textures) : 0;
    return fmt::format("Textures: {} of {}", decoded, missing);
  }
  if (changes_ground(previewer)) return "Updating ground";
  return progress_words({previewer.render().progress(), status.fraction,
                         previewer.refinement().rest(), looks_for_boundaries(previewer),
                         previewer.render().reached()});
}

// Formats with constant width, so that the line does not move with every pixel.
std::string value_words(float value) {
  return value < 10.0f ? fmt::format("{:.3f}", value) : number_words(static_cast<double>(value));
}

std::string pixel_words(const Film& film, glm::ivec2 pixel, const DisplayTransform& display) {
  const std::size_t i = film.index(pixel.x, pixel.y);
  const glm::vec3 c = film.radiance[i];
  const glm::u8vec3 shown = display_bytes(film, i, display);
  std::string text =
      fmt::format("{}, {}   {} {} {}   {:3} {:3} {:3}", pixel.x, pixel.y, value_words(c.x),
                  value_words(c.y), value_words(c.z), shown.x, shown.y, shown.z);
  if (film.split_level[i] > 0 || film.cause[i] != SplitCause::none)
    text += "   " + split_words(film, i);
  return text;
}

bool holds(const Film& film, glm::ivec2 pixel) {
  return pixel.x >= 0 && pixel.y >= 0 && pixel.x < film.width && pixel.y < film.height;
}

// Longer names are truncated.
constexpr std::size_t most_name_letters = 40;
std::string cut_off(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most;  // not in the middle of a multi-byte character
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u) --end;
  return text.substr(0, end) + "...";
}

/// Writes the first of `choices` that fits to the right of the last item.
void right_words(const std::vector<std::string>& choices) {
  const float used = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
  for (const std::string& words : choices) {
    const float width = ImGui::CalcTextSize(words.c_str()).x;
    const float left = ImGui::GetWindowWidth() - width - ImGui::GetStyle().WindowPadding.x;
    if (left < used + ImGui::GetFontSize()) continue;
    ImGui::SameLine(left);
    ImGui::TextDisabled("%s", words.c_str());
    return;
  }
}

}  // namespace

void progress_panel(Controls& controls, const Previewer& previewer, const StatusLine& status) {
  // A thin progress bar along the upper edge, over the full width.
  const Progress progress = previewer.render().progress();
  if (previewer.scene() && !progress.finished) {
    const ImVec2 corner = ImGui::GetWindowPos();
    const float width = ImGui::GetWindowWidth();
    const float height = std::max(2.0f, ImGui::GetFontSize() * 0.15f);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->PushClipRect(corner, {corner.x + width, corner.y + height});  // window's is narrower
    draw->AddRectFilled(corner,
                        {corner.x + width * static_cast<float>(status.fraction), corner.y + height},
                        theme::packed(theme::accent_bright));
    draw->PopClipRect();
  }

  const std::string words = status_words(previewer, status);
  if (!status.message.empty())
    ImGui::TextUnformatted(words.c_str());
  else
    ImGui::TextDisabled("%s", words.c_str());
  controls.placed_words("Progress", words, "Wall-clock time. CPU time is in \"Compare\".");

  const std::string help =
      (status.zoom > 1 ? fmt::format("zoom {}x   ", status.zoom) : std::string()) + "F1 help";
  const Film& film = previewer.render().film();
  if (!status.pixel || !holds(film, *status.pixel)) return right_words({help});
  const std::string pixel = status.layer.empty()
                                ? pixel_words(film, *status.pixel, status.display)
                                : fmt::format("{}, {}   {}", status.pixel->x, status.pixel->y,
                                              cut_off(status.layer, 2 * most_name_letters));
  const std::string named =
      status.names.empty() ? pixel : cut_off(status.names, most_name_letters) + "   " + pixel;
  right_words({named + "   " + help, named, pixel + "   " + help, pixel, help});
  controls.placed(
      "Pixel values",
      "Under the pointer: object, material, position, linear values, display values, level.");
}

}  // namespace asos::ui
