#include "ui/screenshot.h"

#include <fmt/format.h>

#include <cstdlib>
#include <system_error>

namespace asos {

std::filesystem::path screenshot_folder() {
  std::error_code ignored;
  const char* pictures = std::getenv("XDG_PICTURES_DIR");
  if (pictures && std::filesystem::is_directory(pictures, ignored)) return pictures;
  const std::filesystem::path here = std::filesystem::current_path(ignored);
  return here.empty() ? std::filesystem::path(".") : here;
}

std::string screenshot_stem(const std::string& source) {
  std::string stem = source.starts_with("builtin:") ? source.substr(8)
                                                    : std::filesystem::path(source).stem().string();
  for (char& c : stem) {
    if (c == '/' || static_cast<unsigned char>(c) < 0x20) c = '_';
  }
  return stem.empty() ? "picture" : stem;
}

Result<std::string> save_screenshot(const RgbImage& image, const std::filesystem::path& folder,
                                    const std::string& stem) {
  constexpr int most = 9999;
  for (int number = 1; number <= most; ++number) {
    const std::filesystem::path path = folder / fmt::format("{}-{:03}.png", stem, number);
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) continue;
    if (const Result<void> written = write_png(path.string(), image); !written) {
      return unexpected(written.error());
    }
    return path.string();
  }
  return unexpected(Error{folder.string(), fmt::format("holds {} screenshots of {}", most, stem)});
}

}  // namespace asos
