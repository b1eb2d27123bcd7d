#pragma once

#include "app/frame_list.h"
#include "app/render_report.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace asos {

/// Returns the error of a scene that has nothing to draw.
[[nodiscard]] Error nothing_drawn(const RenderReport& report);

/// Prints "asos: note: NOTE".
void say_note(const std::string& note, std::ostream& err);

/// Prints where a picture was written, and its times.
void say_written(const RenderArguments& arguments, const RenderReport& report, std::ostream& out);

/// Prints a note if a frame of an animation shows the background alone.
void say_nothing_visible(const RenderArguments& arguments, const RenderReport& report,
                         const FrameRequest& frame, std::ostream& err);

/// Prints notes about choices that the command line leaves to the program.
void say_notes(const RenderArguments& arguments, const std::vector<FrameRequest>& frames,
               const OpenedScene& scene, std::ostream& err);

}  // namespace asos
