#include "renderer/gltf/files.h"

#include <fmt/format.h>

#include <cstdint>

namespace asos::gltf {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t largest_outside_file = std::uint64_t{8} << 30;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

bool has_scheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  return colon != std::string_view::npos && colon < uri.find_first_of("/\\");
}

Checked<FileBytes> read_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return fault("a data URI has no data");
  const std::string_view head = uri.substr(0, comma), body = uri.substr(comma + 1);
  if (head.ends_with(";base64")) return base64_decoded(body);
  const std::string plain = percent_decoded(body);
  return FileBytes(plain.begin(), plain.end());
}

/// Where `relative` leads to, if that is inside `folder`.
Checked<fs::path> inside(const fs::path& folder, const std::string& relative) {
  const fs::path wanted(relative);
  if (relative.empty()) return fault("it is empty");
  if (relative.find('\0') != std::string::npos) return fault("it contains a zero byte");
  if (wanted.is_absolute()) return fault("it is an absolute path");
  for (const fs::path& step : wanted) {
    if (step == "..") return fault("it leads out of the file's folder");
  }
  std::error_code error;
  const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
  if (error) return fault(fmt::format("the folder cannot be read ({})", error.message()));
  const fs::path target = fs::weakly_canonical(root / wanted, error);
  if (error) return fault(fmt::format("it cannot be found ({})", error.message()));
  const fs::path step = target.lexically_relative(root);
  if (step.empty() || *step.begin() == "..") {
    return fault("a symbolic link leads out of the file's folder");
  }
  return target;
}

}  // namespace

Checked<fs::path> file_of_uri(const fs::path& folder, std::string_view uri) {
  if (uri.starts_with("data:") || has_scheme(uri))
    return fault(fmt::format("'{}' is not a local file", shown_uri(uri)));
  Checked<fs::path> path = inside(folder, percent_decoded(uri));
  std::error_code error;
  if (path && uri.find('%') != std::string_view::npos && !fs::exists(*path, error)) {
    const Checked<fs::path> as_written = inside(folder, std::string(uri));
    if (as_written && fs::exists(*as_written, error)) return as_written;
  }
  if (!path) return fault(fmt::format("'{}' is refused: {}", shown_uri(uri), path.error()));
  return path;
}

Checked<FileBytes> read_uri(const fs::path& folder, std::string_view uri) {
  if (uri.starts_with("data:")) return read_data_uri(uri);
  const Checked<fs::path> path = file_of_uri(folder, uri);
  if (!path) return fault(path.error());
  Checked<FileBytes> bytes = read_file(*path, {largest_outside_file});
  if (!bytes) return fault(fmt::format("'{}' cannot be read: {}", shown_uri(uri), bytes.error()));
  return bytes;
}

std::string percent_decoded(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 &&
        hex_digit(text[i + 2]) >= 0) {
      out.push_back(static_cast<char>(hex_digit(text[i + 1]) * 16 + hex_digit(text[i + 2])));
      i += 2;
    } else {
      out.push_back(text[i]);
    }
  }
  return out;
}

Checked<FileBytes> base64_decoded(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  if (text.size() % 4 == 1) return fault("the base64 data is cut off");
  FileBytes out;
  out.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    int value = -1;
    if (c >= 'A' && c <= 'Z') value = c - 'A';
    if (c >= 'a' && c <= 'z') value = c - 'a' + 26;
    if (c >= '0' && c <= '9') value = c - '0' + 52;
    if (c == '+' || c == '-') value = 62;
    if (c == '/' || c == '_') value = 63;
    if (value < 0) return fault("the base64 data has a character that is not base64");
    bits = (bits << 6) | static_cast<std::uint32_t>(value);
    held += 6;
    if (held >= 8) {
      held -= 8;
      out.push_back(static_cast<std::uint8_t>(bits >> held));
    }
  }
  return out;
}

std::string shown_uri(std::string_view uri) {
  if (uri.starts_with("data:")) return "data URI";
  if (uri.size() <= 120) return std::string(uri);
  return std::string(uri.substr(0, 117)) + "...";
}

}  // namespace asos::gltf
