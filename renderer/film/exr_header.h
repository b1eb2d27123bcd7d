#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace asos {

/// Returns an error text if an EXR's header declares more bytes than the file has; else empty.
/// OpenEXR allocates the declared size of an attribute before it notices missing bytes, so the
/// sizes are checked first (OpenEXR's "File Layout", "Attribute Layout"). All other errors are left
/// to OpenEXR. Any bytes.
[[nodiscard]] std::string exr_header_error(std::span<const std::uint8_t> file);

}  // namespace asos
