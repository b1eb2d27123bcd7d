#include "ui/draw_schedule.h"

#include <algorithm>

namespace asos::ui {

namespace {

constexpr double input_frame_seconds = 1.0 / 60.0;
constexpr double tiles_frame_seconds = 1.0 / 20.0;
// Arriving tiles start a frame at most every so many times of a frame's duration: drawing then
// takes at most a third of the time. Software OpenGL needs about 25 ms for a frame of 1280 x 800
// pixels on two busy cores, which is half of the time at 20 frames a second.
constexpr double frames_apart = 3.0;

}  // namespace

void DrawSchedule::note_input() {
  happened_ = true;
  bring_forward(input_frame_seconds);
}

void DrawSchedule::note_woken(bool hurried) {
  happened_ = true;
  bring_forward(hurried ? input_frame_seconds
                        : std::max(tiles_frame_seconds, frames_apart * took_));
}

void DrawSchedule::begin_frame(double now) {
  drawn_ = now;
  due_ = never;
  settling_ = happened_;
  happened_ = false;
}

void DrawSchedule::end_frame(double now, std::optional<double> wish) {
  took_ = std::max(0.0, now - drawn_);
  // A window that has just appeared gets its final size in its second frame.
  if (settling_) bring_forward(tiles_frame_seconds);
  if (wish) bring_forward(std::max(*wish, input_frame_seconds));
}

void DrawSchedule::bring_forward(double seconds_after_frame) {
  due_ = std::min(due_, drawn_ + seconds_after_frame);
}

}  // namespace asos::ui
