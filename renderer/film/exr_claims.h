#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace asos {

/// Why an EXR's header claims more than its file holds; empty where it does not. OpenEXR allocates
/// what an attribute claims before it finds out that the bytes are not there, so that the claims
/// are read first (OpenEXR's "File Layout", "Attribute Layout"). Whatever else is wrong is for
/// OpenEXR to find. Any bytes.
[[nodiscard]] std::string fault_of_exr_claims(std::span<const std::uint8_t> file);

}  // namespace asos
