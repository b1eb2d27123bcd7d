#pragma once

#include "renderer/settings/settings.h"
#include "ui/equal_time.h"
#include "ui/frames.h"
#include "ui/panels/controls.h"
#include "ui/previewer.h"

#include <cstdint>

namespace asos::ui {

/// The method that the picture is compared with.
struct EqualTimeChoice {
  Method method = Method::sobol;
  std::uint64_t restarts = 0;  ///< of the picture that the job is for
  EqualTimeNews news;          ///< how far the job is
};

/// Call once a frame, whether the panel is shown or not: puts what was rendered beside the picture.
void update_equal_time(const Previewer& previewer, EqualTimeChoice& choice, EqualTimeJob& job,
                       Frames& frames);

/// Begins to render the view as it is by the chosen method, in the time that the finished picture
/// took; false where there is none, or no room for another frame.
bool start_equal_time(const Previewer& previewer, EqualTimeChoice& choice, EqualTimeJob& job,
                      const Frames& frames);

/// How far the other method is, while it renders.
void equal_time_progress(Controls& controls, const EqualTimeChoice& choice);

/// Renders the view by another method in the time that the picture took.
void equal_time_panel(Controls& controls, const Previewer& previewer, EqualTimeChoice& choice,
                      EqualTimeJob& job, const Frames& frames);

}  // namespace asos::ui
