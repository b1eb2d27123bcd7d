#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/film/image_io.h"
#include "renderer/film/statistics.h"
#include "renderer/picture/picture_description.h"
#include "renderer/scene/scene.h"
#include "renderer/session/render_session.h"
#include "renderer/world/render_features.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asos {

/// A light with its name in the scene.
struct ReportedLight {
  std::string name;
  Light::Type type{};
};

/// Input, contents and cost of a finished render, for --stats and the picture's metadata.
struct RenderReport {
  std::string scene;  ///< as named on the command line
  std::uint64_t triangles = 0;
  std::optional<FeatureCounts> feature_edges;  ///< none: a time limit ended the render earlier
  std::vector<std::string> warnings;           ///< the scene's warnings
  std::vector<std::string> camera_notes;       ///< on the fit, lens, planes and shutter
  std::uint64_t warning_count = 0;             ///< total; the last of `warnings` may count several
  PictureDescription description;
  bool kept = false;                  ///< not rendered again; nothing below is known
  std::vector<ReportedLight> lights;  ///< in the order of Lighting::lights
  int threads = 0;                    ///< worker threads
  RenderStatistics statistics;
  double load_seconds = 0.0;   ///< reading the file or making the built-in scene
  double build_seconds = 0.0;  ///< preparing the scene; edges only if the render waits for them
  double render_seconds = 0.0;
  std::optional<double> time_limit_seconds;  ///< that was asked for
  std::optional<Reached> stopped_at;         ///< where the time limit ended the render
  bool interrupted = false;                  ///< an interrupt ended it before the limit
  bool shows_nothing = false;                ///< no object is visible at the picture's time
  double memory_mb = 0.0;                    ///< peak memory of the process, in 10^6 bytes
  RenderFeatures render_features;            ///< features of the scene, and forced ones
};

/// The statistics in the form of the --stats file.
[[nodiscard]] nlohmann::ordered_json statistics_json(const RenderReport& report);

/// The same as text, always ASCII: see json_text.
[[nodiscard]] std::string statistics_text(const RenderReport& report);

/// PNG text chunks or EXR attributes: everything needed to render the picture again, and the
/// statistics.
[[nodiscard]] ImageText picture_metadata(const RenderReport& report);

/// Progress of a picture that a time limit ended, in words: "4 samples a pixel everywhere, 37 %
/// final".
[[nodiscard]] std::string reached_text(const Reached& reached);

/// Peak memory of this process, in 10^6 bytes.
[[nodiscard]] double peak_memory_mb();

}  // namespace asos
