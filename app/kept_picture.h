#pragma once

#include "app/render_arguments.h"
#include "renderer/picture/picture_description.h"

#include <string>
#include <vector>

namespace asos {

/// Whether all output files of `arguments` exist, are newer than `sources`, and the picture is a
/// finished one with these settings, so that it need not be rendered again.
[[nodiscard]] bool is_rendered(const RenderArguments& arguments, const PictureDescription& wanted,
                               const std::vector<std::string>& sources);

}  // namespace asos
