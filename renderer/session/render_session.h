#pragma once

#include "renderer/film/film.h"
#include "renderer/film/statistics.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/scene/scene.h"
#include "renderer/settings/settings.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace asos {

/// All inputs of a render; immutable once handed over.
struct Snapshot {
  std::shared_ptr<const RenderScene> scene;
  Camera camera;  ///< relative to scene->world().origin
  RenderSettings settings;
  bool progressive = true;  ///< coarse passes first (window); false: final pixels only (headless)
  /// The machine is shared with a window: fewer workers (see worker_count), with a lower priority.
  bool beside_window = false;
};

struct Progress {
  bool running = false;  ///< and not paused
  bool paused = false;
  bool finished = false;  ///< every pixel is final
  /// No more pixels will become final: the search for the scene's boundaries failed.
  bool failed = false;
  double fraction = 0.0;       ///< of the work, 0 to 1, as forecast
  double seconds = 0.0;        ///< since restart, without pauses
  double seconds_left = -1.0;  ///< estimate; negative: not known yet
};

/// The pass that all pixels of a picture have reached.
struct Reached {
  enum class Pass { nothing, blocks, quarters, samples, final_pixels };
  /// One sample per block, per quarter of a block, or per pixel (`samples` of them), or final
  /// pixels.
  Pass pass = Pass::nothing;
  int samples = 0;           ///< of Pass::samples
  double final_share = 0.0;  ///< of the pixels
  /// The round of samples that runs now, from 1; 0: none, before the first picture and once final
  /// blocks are rendered.
  int round = 0;
  int rounds = 0;  ///< in all; 0: before the first one
};

/// Returns the number of workers for RenderSettings::threads; 0: one per core. With a window one
/// core stays free, except on a machine with two cores, where half of it would idle.
[[nodiscard]] int worker_count(int threads, bool beside_window = false);
/// Returns the same for a machine with this number of cores.
[[nodiscard]] int worker_count_on(int cores, int threads, bool beside_window);

/// Renders a snapshot with worker threads and publishes finished tiles (design section 9).
///
/// Order: a sample for each 8x8 block, for each 4x4 one, then 1, 2, 4 and so on for each pixel
/// (SampleRounds). Methods with the same number of samples in every pixel end with these. For other
/// methods, steps with the largest expected gain follow (StepQueue): more samples for single
/// pixels, and blocks of the method's own pixels as soon as the scene's boundaries are known.
///
/// The result does not depend on the number of workers or on the order of tiles. All members may be
/// called from one controlling thread; the callback comes from workers and must not call back in.
///
/// With a crop, tiles are relative to the crop's top left corner, and a picture of the crop's size
/// holds them all; their pixels equal that part of the whole picture's. A snapshot without a scene,
/// or with settings that `validated` refuses, renders nothing and is finished at once.
class RenderSession {
 public:
  /// `on_tiles` is called from a worker when the first new tile is waiting, and at the end.
  explicit RenderSession(std::function<void()> on_tiles = {});
  ~RenderSession();
  RenderSession(const RenderSession&) = delete;
  RenderSession& operator=(const RenderSession&) = delete;

  /// Cancels the present render, waits until no worker uses it, and starts the new one.
  void restart(Snapshot snapshot);
  /// Pauses or resumes all but the coarse passes. Also applies to later snapshots.
  void pause();
  void resume();
  /// Makes this part of the picture final before the rest; empty: no part. Also applies to later
  /// snapshots.
  void prefer(const PixelRect& part);
  /// Stops and waits. Published tiles stay.
  void cancel();
  /// Waits for the end of the render.
  void wait();

  /// Returns the part of the picture that tiles cover: the crop, or all.
  [[nodiscard]] PixelRect visible() const;

  /// Returns the tiles finished since the last call, oldest first. Never tiles of an older
  /// snapshot.
  [[nodiscard]] std::vector<FinishedTile> take_finished();
  [[nodiscard]] Progress progress() const;
  /// Returns the pass that the tiles published so far have reached.
  [[nodiscard]] Reached reached() const;
  /// Returns the statistics of the final pass so far; complete and reproducible once finished.
  [[nodiscard]] RenderStatistics statistics() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Renders all of a snapshot and returns the picture, or the crop's part of it: the headless form,
/// without coarse passes, for a scene whose boundaries can be found. `on_progress` is called about
/// ten times a second from the calling thread, and once at the end.
struct RenderResult {
  Film film;
  RenderStatistics statistics;
  double seconds = 0.0;
  /// The least progress of all pixels, where a limit of time ended the render.
  std::optional<Reached> stopped_at;
};
[[nodiscard]] RenderResult render_to_end(
    Snapshot snapshot, const std::function<void(const Progress&)>& on_progress = {});

}  // namespace asos
