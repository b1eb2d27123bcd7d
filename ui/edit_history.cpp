#include "ui/edit_history.h"

#include <algorithm>
#include <utility>

namespace asos::ui {

namespace {

// Turns of the mouse wheel within this time of each other are one step.
constexpr double step_rest_seconds = 0.4;

}  // namespace

EditHistory::State EditHistory::state_of(const Previewer& previewer,
                                         const DisplaySettings& display) {
  return {previewer.edits().state(), previewer.viewpoint().state(), display};
}

void EditHistory::update(const Previewer& previewer, const DisplaySettings& display, bool holding,
                         double now_seconds) {
  if (!settled_ || scene_ != previewer.scene().times_opened()) {
    *this = {};
    scene_ = previewer.scene().times_opened();
    settled_ = seen_ = state_of(previewer, display);
    return;
  }
  if (!is(previewer, display, *seen_)) {
    seen_ = state_of(previewer, display);
    changed_ = true;
    changed_seconds_ = now_seconds;
  }
  if (changed_ && !holding && now_seconds - changed_seconds_ >= step_rest_seconds) end_step();
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
         display == state.display;
}

bool EditHistory::undo(Previewer& previewer, DisplaySettings& display) {
  if (changed_) end_step();
  return step(past_, future_, previewer, display);
}

bool EditHistory::redo(Previewer& previewer, DisplaySettings& display) {
  if (changed_) end_step();
  return step(future_, past_, previewer, display);
}

bool EditHistory::step(std::deque<State>& from, std::deque<State>& to, Previewer& previewer,
                       DisplaySettings& display) {
  if (from.empty() || !settled_) return false;
  if (group_ && &from == &past_ && past_.size() <= *group_) group_.reset();
  previewer.edits().restore(from.back().edits);
  previewer.viewpoint().restore(from.back().viewpoint);
  display = from.back().display;
  from.pop_back();
  to.push_back(std::move(*settled_));
  settled_ = seen_ = state_of(previewer, display);
  return true;
}

std::optional<double> EditHistory::seconds_to_update(double now_seconds) const {
  if (!changed_) return std::nullopt;
  return std::max(0.0, changed_seconds_ + step_rest_seconds - now_seconds);
}

}  // namespace asos::ui
