#include "renderer/picture/path_text.h"

#include "renderer/files/printable.h"
#include "renderer/gltf/files.h"

#include <fmt/format.h>

namespace asos {
namespace {

constexpr std::string_view scheme = "file://";

}  // namespace

std::string text_of_path(std::string_view path) {
  // Encode a path that starts with the scheme, too; otherwise it would be read as another path.
  if (is_utf8(path) && !path.starts_with(scheme)) return std::string(path);
  std::string text(scheme);
  for (const char c : path) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                       std::string_view("/-._~").find(c) != std::string_view::npos;
    text += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return text;
}

std::string path_of_text(std::string_view text) {
  if (!text.starts_with(scheme)) return std::string(text);
  return gltf::percent_decoded(text.substr(scheme.size()));
}

}  // namespace asos
