#pragma once

#include "renderer/session/render_session.h"
#include "ui/refinement.h"
#include "ui/split_forecast.h"

#include <string>

// How long things take, in words that say whose seconds they are: the clock's, which a person
// waits, or one processor's, of which the workers together spend several in a second.

namespace asos {

/// "4.2 s", "1 min 05 s": of the clock, measured.
[[nodiscard]] std::string duration_words(double seconds);
/// "about 5 s to wait": of the clock, an estimate that says no more than it knows.
[[nodiscard]] std::string wait_words(double seconds);
/// "4.2 s of one processor".
[[nodiscard]] std::string processor_words(double seconds);

/// What a render does, how far it is, and how long it still takes; `without_boundaries`: they are
/// being looked for.
[[nodiscard]] std::string progress_words(const Progress& progress, Rest rest,
                                         bool without_boundaries, const Reached& reached = {});
/// How far all pixels have come: "4 samples per pixel", or how many are final; empty before that.
[[nodiscard]] std::string pass_words(const Reached& reached);
/// "3.1 ± 0.2 % split, about 5 s to wait".
[[nodiscard]] std::string forecast_words(const Forecast& forecast);

}  // namespace asos
