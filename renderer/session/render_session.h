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

/// Everything that a render depends on, immutable once handed over.
struct Snapshot {
  std::shared_ptr<const RenderScene> scene;
  Camera camera;  ///< relative to scene->world().origin
  RenderSettings settings;
  bool progressive = true;  ///< coarse passes first (window); false: final pixels only (headless)
  /// A window shares the machine: see worker_count; and workers have a lower priority.
  bool beside_window = false;
};

struct Progress {
  bool running = false;  ///< and not paused
  bool paused = false;
  bool finished = false;       ///< every pixel is final
  bool failed = false;         ///< no more will be: the scene's boundaries could not be found
  double fraction = 0.0;       ///< of the work, 0 to 1, as it is forecast
  double seconds = 0.0;        ///< since restart, without pauses
  double seconds_left = -1.0;  ///< estimate; negative: not known yet
};

/// How far all pixels of a picture have come at least.
struct Reached {
  enum class Pass { nothing, blocks, quarters, samples, final_pixels };
  /// A sample for each block, for each quarter of one; so many samples for each pixel.
  Pass pass = Pass::nothing;
  int samples = 0;           ///< of Pass::samples
  double final_share = 0.0;  ///< of the pixels
};

/// The workers that RenderSettings::threads asks for: where it is 0, one for each core. Beside a
/// window one core stays free, but not where there are only two: half of the machine would idle.
[[nodiscard]] int worker_count(int threads, bool beside_window = false);
/// The same on a machine with so many cores.
[[nodiscard]] int worker_count_on(int cores, int threads, bool beside_window);

/// Renders a snapshot with worker threads and publishes finished tiles (design section 9). First a
/// sample for each 8x8 block, for each 4x4 one, then 1, 2, 4 and so on for each pixel
/// (SampleRounds): methods that take as many samples in every pixel end so. For others, as soon as
/// the scene's boundaries are known and more samples are not worth their work, blocks of the
/// method's own pixels, those first that are furthest from their end (FinalBlocks). The result does
/// not depend on the number of workers nor on the order of tiles. All members may be called from
/// one controlling thread; the callback comes from workers and must not call back in.
///
/// With a crop, tiles are relative to the crop's top left corner, and a picture of the crop's size
/// holds them all; their pixels equal that part of the whole picture's. A snapshot without a scene,
/// or with settings that `validated` refuses, renders nothing and is finished at once.
class RenderSession {
 public:
  /// `on_tiles` is called (from a worker) when tiles wait that did not before, and at the end.
  explicit RenderSession(std::function<void()> on_tiles = {});
  ~RenderSession();
  RenderSession(const RenderSession&) = delete;
  RenderSession& operator=(const RenderSession&) = delete;

  /// Cancels what runs, waits until no worker touches it, and starts anew: a blocking handshake.
  void restart(Snapshot snapshot);
  /// Lets the final pass rest or go on; the coarse ones go on meanwhile. Holds for later snapshots
  /// as well.
  void pause();
  void resume();
  /// Stops and waits. Published tiles stay.
  void cancel();
  /// Waits for the end of the render.
  void wait();

  /// The size of the picture that tiles go into: the crop's, or all.
  [[nodiscard]] PixelRect visible() const;

  /// Tiles finished since the last call, oldest first. Never tiles of an older snapshot.
  [[nodiscard]] std::vector<FinishedTile> take_finished();
  [[nodiscard]] Progress progress() const;
  /// Of the tiles published so far.
  [[nodiscard]] Reached reached() const;
  /// The statistics of the final pass so far; complete and reproducible once finished.
  [[nodiscard]] RenderStatistics statistics() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Renders all of a snapshot and returns the picture, the crop's part of it where there is one: the
/// headless form, without coarse passes, of a scene that its boundaries can be found of.
/// `on_progress` is called about ten times a second from the calling thread, and once at the end.
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
