#pragma once

#include "ui/display_settings.h"
#include "ui/panels/controls.h"
#include "ui/picture_view.h"
#include "ui/previewer.h"
#include "ui/split_check.h"

namespace asos::ui {

struct PictureArea;

/// Settings of the check of splits.
struct CheckChoice {
  bool check = false;
  bool mark_missed = true;
  bool mark_wasted = true;
  double alarm = 1.0 / 64.0;  ///< error that counts as missed, of display intensity, 0 to 1
};

/// The state of the reference, which has `samples` samples per pixel, and for methods in object
/// space the check of splits.
void check_controls(Controls& controls, const Previewer& previewer, CheckChoice& choice,
                    const SplitCheck& check, int samples);

/// Fills pixels with a colour, or frames them where they are large.
void draw_runs(const std::vector<PixelRun>& runs, std::uint32_t rgb, const PictureView& view,
               const PictureArea& area);

/// Dims the picture and marks the pixels that were found.
void check_marks(const SplitFindings* findings, const CheckChoice& choice, const PictureView& view,
                 const PictureArea& area);

}  // namespace asos::ui
