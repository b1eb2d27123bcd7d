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

/// A study (renderer/study) of one view of an open scene, on a thread of its own: the jobs that
/// `asos report` runs, with their films kept in memory. The first pass of the reference comes
/// first, so that errors can be told from the start; then the points, repetition by repetition;
/// then one render of each method that is watched; then further passes, until the reference is
/// quiet enough or the plan's budget for it has ended. All members are for one controlling thread;
/// none but the destructor waits for a render, and that one only until the render has given up,
/// some hundredths of a second.
class ViewStudy {
 public:
  /// The view to study. The plan names one scene, which is `scene`.
  struct Subject {
    std::shared_ptr<const RenderScene> scene;
    Camera camera;  ///< relative to scene->world().origin
    StudyPlan plan;
    /// Wall-clock seconds of the whole study, without pauses; none: unlimited. With a limit the
    /// plan's size is the largest; `plan_in_time` chooses the size after measuring the scene's
    /// cost.
    std::optional<double> seconds = std::nullopt;
  };

  enum class Phase { none, running, stopped, finished };
  struct State {
    Phase phase = Phase::none;
    std::string doing;           ///< the job's title, while running
    bool resting = false;        ///< until other work leaves the processors
    std::size_t points_run = 0;  ///< each repetition counts, and each render that is watched
    std::size_t points = 0;
    int passes = 0;      ///< of the reference
    bool quiet = false;  ///< the reference's noise is a quarter of the smallest error, or less
    SceneStudy study;    ///< the points run so far; of the measures, RMSE alone
  };

  /// Chooses size and repetitions so that the first reference and all settings take about half of
  /// `seconds`. `sample_seconds`: time per sample. More reference passes take the rest.
  [[nodiscard]] static StudyPlan plan_in_time(StudyPlan plan, double sample_seconds,
                                              double seconds);

  /// Begins anew. Errors, which leave everything as it was: no scene, a plan that `make_jobs`
  /// refuses, a method that cannot render the scene, a study that has not yet ended.
  [[nodiscard]] Result<void> start(const Subject& subject);
  /// Asks the study to end; what it found out stays.
  void stop();
  /// Ends the study and forgets what it found out.
  void clear();
  /// Call once a frame. `disturbed`: other work takes the processors. Then the study rests, and the
  /// job that ran begins again once they are free: its time would be wrong.
  void update(bool disturbed);

  /// The scene that `state` is about; null where there is none.
  [[nodiscard]] const RenderScene* scene() const;
  /// Whether a study runs, or has been asked to end and has not yet.
  [[nodiscard]] bool busy() const;
  [[nodiscard]] State state() const;

 private:
  class Work;

  bool disturbed_ = false;
  std::shared_ptr<Work> shown_;    // null after `clear`
  std::shared_ptr<Work> started_;  // the work that the thread does, or did last
  std::jthread thread_;
};

}  // namespace asos::ui
