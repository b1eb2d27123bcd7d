#include "renderer/gltf/data_uri.h"

#include <cstdint>

namespace asos::gltf {

namespace {

bool is_white_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return -1;
}

Checked<UriBytes> base64_decoded(std::string_view text) {
  UriBytes out;
  out.bytes.reserve(text.size() / 4 * 3 + 3);
  bool skipped = false;
  while (!text.empty() && (text.back() == '=' || is_white_space(text.back()))) {
    skipped |= is_white_space(text.back());
    text.remove_suffix(1);
  }
  std::uint32_t bits = 0;
  std::size_t digits = 0;
  int held = 0;
  for (const char c : text) {
    if (is_white_space(c)) {
      skipped = true;
      continue;
    }
    const int value = base64_digit(c);
    if (value < 0) return fault("the base64 data has a character that is not base64");
    bits = (bits << 6) | static_cast<std::uint32_t>(value);
    held += 6;
    ++digits;
    if (held >= 8) {
      held -= 8;
      out.bytes.push_back(static_cast<std::uint8_t>(bits >> held));
    }
  }
  if (digits % 4 == 1) return fault("the base64 data is cut off");
  if (skipped) out.remark = "white space in its base64 data is skipped";
  return out;
}

}  // namespace

Checked<UriBytes> read_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return fault("a data URI has no data");
  const std::string_view head = uri.substr(0, comma), body = uri.substr(comma + 1);
  const bool escaped = body.find('%') != std::string_view::npos;
  if (!lower_case(head).ends_with(";base64")) {
    const std::string plain = percent_decoded(body);
    return UriBytes{FileBytes(plain.begin(), plain.end()), {}};
  }
  return escaped ? base64_decoded(percent_decoded(body)) : base64_decoded(body);
}

}  // namespace asos::gltf
