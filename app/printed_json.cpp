#include "app/printed_json.h"

#include "renderer/files/printable.h"

#include <nlohmann/json.hpp>

namespace asos {

using Json = nlohmann::ordered_json;

std::string json_text(const Json& json) {
  return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

Json with_printable_texts(const Json& json) {
  if (json.is_string()) return printable(json.get_ref<const std::string&>());
  // A scalar would be its own only item.
  if (!json.is_structured()) return json;
  Json shown = json;
  for (auto& item : shown.items()) item.value() = with_printable_texts(item.value());
  return shown;
}

}  // namespace asos
