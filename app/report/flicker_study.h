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

/// One setting of a method, rendered for all frames of an animation.
struct FlickerPoint {
  LadderStep rung;
  std::vector<double> frame_seconds;  ///< CPU time of each frame
  FlickerMeter meter;
  std::vector<Film> strip;   ///< a detail of the frames to show: see FlickerStudy
  bool under_floor = false;  ///< its flicker is below the reference's noise floor

  [[nodiscard]] double seconds() const;  ///< mean over the frames
};

/// A setting of ASOS compared with a rival's flicker in the same time.
struct FlickerAtEqualTime {
  std::string setting;
  std::string method;  ///< the rival
  double seconds = 0.0;
  double asos_flicker = 0.0;  ///< the floor, if the flicker is below it
  double rival_flicker = 0.0;
  bool at_least = false;  ///< asos_flicker is the floor, so the true ratio is larger
  Reading reading = Reading::measured;

  /// Above 1: ASOS flickers less.
  [[nodiscard]] double ratio() const { return rival_flicker / asos_flicker; }
};

/// The measurements of an animation. FlickerMeter defines flicker.
struct FlickerStudy {
  std::string scene;      ///< as on the command line
  std::string animation;  ///< its name; empty: it has only a number
  int animation_number = 0;
  int first_frame = 0;
  double fps = 0.0;
  int frames = 0;
  int width = 0;
  int height = 0;
  std::vector<FlickerPoint> points;
  std::vector<std::string> timed_out;  ///< settings that would take too long
  std::vector<FlickerAtEqualTime> equal_time;
  // The references: samples per pixel, their noise (Reference::noise) over all frames, and the
  // smallest flicker that can be measured against them (flicker_floor).
  long samples = 0;
  double noise = 0.0;
  double floor = 0.0;
  // The film strip: consecutive frames, and the area of the picture where they differ most.
  int strip_first = 0;  ///< index of its first frame, from 0
  PixelRect strip_part;
  std::vector<Film> strip;  ///< of the references
  Machine machine;
  std::string when;  ///< UTC
};

/// Compares the points of an otherwise complete study. Fills under_floor and equal_time, which has
/// no rows for rivals whose settings are all below the floor.
void compare_flicker(FlickerStudy& study);

/// Renders the selected frames with all methods. For each curve of a method, renders the settings
/// that are quicker than the anchor, and the next one. Errors: a scene that cannot be opened or has
/// no animations, fewer than two frames, an interruption.
[[nodiscard]] Result<FlickerStudy> study_flicker(const ReportArguments& arguments,
                                                 const std::string& scene, ProgressBar& bar,
                                                 const InterruptGuard& interrupt);

}  // namespace asos
