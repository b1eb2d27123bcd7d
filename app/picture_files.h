#pragma once

#include "app/output_file.h"
#include "app/render_arguments.h"
#include "app/render_report.h"
#include "renderer/film/exr_options.h"
#include "renderer/film/film.h"
#include "renderer/film/split_map.h"
#include "renderer/result.h"

#include <optional>
#include <string>
#include <vector>

namespace asos {

/// The output files of a render, checked to be writable.
struct OutputPlan {
  OutputFile picture;
  std::optional<OutputFile> split_map;
  SplitMapColours split_map_by = SplitMapColours::level;
  std::optional<OutputFile> stats;
};

/// Whether the path has the extension of a picture format: .png or .exr.
[[nodiscard]] bool is_picture_path(const std::string& path);

/// The display settings of the split map that belongs to a picture with these settings.
[[nodiscard]] PictureDisplay split_map_display(const PictureDisplay& display,
                                               SplitMapColours colours);

/// Error if an output would overwrite the scene, one of its files, or the sky's file.
[[nodiscard]] Result<void> check_inputs_stay(const RenderArguments& arguments);

/// The same for known source files.
[[nodiscard]] Result<void> check_inputs_stay(const RenderArguments& arguments,
                                             const std::vector<std::string>& inputs);

[[nodiscard]] Result<OutputPlan> plan_outputs(const RenderArguments& arguments);

/// Writes the picture, the split map and the statistics. `exr`: what an EXR holds beside them.
[[nodiscard]] Result<void> write_outputs(const OutputPlan& plan, const Film& film,
                                         const RenderReport& report, const ExrOptions& exr);

}  // namespace asos
