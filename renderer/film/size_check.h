#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace asos {

/// Returns the reason why a picture of this size is refused; empty: it is accepted. Readers call it
/// before they allocate the picture. Without a check, all sizes are accepted.
using SizeCheck = std::function<std::string(std::int64_t width, std::int64_t height)>;

}  // namespace asos
