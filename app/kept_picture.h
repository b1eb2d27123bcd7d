#pragma once

#include "app/render_arguments.h"
#include "renderer/picture/picture_description.h"

#include <string>
#include <vector>

namespace asos {

/// Whether all files that `arguments` ask for are there, are newer than `sources`, and the picture
/// among them is a finished one of these settings: rendering it would only make it again.
[[nodiscard]] bool is_rendered(const RenderArguments& arguments, const PictureDescription& wanted,
                               const std::vector<std::string>& sources);

}  // namespace asos
