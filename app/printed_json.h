#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace asos {

/// JSON as it is printed: lines of ASCII, in which a terminal finds nothing to obey.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

/// The same with all texts in it as they may be shown (printable), for reports made of them.
[[nodiscard]] nlohmann::ordered_json with_printable_texts(const nlohmann::ordered_json& json);

}  // namespace asos
