#include "app/picture_files.h"

#include "renderer/film/image_io.h"
#include "renderer/scene/source_files.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

namespace asos {
namespace fs = std::filesystem;
namespace {

Result<std::optional<OutputFile>> plan_optional(const std::string& path) {
  if (path.empty()) return std::optional<OutputFile>{};
  return OutputFile::plan(path).map([](OutputFile file) { return std::optional(std::move(file)); });
}

Result<void> write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) return tl::unexpected(Error{path, std::strerror(errno)});
  return {};
}

Result<void> write_split_map(const std::string& path, const Film& film, const RenderReport& report,
                             SplitMapColours colours) {
  RenderReport of_map = report;
  PictureDisplay& display = of_map.description.display;
  display = split_map_display(display, colours);
  return write_split_map_png(path, film, {colours}, picture_metadata(of_map));
}

std::array<const std::string*, 3> outputs_of(const RenderArguments& arguments) {
  return {&arguments.output, &arguments.split_map, &arguments.stats_file};
}

}  // namespace

PictureDisplay split_map_display(const PictureDisplay& display, SplitMapColours colours) {
  return {display.exposure_ev, true, colours, 1.0f, display.tone};
}

bool is_picture_path(const std::string& path) {
  return has_extension(path, ".png") || has_extension(path, ".exr");
}

Result<void> check_inputs_stay(const RenderArguments& arguments) {
  const std::string& scene = arguments.picture.scene;
  const std::string& root = arguments.picture.asset_root;
  std::vector<std::string> inputs{scene, arguments.picture.sky.file};
  // Reads the scene for its textures and buffers only if the output may be one of them.
  for (const std::string* output : outputs_of(arguments)) {
    std::error_code error;
    if (output->empty() || !fs::exists(*output, error) || same_file(*output, scene)) continue;
    if (!may_be_source_file(*output, scene, root)) continue;
    inputs = source_files(scene, root);
    inputs.push_back(arguments.picture.sky.file);
    break;
  }
  return check_inputs_stay(arguments, inputs);
}

Result<void> check_inputs_stay(const RenderArguments& arguments,
                               const std::vector<std::string>& inputs) {
  for (const std::string* output : outputs_of(arguments)) {
    std::error_code error;
    if (output->empty() || !fs::exists(*output, error)) continue;
    for (const std::string& input : inputs)
      if (!input.empty() && same_file(*output, input))
        return tl::unexpected(
            Error{*output, "is what the picture is made of; it is not written over"});
  }
  return {};
}

Result<OutputPlan> plan_outputs(const RenderArguments& arguments) {
  const auto picture = OutputFile::plan(arguments.output);
  if (!picture) return tl::unexpected(picture.error());
  const auto split_map = plan_optional(arguments.split_map);
  if (!split_map) return tl::unexpected(split_map.error());
  const auto stats = plan_optional(arguments.stats_file);
  if (!stats) return tl::unexpected(stats.error());
  return OutputPlan{*picture, *split_map, arguments.split_map_by, *stats};
}

Result<void> write_outputs(const OutputPlan& plan, const Film& film, const RenderReport& report,
                           const ExrOptions& exr) {
  const ImageText text = picture_metadata(report);
  Result<void> written = plan.picture.commit([&](const std::string& path) {
    return has_extension(path, ".exr")
               ? write_exr(path, film, text, exr)
               : write_png(path, film, report.description.display.transform(), text);
  });
  if (written && plan.split_map)
    written = plan.split_map->commit([&](const std::string& path) {
      return write_split_map(path, film, report, plan.split_map_by);
    });
  if (written && plan.stats)
    written = plan.stats->commit(
        [&](const std::string& path) { return write_text(path, statistics_text(report)); });
  return written;
}

}  // namespace asos
