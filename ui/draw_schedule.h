#pragma once

#include <limits>
#include <optional>

namespace asos::ui {

/// Decides when the window draws. Input is drawn at once. Arriving tiles are drawn less often,
/// because drawing takes time from rendering, and because input waits for a frame that is being
/// drawn. Without changes nothing is drawn. Times are seconds of one clock. Not thread-safe.
class DrawSchedule {
 public:
  static constexpr double never = std::numeric_limits<double>::infinity();

  /// Notes input, or that the window's contents were damaged.
  void note_input();
  /// Notes that another thread has finished something. `hurried`: draw it as soon as input.
  void note_woken(bool hurried);
  /// Call before drawing a frame, which will show all that was noted.
  void begin_frame(double now);
  /// `now`: when the frame was complete. `wish`: seconds after this frame at which the content
  /// wants the next one, even without input. The frame is drawn even if its reason has ended by
  /// then, so that the end shows.
  void end_frame(double now, std::optional<double> wish);
  /// When the next frame is due; it may lie in the past.
  [[nodiscard]] double due() const { return due_; }

 private:
  void bring_forward(double seconds_after_frame);

  double drawn_ = -1.0;    // when the last frame began
  double took_ = 0.0;      // how long it took
  double due_ = 0.0;       // the first frame is due at once
  bool happened_ = false;  // noted since the last frame
  bool settling_ = false;  // something was noted before the frame being drawn
};

}  // namespace asos::ui
