#pragma once

#include <string>

namespace asos {

/// What of a sky's file (.hdr or .exr) read_sky does not show: that it is shown with fewer pixels
/// than it has. As it may be printed; empty: nothing, or it cannot be read.
[[nodiscard]] std::string sky_remark(const std::string& path);

}  // namespace asos
