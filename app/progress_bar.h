#pragma once

#include "renderer/session/render_session.h"

#include <iosfwd>
#include <string>

namespace asos {

/// One line of at most `columns` characters: bar, percentage and remaining time. Shows no time
/// before the session has an estimate.
[[nodiscard]] std::string progress_line(const Progress& progress, int columns);

/// Progress of a series of pictures, without the one being rendered.
struct PicturesDone {
  int count = 1;         ///< of all
  int finished = 0;      ///< rendered, or found finished
  int rendered = 0;      ///< number of these with a known time
  double seconds = 0.0;  ///< that they took
};

/// Total progress of the series, with `now` that of the current picture. All pictures are assumed
/// to take the same amount of work and time.
[[nodiscard]] Progress progress_of_all(const Progress& now, const PicturesDone& done);

/// "0:07", "12:30", "1:02:03".
[[nodiscard]] std::string clock_time(double seconds);

/// A line on a terminal that is redrawn in place and erased by the destructor. Draws nothing if the
/// stream is no terminal.
class ProgressBar {
 public:
  ProgressBar(std::ostream& stream, bool is_terminal);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void say(const std::string& text);  ///< for phases of unknown length
  void show(const Progress& progress);
  /// Sets the progress of the series; `show` adds that of the current picture.
  void set_done(const PicturesDone& done) { done_ = done; }
  [[nodiscard]] int pictures() const { return done_.count; }
  void wipe();

 private:
  std::ostream& stream_;
  bool is_terminal_;
  std::string drawn_;
  PicturesDone done_;
};

}  // namespace asos
