#pragma once

#include <string>
#include <string_view>

namespace asos {

/// Returns how a picture looks without a glTF extension; empty if unknown.
[[nodiscard]] std::string_view seen_without(std::string_view extension);

/// Returns a line about an unsupported glTF extension: its name, and how a picture looks without
/// it, if known.
[[nodiscard]] std::string unsupported_line(std::string_view extension);

}  // namespace asos
