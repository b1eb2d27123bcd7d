#include "ui/edit_history.h"

#include <algorithm>
#include <utility>

namespace asos {

namespace {

// Turns of the wheel that follow each other more quickly are one step.
constexpr double step_rest_seconds = 0.4;

}  // namespace

void EditHistory::update(const Previewer& previewer, const DisplaySettings& display, bool holding,
                         double now_seconds) {
  if (!settled_ || scene_ != previewer.scenes_opened()) {
    *this = {};
    scene_ = previewer.scenes_opened();
    settled_ = seen_ = State{previewer.edits(), display};
    return;
  }
  if (!previewer.same_as(seen_->edits) || display != seen_->display) {
    seen_ = State{previewer.edits(), display};
    changed_ = true;
    changed_seconds_ = now_seconds;
  }
  if (changed_ && !holding && now_seconds - changed_seconds_ >= step_rest_seconds) end_step();
}

void EditHistory::end_step() {
  past_.push_back(std::move(*settled_));
  if (past_.size() > most_steps) past_.pop_front();
  settled_ = seen_;
  changed_ = false;
  future_.clear();
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
  previewer.restore(from.back().edits);
  display = from.back().display;
  from.pop_back();
  to.push_back(std::move(*settled_));
  settled_ = seen_ = State{previewer.edits(), display};
  return true;
}

std::optional<double> EditHistory::seconds_to_update(double now_seconds) const {
  if (!changed_) return std::nullopt;
  return std::max(0.0, changed_seconds_ + step_rest_seconds - now_seconds);
}

}  // namespace asos
