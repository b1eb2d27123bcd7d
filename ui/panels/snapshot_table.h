#pragma once

#include "ui/frames.h"
#include "ui/panels/controls.h"
#include "ui/previewer.h"

#include <string>

namespace asos::ui {

/// Lists the picture and the snapshots with RMSE and PSNR against the reference of this view, or,
/// without one, against the chosen snapshot. A click chooses another one. Requires a snapshot.
void snapshot_table(Controls& controls, const Previewer& previewer, Frames& frames);
/// The table as CSV with a header. Unknown errors are empty; the PSNR of equal pictures is "inf".
[[nodiscard]] std::string snapshot_csv(const Frames& frames);

/// Which of the picture and the chosen snapshot is closer to the reference, and how many times:
/// "Current picture, 3.1 times". "not known yet" without a reference or with an unfinished picture.
[[nodiscard]] std::string closer_words(const Frames& frames);

/// "1/256": the difference, 0 to 1, that is drawn white.
[[nodiscard]] std::string scale_words(float stops);

/// RMSE over the pixels that both pictures cover, of linear values clipped to 0 to 1. `sized`: `b`
/// resampled to the size of `a`.
[[nodiscard]] double common_rmse(const Film& a, const Film& b, const Film& sized);
/// "32.1 dB", for a peak value of 1; "identical" without any error.
[[nodiscard]] std::string psnr_words(double rmse);

}  // namespace asos::ui
