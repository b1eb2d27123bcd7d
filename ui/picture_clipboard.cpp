#include "ui/picture_clipboard.h"

#include "renderer/files/helper_program.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace asos::ui {

namespace {

constexpr std::chrono::seconds longest{10};

Result<void> copy(const std::vector<std::string>& command, const RgbImage& image,
                  const std::stop_token& stop) {
  std::error_code ignored;
  const std::string path = (std::filesystem::temp_directory_path(ignored) /
                            fmt::format("asos-clipboard-{}.png", getpid()))
                               .string();
  if (const Result<void> written = write_png(path, image); !written) return written;
  const auto begin = std::chrono::steady_clock::now();
  Result<void> copied = run_program(command, path, [&] {
    return stop.stop_requested() || std::chrono::steady_clock::now() - begin > longest;
  });
  std::filesystem::remove(path, ignored);
  return copied;
}

}  // namespace

Result<std::vector<std::string>> clipboard_command() {
  const char* wayland = std::getenv("WAYLAND_DISPLAY");
  if (wayland && *wayland) {
    if (const std::string path = find_program("wl-copy"); !path.empty())
      return std::vector<std::string>{path, "--type", "image/png"};
    return unexpected(Error{"clipboard", "copying pictures needs wl-copy (wl-clipboard)"});
  }
  if (const std::string path = find_program("xclip"); !path.empty())
    return std::vector<std::string>{path, "-selection", "clipboard", "-t", "image/png", "-i"};
  return unexpected(Error{"clipboard", "copying pictures needs xclip"});
}

Result<void> copy_picture(ClipboardJob& job, RgbImage image) {
  const Result<std::vector<std::string>> command = clipboard_command();
  if (!command) return unexpected(command.error());
  if (job.busy()) return {};
  // Shared, because std::function needs a copyable capture.
  auto picture = std::make_shared<const RgbImage>(std::move(image));
  job.start([command = *command, picture](const std::stop_token& stop, const auto& tell) {
    tell(copy(command, *picture, stop));
  });
  return {};
}

}  // namespace asos::ui
