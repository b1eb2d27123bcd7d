#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"
#include "renderer/study/analysis.h"
#include "renderer/study/plan.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace asos::ui {

/// A study (renderer/study) of one view of an open scene on its own thread: the jobs of `asos
/// report`, with the films kept in memory. The first pass of the reference runs first, so that
/// errors are known from the start. Then come the points, repetition by repetition; then one
/// watched render of each method; then more passes, until the reference is quiet enough or its
/// budget is used up. All members must be called from one controlling thread. Only the destructor
/// waits for a render, which stops within some hundredths of a second.
class ViewStudy {
 public:
  /// The view to study. The plan has one scene, which is `scene`.
  struct Subject {
    std::shared_ptr<const RenderScene> scene;
    Camera camera;  ///< relative to scene->world().origin
    StudyPlan plan;
    /// Wall-clock limit of the whole study in seconds, without pauses; none: unlimited. With a
    /// limit the plan's size is a maximum: `plan_in_time` chooses the size after measuring the time
    /// per sample.
    std::optional<double> seconds = std::nullopt;
  };

  enum class Phase { none, running, stopped, finished };
  struct State {
    Phase phase = Phase::none;
    std::string doing;           ///< the running job, in words; empty before the first one
    bool resting = false;        ///< paused until other work frees the processors
    std::size_t points_run = 0;  ///< each repetition and each watched render counts
    std::size_t points = 0;
    int passes = 0;      ///< of the reference
    bool quiet = false;  ///< the reference's noise is at most a quarter of the smallest error
    SceneStudy study;    ///< the points so far; of the measures only RMSE
  };

  /// Chooses size and repetitions so that all settings and a reference that is quiet enough for the
  /// finest of them take about three quarters of `seconds`. `sample_seconds`: time per sample.
  [[nodiscard]] static StudyPlan plan_in_time(StudyPlan plan, double sample_seconds,
                                              double seconds);

  /// Starts a study. Errors, after which nothing has changed: no scene, a plan that `make_jobs`
  /// rejects, a method that cannot render the scene, a study still running.
  [[nodiscard]] Result<void> start(const Subject& subject);
  /// Asks the study to stop; its results stay.
  void stop();
  /// Stops the study and discards its results.
  void clear();
  /// Call once a frame. `disturbed`: other work uses the processors. Then the study pauses, and the
  /// running job starts again later, because its time would be wrong.
  void update(bool disturbed);

  /// The scene of `state`; null: none.
  [[nodiscard]] const RenderScene* scene() const;
  /// Whether a study is running, or has been asked to stop and has not yet.
  [[nodiscard]] bool busy() const;
  [[nodiscard]] State state() const;

 private:
  class Work;

  bool disturbed_ = false;
  std::shared_ptr<Work> shown_;    // null after `clear`
  std::shared_ptr<Work> started_;  // the work of the thread, running or finished
  std::jthread thread_;
};

}  // namespace asos::ui
