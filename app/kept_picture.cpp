#include "app/kept_picture.h"

#include "app/picture_files.h"
#include "renderer/film/image_io.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace asos {
namespace {

using Time = std::filesystem::file_time_type;

std::optional<Time> written(const std::string& path) {
  std::error_code error;
  const Time time = std::filesystem::last_write_time(path, error);
  return error ? std::nullopt : std::optional(time);
}

const std::string* text_of(const ImageText& text, const char* key) {
  const auto found =
      std::find_if(text.begin(), text.end(), [&](const auto& entry) { return entry.first == key; });
  return found == text.end() ? nullptr : &found->second;
}

/// Whether a time limit ended the picture before it was finished.
bool was_stopped(const std::string& statistics) {
  const auto json = nlohmann::json::parse(statistics, nullptr, false);
  if (!json.is_object()) return true;
  const auto limit = json.find("time_limit");
  return limit != json.end() && !(limit->is_object() && limit->value("finished", false));
}

/// Whether the file is a finished picture with these settings.
bool holds(const std::string& path, const PictureDescription& wanted) {
  const Result<ImageText> text = read_image_text(path);
  if (!text) return false;
  const std::string* description = text_of(*text, PictureDescription::key);
  const std::string* statistics = text_of(*text, "asos.statistics");
  return description && *description == description_text(wanted) && statistics &&
         !was_stopped(*statistics);
}

}  // namespace

bool is_rendered(const RenderArguments& arguments, const PictureDescription& wanted,
                 const std::vector<std::string>& sources) {
  std::optional<Time> newest_source;
  for (const std::string& source : sources)
    if (const auto time = written(source)) newest_source = std::max(newest_source, time);
  for (const std::string* path : {&arguments.output, &arguments.split_map, &arguments.stats_file}) {
    if (path->empty()) continue;
    const auto time = written(*path);
    if (!time || (newest_source && *time <= *newest_source)) return false;
  }
  if (!holds(arguments.output, wanted)) return false;
  if (arguments.split_map.empty()) return true;
  PictureDescription map = wanted;
  map.display = split_map_display(wanted.display, arguments.split_map_by);
  return holds(arguments.split_map, map);
}

}  // namespace asos
