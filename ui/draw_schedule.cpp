#include "ui/draw_schedule.h"

#include <algorithm>

namespace asos::ui {

namespace {

constexpr double input_frame_seconds = 1.0 / 60.0;
constexpr double tiles_frame_seconds = 1.0 / 20.0;

}  // namespace

void DrawSchedule::note_input() {
  happened_ = true;
  bring_forward(input_frame_seconds);
}

void DrawSchedule::note_woken(bool hurried) {
  happened_ = true;
  bring_forward(hurried ? input_frame_seconds : tiles_frame_seconds);
}

void DrawSchedule::begin_frame(double now) {
  drawn_ = now;
  due_ = never;
  settling_ = happened_;
  happened_ = false;
}

void DrawSchedule::end_frame(std::optional<double> wish) {
  // A window that has just appeared gets its final size in its second frame.
  if (settling_) bring_forward(tiles_frame_seconds);
  if (wish) bring_forward(std::max(*wish, input_frame_seconds));
}

void DrawSchedule::bring_forward(double seconds_after_frame) {
  due_ = std::min(due_, drawn_ + seconds_after_frame);
}

}  // namespace asos::ui
