#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/film/image_io.h"
#include "renderer/film/statistics.h"
#include "renderer/picture/picture_description.h"
#include "renderer/scene/scene.h"
#include "renderer/session/render_session.h"
#include "renderer/world/needs.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asos {

/// A light as the scene names it.
struct ReportedLight {
  std::string name;
  Light::Type type = Light::Type::point;
};

/// The request, contents and cost of a finished render: told in --stats and inside the picture.
struct RenderReport {
  std::string scene;  ///< as named on the command line
  std::uint64_t triangles = 0;
  std::optional<FeatureCounts> feature_edges;  ///< none: a limit of time came before
  std::vector<std::string> warnings;           ///< the scene's remarks
  std::vector<std::string> camera_notes;       ///< see fit_remark and planes_remark
  std::uint64_t warning_count = 0;             ///< with those that the last of them only counts
  PictureDescription description;
  bool kept = false;                  ///< it was there before; then nothing below is known
  std::vector<ReportedLight> lights;  ///< in the order of Lighting::lights
  int threads = 0;                    ///< that worked
  RenderStatistics statistics;
  double load_seconds = 0.0;   ///< reading the file or making the built-in scene
  double build_seconds = 0.0;  ///< flattening, and the hierarchies of rays and, without a limit of
                               ///< time, of boundaries
  double render_seconds = 0.0;
  std::optional<double> time_limit_seconds;  ///< that was asked for
  std::optional<Reached> stopped_at;         ///< where the limit ended the render
  double memory_mb = 0.0;                    ///< the process's peak, in 10^6 bytes
  SceneNeeds needs;                          ///< of the scene, and those that were forced
};

/// The statistics as the --stats file has them.
[[nodiscard]] nlohmann::ordered_json statistics_json(const RenderReport& report);

/// The same as the text of a file, in ASCII whatever the names are made of: see json_text.
[[nodiscard]] std::string statistics_text(const RenderReport& report);

/// The text chunks of a PNG and the attributes of an EXR: how the picture can be made again, and
/// the statistics.
[[nodiscard]] ImageText picture_metadata(const RenderReport& report);

/// How far a picture came whose time was limited, in words: "MAX 1 everywhere, 37 % final".
[[nodiscard]] std::string reached_text(const Reached& reached);

/// The most memory that this process has held, in 10^6 bytes.
[[nodiscard]] double peak_memory_mb();

}  // namespace asos
