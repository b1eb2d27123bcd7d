#pragma once

#include "renderer/asos/pixel_trace.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/session/render_session.h"
#include "ui/latest_job.h"
#include "ui/seen_parts.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace asos::ui {

class Previewer;

/// An edge projected into the picture, in pixels.
struct PictureBoundary {
  glm::vec2 from{0.0f};
  glm::vec2 to{0.0f};
  FeatureKind kind = FeatureKind::open;
};

/// How a pixel was split, prepared for drawing, and the edges of the picture.
struct PixelReport {
  glm::ivec2 pixel{0};
  PixelTrace trace;
  RenderSettings settings;
  std::vector<SeenPart> seen;                     ///< parts of the pixel's cells
  std::vector<std::vector<SeenPart>> pyray_seen;  ///< the same for each entry of trace.pyrays
  std::set<std::uint32_t> unlit;  ///< triangles of unlit surfaces at the samples of trace.cells
  std::vector<std::string> pyray_names;   ///< a short description of each of them
  std::vector<std::string> level_object;  ///< name of the object of largest change, per level
  /// The edges in the whole picture's hit list, if requested; `most_boundaries` at most.
  std::vector<PictureBoundary> boundaries;
  bool all_boundaries = true;  ///< false: there are more
  static constexpr std::size_t most_boundaries = 20'000;

  /// The level, samples and cause as in the split map.
  [[nodiscard]] std::string split() const;
  /// Why the splitting stopped, in one sentence.
  [[nodiscard]] std::string verdict() const;
};

/// Index of the smallest cell that contains the point, 0 to 1 in both directions. Cells must not be
/// empty.
[[nodiscard]] std::size_t cell_at(const std::vector<TracedCell>& cells, glm::vec2 place);

/// A shadow pyray's light, its visibility, and the weight and cells of the pyray:
/// "lamp: 37 % visible (12 % of pixel, 5 cells)".
[[nodiscard]] std::string shadow_words(const std::string& light, const TracedPyray& pyray);
[[nodiscard]] const char* words_of(CellFate fate);
/// The counts of a cell's edges: "1 edge, 2 hidden edges".
[[nodiscard]] std::string edge_words(const TracedCell& cell);

/// Traces the picked pixel on its own thread, and again whenever its inputs have changed. All
/// members must be called from one thread.
class PixelInspector {
 public:
  PixelInspector();

  /// Call once a frame. `boundaries`: whether the report includes the picture's edges.
  void update(const Previewer& previewer, std::optional<glm::ivec2> picked, bool boundaries);
  /// The report on the picked pixel, possibly for an older view; null: none.
  [[nodiscard]] const PixelReport* report() const { return report_ ? &*report_ : nullptr; }
  [[nodiscard]] bool busy() const { return job_.pending(); }

 private:
  struct Request {
    Snapshot picture;
    glm::ivec2 pixel{0};
    bool with_boundaries = false;
  };
  struct Asked {
    const RenderScene* scene = nullptr;
    std::uint64_t camera_revision = 0;
    RenderSettings settings;
    std::optional<glm::ivec2> pixel;
    bool boundaries = false;
    bool operator==(const Asked&) const = default;
  };
  [[nodiscard]] static PixelReport work(const Request& request);

  Asked asked_;
  std::optional<PixelReport> report_;
  LatestJob<Request, PixelReport> job_;
};

}  // namespace asos::ui
