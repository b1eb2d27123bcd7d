#pragma once

#include "renderer/settings/settings.h"
#include "ui/equal_time.h"
#include "ui/frames.h"
#include "ui/panels/controls.h"
#include "ui/previewer.h"

#include <cstdint>

namespace asos::ui {

/// The method to compare the picture with.
struct EqualTimeChoice {
  Method method = Method::sobol;
  std::uint64_t restarts = 0;  ///< restarts of the picture when the job was started
  EqualTimeNews news;          ///< how far the job is
};

/// Call once a frame, whether the panel is shown or not: adds the finished frame as a snapshot and
/// compares it.
void update_equal_time(const Previewer& previewer, EqualTimeChoice& choice, EqualTimeJob& job,
                       Frames& frames);

/// Starts to render the current view with the chosen method in the CPU time of the finished
/// picture. Returns false if there is no finished picture, or no room for another snapshot.
bool start_equal_time(const Previewer& previewer, EqualTimeChoice& choice, EqualTimeJob& job,
                      const Frames& frames);

/// Shows the progress of the other method.
void equal_time_progress(Controls& controls, const EqualTimeChoice& choice);

/// Controls to render the view with another method in the picture's CPU time.
void equal_time_controls(Controls& controls, const Previewer& previewer, EqualTimeChoice& choice,
                         EqualTimeJob& job, const Frames& frames);

}  // namespace asos::ui
