#include "ui/screenshot.h"

#include "renderer/picture/picture_text.h"
#include "renderer/world/ground.h"
#include "ui/display_settings.h"
#include "ui/previewer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace asos::ui {

std::filesystem::path screenshot_folder() {
  std::error_code ignored;
  const char* pictures = std::getenv("XDG_PICTURES_DIR");
  if (pictures && std::filesystem::is_directory(pictures, ignored)) return pictures;
  const std::filesystem::path here = std::filesystem::current_path(ignored);
  return here.empty() ? std::filesystem::path(".") : here;
}

std::string file_title(const std::string& source) {
  if (source.starts_with("builtin:")) return source.substr(8);
  return std::filesystem::path(source).filename().string();
}

std::string screenshot_stem(const std::string& source) {
  std::string stem = source.starts_with("builtin:") ? source.substr(8)
                                                    : std::filesystem::path(source).stem().string();
  for (char& c : stem) {
    if (c == '/' || static_cast<unsigned char>(c) < 0x20) c = '_';
  }
  return stem.empty() ? "picture" : stem;
}

ImageText screenshot_text(const Previewer& previewer, const DisplaySettings& display) {
  const Progress progress = previewer.render().progress();
  nlohmann::ordered_json statistics{
      {"triangles", triangles_without_ground(previewer.scene()->world())},
      {"render_seconds", progress.seconds},
      {"finished_percent", 100.0 * progress.fraction},
  };
  statistics.update(counts_json(previewer.render().statistics()));
  return picture_text(previewer.render().description(described(display)), statistics);
}

PictureDisplay described(const DisplaySettings& display) {
  return {display.exposure_ev, display.show_split_map, display.split_colours, display.split_dimming,
          display.tone};
}

void show_as(const PictureDisplay& described, DisplaySettings& display) {
  constexpr float ev = DisplaySettings::exposure_limit_ev;
  display.exposure_ev = std::clamp(described.exposure_ev, -ev, ev);
  display.tone = described.tone;
  display.show_split_map = described.split_map;
  if (!described.split_map) return;
  display.split_colours = described.split_colours;
  display.split_dimming = std::clamp(described.split_dimming, 0.0f, 1.0f);
}

std::string free_stem(const std::filesystem::path& folder, const std::string& name,
                      std::initializer_list<const char*> endings) {
  for (int number = 1;; ++number) {
    std::string stem = (folder / fmt::format("{}-{:03}", name, number)).string();
    const auto taken = [&](const char* ending) {
      std::error_code ignored;
      return std::filesystem::exists(stem + ending, ignored);
    };
    if (std::none_of(endings.begin(), endings.end(), taken)) return stem;
  }
}

Result<std::string> save_screenshot(const RgbImage& image, const std::filesystem::path& folder,
                                    const std::string& name) {
  const std::string path = free_stem(folder, name) + ".png";
  return write_png(path, image).map([&] { return path; });
}

}  // namespace asos::ui
