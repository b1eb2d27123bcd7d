#include "ui/panels/time_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asos {

namespace {

std::string rough_duration(double seconds) {
  if (seconds < 10.0) return fmt::format("{:.0f} s", std::max(1.0, std::ceil(seconds)));
  if (seconds < 60.0) return fmt::format("{:.0f} s", 5.0 * std::ceil(seconds / 5.0));
  if (seconds < 3600.0) return fmt::format("{:.0f} min", std::ceil(seconds / 60.0));
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

const char* doing(Rest rest) {
  switch (rest) {
    case Rest::none:
      break;
    case Rest::paused:
      return "Paused at";
    case Rest::time:
      return "Time limit reached,";
    case Rest::quality:
      return "Quality reached,";
    case Rest::stopped:
      return "Stopped at";
  }
  return "Rendering";
}

}  // namespace

std::string duration_words(double seconds) {
  if (seconds < 10.0) return fmt::format("{:.1f} s", seconds);
  if (seconds < 60.0) return fmt::format("{:.0f} s", seconds);
  const int whole = static_cast<int>(seconds);
  if (seconds < 3600.0) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

std::string wait_words(double seconds) {
  return fmt::format("{} left", rough_duration(seconds));
}

std::string processor_words(double seconds) {
  return fmt::format("{:.3g} s CPU", seconds);
}

std::string pass_words(const Reached& reached) {
  if (reached.final_share >= 0.01)
    return fmt::format("{} % of pixels final", static_cast<int>(100.0 * reached.final_share));
  if (reached.pass != Reached::Pass::samples) return "";
  return fmt::format("{} {} per pixel", reached.samples,
                     reached.samples == 1 ? "sample" : "samples");
}

std::string progress_words(const Progress& progress, Rest rest, bool without_boundaries,
                           const Reached& reached) {
  if (progress.failed) return "Not enough memory for edges";
  if (without_boundaries && rest == Rest::none)
    return "Finding edges   " + duration_words(progress.seconds);
  if (progress.finished) return "Finished in " + duration_words(progress.seconds);
  // Slow renders move by less than a percent a second.
  const double percent = 100.0 * progress.fraction;
  std::string text = fmt::format("{} {:.{}f} %   ", doing(rest), percent, percent < 9.95 ? 1 : 0);
  if (const std::string pass = pass_words(reached); !pass.empty()) text += pass + "   ";
  text += duration_words(progress.seconds);
  if (progress.seconds_left >= 0.0) text += "   " + wait_words(progress.seconds_left);
  return text;
}

std::string forecast_words(const Forecast& forecast) {
  const double percent = 100.0 * forecast.split_share;
  return fmt::format("about {:.{}f} % split, {}", percent, percent < 1.0 ? 1 : 0,
                     rough_duration(forecast.wait_seconds));
}

}  // namespace asos
