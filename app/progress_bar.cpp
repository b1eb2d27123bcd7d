#include "app/progress_bar.h"

#include "renderer/files/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <sys/ioctl.h>
#include <unistd.h>

namespace asos {
namespace {

int terminal_columns() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

}  // namespace

std::string clock_time(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(std::clamp(seconds, 0.0, 3.6e8)));
  if (whole >= 3600)
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string progress_line(const Progress& progress, int columns) {
  const double fraction = std::clamp(progress.fraction, 0.0, 1.0);
  // Rounds down, so that 100 % means finished.
  std::string text = fmt::format(" {:3} %", static_cast<int>(fraction * 100.0));
  if (progress.seconds_left >= 0.0)
    text += fmt::format("  {} left", clock_time(progress.seconds_left));
  const int room = columns - static_cast<int>(text.size()) - 2;
  if (room < 4) return text.substr(0, static_cast<std::size_t>(std::max(columns, 0)));
  const auto width = static_cast<std::size_t>(std::min(room, 40));
  const auto done = static_cast<std::size_t>(fraction * static_cast<double>(width));
  return fmt::format("[{:#<{}}{:.<{}}]{}", "", done, "", width - done, text);
}

Progress progress_of_all(const Progress& now, const PicturesDone& done) {
  Progress all = now;
  all.fraction = (done.finished + std::clamp(now.fraction, 0.0, 1.0)) / done.count;
  const int to_come = done.count - done.finished - 1;
  const double mean = done.rendered > 0 ? done.seconds / done.rendered : -1.0;
  const double left =
      now.seconds_left >= 0.0 || mean < 0.0 ? now.seconds_left : std::max(0.0, mean - now.seconds);
  if (left < 0.0) return all;
  const double a_picture = (done.seconds + now.seconds + left) / (done.rendered + 1);
  all.seconds_left = left + to_come * a_picture;
  return all;
}

ProgressBar::ProgressBar(std::ostream& stream, bool is_terminal)
    : stream_(stream), is_terminal_(is_terminal) {}

ProgressBar::~ProgressBar() {
  wipe();
}

void ProgressBar::say(const std::string& words) {
  if (!is_terminal_) return;
  const std::string text = printable(words);
  if (text == drawn_) return;
  const std::size_t longer = drawn_.size() > text.size() ? drawn_.size() - text.size() : 0;
  stream_ << '\r' << text << std::string(longer, ' ') << std::flush;
  drawn_ = text;
}

void ProgressBar::show(const Progress& progress) {
  // Leaves the last column free: some terminals wrap after it is written.
  if (!is_terminal_) return;
  const int columns = terminal_columns() - 1;
  const std::string which =
      done_.count > 1 ? fmt::format("{}/{} ", done_.finished + 1, done_.count) : std::string();
  const int room = columns - static_cast<int>(which.size());
  say(room < 4 ? progress_line(progress_of_all(progress, done_), columns)
               : which + progress_line(progress_of_all(progress, done_), room));
}

void ProgressBar::wipe() {
  if (drawn_.empty()) return;
  stream_ << '\r' << std::string(drawn_.size(), ' ') << '\r' << std::flush;
  drawn_.clear();
}

}  // namespace asos
