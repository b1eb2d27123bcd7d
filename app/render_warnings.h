#pragma once

#include "app/render_report.h"
#include "renderer/prepared/render_scene.h"

#include <iosfwd>

namespace asos {

/// Writes into a report what of the scene is not in the picture, as far as it is known: boundaries
/// tell more once they are found.
void tell_warnings(RenderReport& report, const RenderScene& scene, const SkyChoice& sky);

/// Adds a warning of rays that passed too many surfaces, once the picture is rendered.
void warn_of_cut_stacks(RenderReport& report);

/// Says it, in a bounded number of lines.
void say_warnings(const RenderReport& report, std::ostream& err);

}  // namespace asos
