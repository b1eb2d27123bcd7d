#pragma once

#include "renderer/session/render_session.h"
#include "ui/refinement.h"
#include "ui/shown_progress.h"

#include <optional>
#include <string>

// How long things take, in words that say whose seconds they are: the clock's, which a person
// waits, or one processor's, of which the workers together spend several in a second.

namespace asos::ui {

/// "4.2 s", "1 min 05 s": of the clock, measured.
[[nodiscard]] std::string duration_words(double seconds);
/// "5 s left": of the clock, an estimate that says no more than it knows.
[[nodiscard]] std::string wait_words(double seconds);
/// "4.2 s CPU".
[[nodiscard]] std::string processor_words(double seconds);

/// What is known of a render's progress.
struct ProgressFacts {
  Progress progress;
  double fraction = 0.0;  ///< that is shown: see ShownProgress
  Rest rest = Rest::none;
  bool without_edges = false;  ///< they are searched
  Reached reached;
  std::optional<TimeEstimate> estimate;
};
/// "Rendering 40 %   4 samples per pixel   2.0 s   4 s left": the percentage over all passes, the
/// pass that runs, the time so far and the time left.
[[nodiscard]] std::string progress_words(const ProgressFacts& facts);
/// The pass that runs: "first samples", "4 samples per pixel", "12 % of pixels final"; empty
/// before.
[[nodiscard]] std::string pass_words(const Reached& reached);
/// "about 3.1 % split, 5 s": the whole render's time.
[[nodiscard]] std::string estimate_words(double split_share, const TimeEstimate& estimate);

}  // namespace asos::ui
