#pragma once

#include "app/camera_choice.h"
#include "renderer/asos/pixel_trace.h"
#include "renderer/gltf/load.h"
#include "renderer/session/render_session.h"
#include "renderer/study/curves.h"
#include "renderer/study/measures.h"
#include "renderer/study/timed_render.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// Functions that the benchmarks share: opening scenes, timed renders, errors of pictures.

namespace asos::bench {

using SharedScene = std::shared_ptr<const RenderScene>;

[[nodiscard]] double seconds_since(std::chrono::steady_clock::time_point start);

struct Seconds {
  double wall = 0.0;
  double cpu = 0.0;  ///< of all threads together
};

/// Times of several runs, for medians.
class Times {
 public:
  RenderResult render(const Snapshot& snapshot);
  [[nodiscard]] Seconds medians() const { return {median(wall_), median(cpu_)}; }

 private:
  std::vector<double> wall_;
  std::vector<double> cpu_;
};

struct NamedScene {
  std::string name;
  std::string source;
};
/// Scenes by name, or by an argument of `asos render`; "models" and "builtin" are sets. Without
/// names: all models in $ASOS_SHARED/scenes, which are those that people open, or the built-in
/// scenes if there are none.
[[nodiscard]] std::vector<NamedScene> chosen_scenes(const std::vector<std::string>& chosen);

/// Returns a scene as `asos render` renders it: in the light and on the ground of its default look.
[[nodiscard]] Result<SharedScene> as_rendered(SharedScene scene);
/// Opens such a scene, with its boundaries.
[[nodiscard]] Result<SharedScene> open_scene(const std::string& source);

/// How a benchmark's picture is exposed: by the camera's lens, and over the time of an animation.
struct ExposureChoice {
  double f_stop = 0.0;           ///< 0: the camera's own lens
  double focus = 0.0;            ///< 0: the camera's own, or automatic
  int animation = -1;            ///< -1: the rest pose
  double seconds = 0.0;          ///< of the animation
  double shutter_seconds = 0.0;  ///< 0: one moment

  /// For names of files; empty: the file's own exposure.
  [[nodiscard]] std::string label() const;
};

/// Opens a scene and takes its picture (snapshot_of) by this camera and exposure. The exposure's
/// moments are prepared with their boundaries.
[[nodiscard]] Result<Snapshot> exposed_snapshot(const std::string& source, PictureSize size,
                                                CameraChoice camera,
                                                const ExposureChoice& exposure);

/// Returns the inputs of a render of the whole picture, without coarse passes. The camera is the
/// scene's first, or else one that frames the scene. Sky and background are those of `asos render`.
[[nodiscard]] Snapshot snapshot_of(SharedScene scene, int width, int height);

/// A camera at `eye` that looks at `target`, both in the author's coordinates.
[[nodiscard]] Camera camera_at(const World& world, glm::dvec3 eye, glm::dvec3 target,
                               double fov_y_deg);

/// Root mean square errors of a picture over all pixels and channels.
struct PictureError {
  double shown = 0.0;  ///< error of radiance clipped to 0..1
  double raw = 0.0;
};
[[nodiscard]] PictureError picture_error(const Film& film, const Film& reference);

/// Pixel indices, worst first, by squared error of radiance clipped to 0..1.
[[nodiscard]] std::vector<std::size_t> worst_pixels(const Film& film, const Film& reference);

/// How a pixel was finished.
enum class Outcome { one_sample, resolved, unresolved, saturated, by_samples };
inline constexpr int outcome_count = 5;
[[nodiscard]] const char* name_of(Outcome outcome);
[[nodiscard]] Outcome outcome_of(const PixelTrace& trace);
[[nodiscard]] std::size_t samples_of(const PixelTrace& trace);

/// Traces one pixel of a snapshot's picture quickly, in the smallest fat pyray. Without neighbours,
/// a pixel of a bumpy surface may be split less than in a larger fat pyray.
[[nodiscard]] PixelTrace trace_of(const Snapshot& snapshot, std::size_t pixel);

/// Prints the error and returns the exit code.
int fail(const Error& error);

}  // namespace asos::bench
