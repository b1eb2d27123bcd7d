#pragma once

#include "app/render_report.h"
#include "renderer/prepared/render_scene.h"

#include <iosfwd>

namespace asos {

/// Adds warnings about parts of the scene that the picture lacks. More are known once the edges
/// are.
void tell_warnings(RenderReport& report, const RenderScene& scene, const SkyChoice& sky);

/// Adds a warning after rendering if rays passed through too many surfaces.
void warn_of_cut_stacks(RenderReport& report);

/// Prints the warnings in a limited number of lines.
void say_warnings(const RenderReport& report, std::ostream& err);

}  // namespace asos
