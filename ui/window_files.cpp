#include "ui/screenshot.h"
#include "ui/window_content.h"

#include <utility>

// The part of WindowContent that opens and watches files, and stores settings.

namespace asos::ui {

void WindowContent::open_dropped(const std::string& path) {
  if (!is_sky_file(path)) {
    state_.opening = {path};
    return;
  }
  read_as_sky(state_.sky, sky_reader_, path);
  state_.sky.dropped = true;
}

StoredSettings WindowContent::stored_settings() const {
  StoredSettings stored;
  stored.display = state_.display;
  stored.display.show_split_map = false;
  if (std::exchange(stored.display.auto_exposure, false)) stored.display.exposure_ev = 0.0f;
  if (state_.tour.card) stored.display.split_colours = state_.tour.before.display.split_colours;
  stored.look = state_.look;
  stored.tour_seen = state_.tour.seen;
  stored.show_panel = state_.show_panel;
  stored.show_marks = state_.lights.show_marks;
  stored.watch = state_.watch;
  stored.tab = state_.tab;
  stored.sections = controls_.sections();
  stored.recent = state_.recent;
  return stored;
}

void WindowContent::apply(const StoredSettings& stored) {
  state_.display = stored.display;
  state_.look = stored.look;
  state_.tour.seen |= stored.tour_seen;
  state_.show_panel = stored.show_panel;
  state_.lights.show_marks = stored.show_marks;
  state_.watch = stored.watch;
  state_.tab = stored.tab;
  controls_.set_sections(stored.sections);
  state_.recent = stored.recent;
}

// Adds the opened scene to the recent files, and reloads it when its file changes.
void WindowContent::follow_files(double now_seconds) {
  const RenderScene* scene = previewer_.scene().get();
  if (!scene) return;
  if (scenes_seen_ != previewer_.scene().times_opened()) {
    scenes_seen_ = previewer_.scene().times_opened();
    StoredSettings stored = stored_settings();
    stored.add_recent(scene->geometry->source);
    state_.recent = std::move(stored.recent);
    state_.lights.selected = -1;
    state_.outline.selected = -1;
    // The split map is switched off for another file; the tour's cards set it themselves.
    if (std::exchange(source_seen_, scene->geometry->source) != scene->geometry->source) {
      state_.tour.before.display.show_split_map = false;
      if (!state_.tour.card) state_.display.show_split_map = false;
      state_.frames.show_picture();
      previewer_.render().prefer({});
      state_.frames.shown_file = file_title(source_seen_);
    }
    const auto opened = previewer_.scene().take_opened_display();
    metered_exposure_.scene_opened(state_.display, opened.has_value());
    if (opened) {
      show_as(*opened, state_.display);
      // When the tour ends, it restores the settings of the opened picture.
      if (state_.tour.card)
        state_.tour.before = {
            previewer_.edits().settings(), state_.display,      std::nullopt, state_.frames.with,
            state_.frames.comparison,      state_.frames.chosen};
    }
  }
  if (const auto carried = previewer_.take_carried())
    if (std::string words = carried_words(*carried); !words.empty()) say(std::move(words));
  if (std::string said = metered_exposure_.update(previewer_, state_.display); !said.empty())
    say(std::move(said));
  if (state_.watch && !previewer_.scene().loading() &&
      watch_.changed(previewer_.scene().files(), now_seconds))
    previewer_.scene().reload();
}

}  // namespace asos::ui
