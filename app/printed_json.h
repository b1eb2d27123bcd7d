#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace asos {

/// Formats JSON as lines of ASCII, without control characters that a terminal would execute.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

/// The same JSON with all texts made printable, for reports.
[[nodiscard]] nlohmann::ordered_json with_printable_texts(const nlohmann::ordered_json& json);

}  // namespace asos
