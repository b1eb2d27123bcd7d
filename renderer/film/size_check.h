#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace asos {

/// Why a picture of that many pixels is not wanted, empty: it is. Without one, all are. Readers ask
/// before they make room for the picture.
using SizeCheck = std::function<std::string(std::int64_t width, std::int64_t height)>;

}  // namespace asos
