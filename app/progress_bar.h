#pragma once

#include "renderer/session/render_session.h"

#include <iosfwd>
#include <string>

namespace asos {

/// One line, at most `columns` wide: a bar, the share that is done and the time left. No time is
/// named before the session has an estimate.
[[nodiscard]] std::string progress_line(const Progress& progress, int columns);

/// How far a row of pictures has come, but for the one that is being rendered.
struct PicturesDone {
  int count = 1;         ///< of all
  int finished = 0;      ///< rendered, or there before
  int rendered = 0;      ///< of these, those whose time is known
  double seconds = 0.0;  ///< that they took
};

/// The progress of all of them, where `now` is that of the next one: its share of the work is taken
/// to be as large as the others', and so is its time.
[[nodiscard]] Progress progress_of_all(const Progress& now, const PicturesDone& done);

/// "0:07", "12:30", "1:02:03".
[[nodiscard]] std::string clock_time(double seconds);

/// A line on a terminal that is redrawn in place, and wiped when the bar goes. Where the stream is
/// no terminal it draws nothing.
class ProgressBar {
 public:
  ProgressBar(std::ostream& stream, bool is_terminal);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void say(const std::string& text);  ///< for phases whose length is not known
  void show(const Progress& progress);
  /// Of which row of pictures `show` is told the progress of one from now on.
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
