#include "ui/panels/tour_panel.h"
#include "ui/window_content.h"

#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace asos::ui {

// The time of the next frame, and messages.

namespace {

constexpr double message_seconds = 6.0;
constexpr int frames_to_settle = 3;
// Few redraws during a study, because their time counts as the study's.
constexpr double study_redraw_seconds = 0.5;

// Returns true while a repeating key is held, which needs frames.
bool keys_repeat() {
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.WantTextInput && !io.NavVisible) return false;
  constexpr Key repeating[] = {Key::left,    Key::right,     Key::up,    Key::down,
                               Key::page_up, Key::page_down, Key::erase, Key::backspace};
  return std::any_of(std::begin(repeating), std::end(repeating),
                     [](Key key) { return ImGui::IsKeyDown(static_cast<int>(key)); });
}

}  // namespace

// One bit for each background activity that the window shows.
std::uint32_t WindowContent::activity() const {
  const Progress progress = previewer_.render().progress();
  const bool going_on[] = {inspector_.busy(),
                           split_search_.busy(),
                           sky_reader_.busy(),
                           forecast_.busy(),
                           check_.pending(),
                           surfaces_.busy(),
                           outline_.busy(),
                           equal_time_.pending(),
                           saver_.job().pending(),
                           saver_.job().state().has_value(),
                           scene_export_.pending(),
                           clipboard_.pending(),
                           previewer_.scene().loading().has_value(),
                           previewer_.scene().error().has_value(),
                           progress.running,
                           progress.finished,
                           study_.busy(),
                           study_.state().resting,
                           previewer_.scene() && previewer_.scene()->geometry->boundaries.known()};
  std::uint32_t bits = 0;
  for (const bool bit : going_on) bits = 2 * bits + (bit ? 1 : 0);
  return bits;
}

void WindowContent::settle() {
  settling_frames_ = frames_to_settle;
}

void WindowContent::say(std::string message) {
  state_.message = std::move(message);
  state_.message_until_seconds = time_seconds_ + message_seconds;
  settle();
}

std::optional<double> WindowContent::seconds_to_redraw() const {
  if (settling_frames_ > 0 || !input_.empty() || activity() != shown_activity_ ||
      controls_.tooltip_changed() || scroll_anchor_.moved())
    return 0.0;
  std::optional<double> due = previewer_.seconds_to_update(time_seconds_);
  const auto also = [&due](double seconds) { due = std::min(due.value_or(seconds), seconds); };
  if (const std::optional<double> step = history_.seconds_to_update(time_seconds_)) also(*step);
  if (flying()) also(0.0);
  if (inspector_.busy() || split_search_.busy() || sky_reader_.busy() || forecast_.busy() ||
      metered_exposure_.busy())
    also(0.02);
  if (surfaces_.busy() || outline_.busy()) also(0.02);
  if (layers_.due() && !previewer_.render().progress().running) also(0.02);
  if (check_.pending() || equal_time_.pending()) also(0.1);
  if (keys_repeat()) also(0.03);
  if (const std::optional<double> card = seconds_to_card(state_, time_seconds_)) also(*card);
  if (state_.watch && previewer_.scene()) also(watch_.seconds_to_look(time_seconds_));
  if (const std::optional<double> tooltip = controls_.seconds_to_tooltip()) also(*tooltip);
  if (!state_.message.empty()) also(std::max(0.0, state_.message_until_seconds - time_seconds_));
  if (const auto loading = previewer_.scene().loading())
    also(loading->seconds < loading_box_delay ? loading_box_delay : 0.1);
  if (saver_.job().pending() || scene_export_.pending() || clipboard_.pending()) also(0.1);
  if (const std::optional<double> save = saver_.seconds_to_due(time_seconds_)) also(*save);
  if (previewer_.render().progress().running) also(0.25);
  if (previewer_.scene() && previewer_.scene()->geometry->boundaries.running()) also(0.25);
  if (study_.busy()) also(study_redraw_seconds);
  return due;
}

}  // namespace asos::ui
