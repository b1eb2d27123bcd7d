#pragma once

#include "renderer/result.h"
#include "renderer/study/ladders.h"
#include "renderer/world/render_features.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asos {

/// The camera of a scene; members that are not set have their default.
struct StudyCamera {
  std::optional<int> index;                      ///< index of one of the file's cameras, from 0
  std::optional<std::array<double, 6>> look_at;  ///< eye and target, in the author's coordinates
  std::optional<double> fov_y_deg;

  bool operator==(const StudyCamera&) const = default;
};

/// A moment of a scene's animation.
struct StudyMoment {
  std::optional<std::string> animation;  ///< animation's name or number; none: the first
  double seconds = 0.0;

  bool operator==(const StudyMoment&) const = default;
};

/// Everything besides the scene that determines its true picture: the same for all methods.
struct StudyLook {
  StudyCamera camera;
  std::optional<StudyMoment> moment;  ///< none: everything is where the file's nodes place it
  std::string sky = "neutral";        ///< Sky::name
  /// The sky named so, opened for rendering; not compared. Null: neutral, or not opened, for
  /// example when jobs are only merged.
  std::shared_ptr<const Sky> opened_sky;
  int reflections = RenderSettings{}.mirror.bounces;
  double roughest_mirror = RenderSettings{}.mirror.roughest;
  std::optional<Dfr> dfr;

  bool operator==(const StudyLook& other) const {
    return camera == other.camera && moment == other.moment && sky == other.sky &&
           reflections == other.reflections && roughest_mirror == other.roughest_mirror &&
           dfr == other.dfr;
  }
};

/// Returns the look of a picture with these settings and the usual camera.
[[nodiscard]] StudyLook look_of(const RenderSettings& settings);

/// One true picture of a study.
struct StudyScene {
  std::string source;  ///< as on the command line
  StudyLook look;

  /// Returns the source, followed by the differences of its look from the default.
  [[nodiscard]] std::string name() const;
  bool operator==(const StudyScene&) const = default;
};

/// The comparisons of a study. A plan determines all its jobs: the same plan gives the same list.
struct StudyPlan {
  std::vector<std::string> scenes;   ///< sources, measured with whole ladders
  StudyLook look;                    ///< camera, moment, sky and mirrors for those scenes
  int texture_resolution = 1;        ///< TR of ASOS in them, 1 to 8
  std::vector<std::string> methods;  ///< empty: default_methods()
  int width = 320;
  int height = 180;
  int repetitions = 3;
  double budget_seconds = 60.0;  ///< for the reference of one scene
  /// While too many settings cannot be compared, the reference may take `patience` times that.
  bool patient = true;
  static constexpr double patience = 10.0;
  /// The time limit for one picture of a setting. If one takes longer, it is given up, and so are
  /// the more expensive settings of its curve.
  double longest_seconds = 600.0;
  int threads = 0;     ///< of each render; 0: one for each core
  bool paper = false;  ///< includes the cases of CGF'98 table 2
  FeatureChoice render_features = FeatureChoice::scene;
  std::string asset_root;  ///< see LoadOptions; not stored in jobs' records

  bool operator==(const StudyPlan&) const = default;
};

enum class JobKind {
  regions,    ///< the map of regions of a scene
  point,      ///< one setting of a method, once
  progress,   ///< the pictures of one setting of a method during rendering
  reference,  ///< one half of one pass of the reference
};

/// A piece of a study's work that does not depend on the other jobs.
struct Job {
  std::size_t id = 0;  ///< place in the list
  JobKind kind = JobKind::point;
  std::string scene;  ///< the subject's name
  StudyScene subject;
  LadderStep rung;     ///< the setting to render
  int repetition = 0;  ///< number of the repetition of a point, from 1
  int pass = 0;        ///< number of the pass of a reference, from 0
  int half = 0;        ///< half of a reference, 0 or 1

  /// Returns a description of the job, the same for the same work.
  [[nodiscard]] std::string title() const;
};

/// Largest number of passes of a reference. reference_samples() returns the samples per pixel in
/// each half of one: 64, 64, 128, 256, ... so that each pass doubles the total.
inline constexpr int reference_passes = 9;
[[nodiscard]] int reference_samples(int pass);

/// Returns whether a job may end early. A point is then left out, and a recorded render keeps its
/// pictures so far. Other jobs have to finish.
[[nodiscard]] inline bool may_be_given_up(JobKind kind) {
  return kind == JobKind::point || kind == JobKind::progress;
}

/// Returns all scenes of a plan: its own, and those of the published cases.
[[nodiscard]] std::vector<StudyScene> scenes_of(const StudyPlan& plan);

/// Makes the jobs in their order: scene by scene the regions, the points, the recorded renders and
/// the reference. A repetition of all points comes before the next, with the methods in turn, so
/// that other load of the machine affects all of them. Renders are recorded in the plan's own
/// scenes: one of each method. Errors: no scene, an unknown method, a size out of range.
[[nodiscard]] Result<std::vector<Job>> make_jobs(const StudyPlan& plan);

}  // namespace asos
