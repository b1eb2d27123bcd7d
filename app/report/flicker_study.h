#pragma once

#include "app/interrupt.h"
#include "app/progress_bar.h"
#include "app/report/machine.h"
#include "app/report/report_arguments.h"
#include "renderer/study/analysis.h"
#include "renderer/study/flicker.h"

#include <optional>
#include <string>
#include <vector>

namespace asos {

/// A setting of a method over all frames of an animation.
struct FlickerPoint {
  Rung rung;
  std::vector<double> seconds;  ///< of all threads together, a frame each
  FlickerMeter meter;
  std::vector<Film> strip;   ///< a part of the frames that are shown: see FlickerStudy
  bool under_floor = false;  ///< its flicker is hardly known

  [[nodiscard]] double mean_seconds() const;
};

/// A setting of ASOS beside a rival's flicker in the same time.
struct FlickerAtEqualTime {
  std::string setting;
  std::string method;  ///< the rival
  double seconds = 0.0;
  double asos_flicker = 0.0;  ///< the floor, where it is under that
  double rival_flicker = 0.0;
  bool at_least = false;  ///< it is, so that the ratio is larger
  Reading reading = Reading::measured;

  /// Above 1: ASOS flickers less.
  [[nodiscard]] double ratio() const { return rival_flicker / asos_flicker; }
};

/// What was measured of an animation: see FlickerMeter for what flicker is.
struct FlickerStudy {
  std::string scene;      ///< as on the command line
  std::string animation;  ///< its name; empty: its number says which
  int animation_number = 0;
  int first_frame = 0;
  double fps = 0.0;
  int frames = 0;
  int width = 0;
  int height = 0;
  std::vector<FlickerPoint> points;
  std::vector<std::string> given_up;  ///< settings that would have taken too long
  std::vector<FlickerAtEqualTime> equal_time;
  // The references: samples a pixel, their noise (Reference::noise) over all frames, and the
  // flicker that is hardly known beside it (flicker_floor).
  long samples = 0;
  double noise = 0.0;
  double floor = 0.0;
  // The film strip: consecutive frames, and the part of the picture where they differ most.
  int strip_first = 0;  ///< index of its first frame, from 0
  PixelRect strip_part;
  std::vector<Film> strip;  ///< of the references
  Machine machine;
  std::string when;  ///< UTC

  /// The setting that pictures are compared at: ASOS as the program has it unless told otherwise,
  /// or else one in the middle. Null: there are no points.
  [[nodiscard]] const FlickerPoint* anchor() const;
};

/// Compares the points of a study that is otherwise complete: fills under_floor and
/// equal_time, which has no rows for rivals whose settings are all under the floor.
void compare_flicker(FlickerStudy& study);

/// Renders the frames that the arguments ask for by all their methods. Of each curve of a method
/// those settings are rendered that are quicker than the anchor, and the next. Errors: a scene
/// without animations or that cannot be opened, fewer than two frames, an interruption.
[[nodiscard]] Result<FlickerStudy> study_flicker(const ReportArguments& arguments,
                                                 const std::string& scene, ProgressBar& bar,
                                                 const InterruptGuard& interrupt);

}  // namespace asos
