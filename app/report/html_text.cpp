#include "app/report/html_text.h"

#include "renderer/files/base64.h"
#include "renderer/files/read_file.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

namespace asos {

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string seconds_text(double seconds) {
  if (seconds >= 90.0) {
    const long whole = std::lround(seconds);
    return fmt::format("{} min {} s", whole / 60, whole % 60);
  }
  if (seconds >= 0.1 || seconds <= 0.0) return fmt::format("{:#.3g} s", seconds);
  return fmt::format("{:#.3g} ms", 1000.0 * seconds);
}

std::string error_text(double error) {
  if (error == 0.0) return "0";
  if (!std::isfinite(error)) return "not finite";
  // Removes the leading zero of the exponent.
  std::string text = fmt::format("{:.2e}", error);
  if (text[text.size() - 2] == '0') text.erase(text.size() - 2, 1);
  return text;
}

std::string shown_error(const StudyPoint& point) {
  return point.under_floor ? "under the floor" : error_text(point.measures.rmse);
}

std::string factor_text(double factor) {
  if (factor >= 100.0) return fmt::format("{:.0f}", factor);
  if (factor >= 10.0) return fmt::format("{:.1f}", factor);
  return fmt::format("{:.2f}", factor);
}

std::string count_text(std::uint64_t count) {
  const std::string digits = std::to_string(count);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += "\u202f";
    text += digits[i];
  }
  return text;
}

std::string list_text(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

Outcome outcome_of(double factor) {
  if (factor >= 1.0 + even_band) return Outcome::win;
  return factor <= 1.0 - even_band ? Outcome::loss : Outcome::even;
}

std::string page_head(const std::string& title, const char* style) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n",
      title, style);
}

std::string Embedder::uri(const std::string& path) {
  constexpr std::uint64_t most_bytes = std::uint64_t{1} << 30;
  const auto bytes = read_file(path, {most_bytes});
  if (!bytes || bytes->empty()) {
    if (!error_) error_ = Error{path, bytes ? "is empty" : bytes.error()};
    return "";
  }
  const char* type = path.ends_with(".svg") ? "image/svg+xml" : "image/png";
  return fmt::format("data:{};base64,{}", type, base64(*bytes));
}

}  // namespace asos
