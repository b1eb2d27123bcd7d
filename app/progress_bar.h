#pragma once

#include "renderer/session/render_session.h"

#include <iosfwd>
#include <string>

namespace asos {

/// One line, at most `columns` wide: a bar, the share that is done and the time left. No time is
/// named before the session has an estimate.
[[nodiscard]] std::string progress_line(const Progress& progress, int columns);

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
  void wipe();

 private:
  std::ostream& stream_;
  bool is_terminal_;
  std::string drawn_;
};

}  // namespace asos
