#pragma once

#include <limits>
#include <optional>

namespace asos::ui {

/// Decides when the window draws: what a person does is followed at once; tiles that arrive are
/// shown less often, because showing them takes time from rendering them; and while nothing
/// changes, nothing is drawn. Times are seconds on one clock. One thread.
class DrawSchedule {
 public:
  static constexpr double never = std::numeric_limits<double>::infinity();

  /// There was input, or the window has to be drawn again.
  void note_input();
  /// Another thread has finished something. `hurried`: it is waited for.
  void note_woken(bool hurried);
  /// A frame is drawn now, which shows all that was noted; before it is.
  void begin_frame(double now);
  /// The content's wish when to be drawn next though nothing happens, in seconds after this frame.
  /// It holds though what it was for be over by then: that, too, has to be shown.
  void end_frame(std::optional<double> wish);
  /// When the next frame is due; may have passed.
  [[nodiscard]] double due() const { return due_; }

 private:
  void bring_forward(double seconds_after_frame);

  double drawn_ = -1.0;    // when the last frame was
  double due_ = 0.0;       // the first frame is due at once
  bool happened_ = false;  // something was noted since the last frame
  bool settling_ = false;  // the frame being drawn shows it
};

}  // namespace asos::ui
