#pragma once

#include "renderer/session/render_session.h"
#include "ui/refinement.h"
#include "ui/shown_progress.h"

#include <optional>
#include <string>

// Durations as text. Wall-clock time and CPU time, which all workers add up to, are labelled as
// such.

namespace asos::ui {

/// "4.2 s", "1 min 05 s": measured wall-clock time.
[[nodiscard]] std::string duration_words(double seconds);
/// "5 s left": an estimate of wall-clock time, rounded.
[[nodiscard]] std::string wait_words(double seconds);
/// "4.25 s": CPU time, for a field with that name.
[[nodiscard]] std::string processor_words(double seconds);

/// The progress of a render, for its text.
struct ProgressFacts {
  Progress progress;
  double fraction = 0.0;  ///< the displayed fraction: see ShownProgress
  PauseReason rest = PauseReason::none;
  bool without_edges = false;  ///< edges are still being searched
  Reached reached;
};
/// Wall-clock seconds until the render is finished, by its own measurements only, and at least as
/// long as the displayed fraction implies. None: no final pixels of these settings were measured.
[[nodiscard]] std::optional<double> seconds_left(const ProgressFacts& facts);
/// "40 % done   4 samples per pixel   2.0 s   4 s left": percentage over all passes, the pass that
/// all pixels have reached, elapsed time and remaining time.
[[nodiscard]] std::string progress_words(const ProgressFacts& facts);
/// "first samples", "4 samples per pixel", "12 % final"; empty before the first picture.
[[nodiscard]] std::string pass_words(const Reached& reached);
/// "about 3.1 % split, 5 s": the time of the whole render.
[[nodiscard]] std::string estimate_words(double split_share, const TimeEstimate& estimate);

}  // namespace asos::ui
