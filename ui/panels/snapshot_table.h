#pragma once

#include "ui/frames.h"
#include "ui/panels/controls.h"
#include "ui/previewer.h"

#include <string>

namespace asos::ui {

/// Lists the picture and the snapshots with RMSE and PSNR against the chosen snapshot. A click
/// chooses another one. Requires a snapshot.
void snapshot_table(Controls& controls, const Previewer& previewer, Frames& frames);
/// The table as CSV with a header. Unknown errors are empty; the PSNR of equal pictures is "inf".
[[nodiscard]] std::string snapshot_csv(const Frames& frames);

/// RMSE over the pixels that both pictures cover, of linear values clipped to 0 to 1. `sized`: `b`
/// resampled to the size of `a`.
[[nodiscard]] double common_rmse(const Film& a, const Film& b, const Film& sized);
/// "32.1 dB", for a peak value of 1; "identical" without any error.
[[nodiscard]] std::string psnr_words(double rmse);

}  // namespace asos::ui
