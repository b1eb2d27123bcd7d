#pragma once

#include <string>

namespace asos {

/// Returns a warning if read_sky reduces the number of pixels of a sky's file (.hdr or .exr). It is
/// safe to print. Empty if there is none, or if the file is not readable.
[[nodiscard]] std::string sky_warning(const std::string& path);

}  // namespace asos
