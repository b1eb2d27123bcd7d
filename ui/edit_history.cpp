#include "ui/edit_history.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace asos::ui {

namespace {

// Turns of the mouse wheel within this time of each other are one step.
constexpr double step_rest_seconds = 0.4;

// Whether both have the same exposure and tone curve. The rest chooses a view of the picture.
bool same_tones(const DisplaySettings& a, const DisplaySettings& b) {
  return a.transform() == b.transform() && a.auto_exposure == b.auto_exposure;
}

struct Change {
  const char* name;
  bool found;
};

// The changed groups of settings; EPS and MAX by name.
std::vector<Change> changes_of(const RenderSettings& a, const RenderSettings& b) {
  AsosSettings rest = a.asos;
  rest.eps = b.asos.eps;
  rest.max_level = b.asos.max_level;
  return {{"method", a.method != b.method},
          {"EPS", a.asos.eps != b.asos.eps},
          {"MAX", a.asos.max_level != b.asos.max_level},
          {"antialiasing", rest != b.asos || a.sampling != b.sampling || a.texture != b.texture ||
                               a.filter_width != b.filter_width},
          {"shadows", a.shadow != b.shadow},
          {"reflections", a.mirror != b.mirror},
          {"shutter", a.shutter != b.shutter},
          {"sky", a.sky != b.sky || a.background != b.background},
          {"ground", a.ground != b.ground}};
}

}  // namespace

EditHistory::State EditHistory::state_of(const Previewer& previewer,
                                         const DisplaySettings& display) {
  return {previewer.edits().state(), previewer.viewpoint().state(), display};
}

void EditHistory::update(const Previewer& previewer, const DisplaySettings& display, bool holding,
                         double now_seconds) {
  if (!settled_ || scene_ != previewer.scene().times_opened()) {
    past_.clear();
    future_.clear();
    changed_ = false;
    group_.reset();
    scene_ = previewer.scene().times_opened();
    settled_ = seen_ = state_of(previewer, display);
    note_hidden(previewer.scene());
    return;
  }
  if (!is(previewer, display, *seen_)) {
    seen_ = state_of(previewer, display);
    changed_ = true;
    changed_seconds_ = now_seconds;
  }
  if (changed_ && !holding && now_seconds - changed_seconds_ >= step_rest_seconds) end_step();
}

// Notes which objects the scene that was just opened hides.
void EditHistory::note_hidden(const OpenScene& scene) {
  if (!scene) return;
  const std::vector<ObjectId>& now = scene.hidden_objects();
  if (std::exchange(source_, scene->geometry->source) != scene->geometry->source) {
    hidden_past_.clear();
    hidden_future_.clear();
  } else if (now != hidden_) {
    hidden_past_.push_back(hidden_);
    hidden_future_.clear();
  }
  hidden_ = now;
}

std::optional<std::string> EditHistory::show_earlier(std::deque<std::vector<ObjectId>>& from,
                                                     std::deque<std::vector<ObjectId>>& to,
                                                     OpenScene& scene) {
  if (from.empty() || scene.loading()) return std::nullopt;
  to.push_back(scene.hidden_objects());
  hidden_ = from.back();
  from.pop_back();
  scene.show_all_but(hidden_);
  return "hidden objects";
}

void EditHistory::end_step() {
  past_.push_back(std::move(*settled_));
  if (past_.size() > most_steps) {
    past_.pop_front();
    if (group_ && *group_ > 0) --*group_;
  }
  settled_ = seen_;
  changed_ = false;
  future_.clear();
}

void EditHistory::begin_group(const Previewer& previewer, const DisplaySettings& display) {
  update(previewer, display, true, changed_seconds_);
  if (changed_) end_step();
  group_ = past_.size();
}

void EditHistory::end_group(const Previewer& previewer, const DisplaySettings& display) {
  const std::optional<std::size_t> group = std::exchange(group_, std::nullopt);
  if (!group || !settled_ || scene_ != previewer.scene().times_opened()) return;
  if (past_.size() > *group) {
    settled_ = std::move(past_[*group]);
    past_.erase(past_.begin() + static_cast<std::ptrdiff_t>(*group), past_.end());
    future_.clear();
  }
  seen_ = state_of(previewer, display);
  changed_ = !is(previewer, display, *settled_);
}

bool EditHistory::is(const Previewer& previewer, const DisplaySettings& display,
                     const State& state) {
  return previewer.edits().same_as(state.edits) && previewer.viewpoint().same_as(state.viewpoint) &&
         same_tones(display, state.display);
}

std::string EditHistory::changed_words(const Previewer& previewer, const DisplaySettings& display,
                                       const State& wanted) {
  const SceneEdits::State& now = previewer.edits().state();
  std::vector<Change> changes = changes_of(now.settings, wanted.edits.settings);
  changes.push_back({"lights", now.look.lights != wanted.edits.look.lights});
  changes.push_back({"blur curves", now.look.dfrs != wanted.edits.look.dfrs});
  changes.push_back({"camera", !previewer.viewpoint().same_as(wanted.viewpoint)});
  changes.push_back({"exposure or tone", !same_tones(display, wanted.display)});
  std::string words;
  for (const Change& change : changes)
    if (change.found) words += (words.empty() ? "" : ", ") + std::string(change.name);
  return words.empty() ? "settings" : words;
}

std::optional<std::string> EditHistory::undo(Previewer& previewer, DisplaySettings& display) {
  if (changed_) end_step();
  if (past_.empty()) return show_earlier(hidden_past_, hidden_future_, previewer.scene());
  return step(past_, future_, previewer, display);
}

std::optional<std::string> EditHistory::redo(Previewer& previewer, DisplaySettings& display) {
  if (changed_) end_step();
  if (future_.empty()) return show_earlier(hidden_future_, hidden_past_, previewer.scene());
  return step(future_, past_, previewer, display);
}

std::optional<std::string> EditHistory::step(std::deque<State>& from, std::deque<State>& to,
                                             Previewer& previewer, DisplaySettings& display) {
  if (from.empty() || !settled_) return std::nullopt;
  const std::string words = changed_words(previewer, display, from.back());
  if (group_ && &from == &past_ && past_.size() <= *group_) group_.reset();
  previewer.edits().restore(from.back().edits);
  previewer.viewpoint().restore(from.back().viewpoint);
  const DisplaySettings& tones = from.back().display;
  display.exposure_ev = tones.exposure_ev;
  display.auto_exposure = tones.auto_exposure;
  display.tone = tones.tone;
  from.pop_back();
  to.push_back(std::move(*settled_));
  settled_ = seen_ = state_of(previewer, display);
  return words;
}

std::optional<double> EditHistory::seconds_to_update(double now_seconds) const {
  if (!changed_) return std::nullopt;
  return std::max(0.0, changed_seconds_ + step_rest_seconds - now_seconds);
}

}  // namespace asos::ui
