#pragma once

#include "renderer/result.h"
#include "renderer/study/ladders.h"
#include "renderer/world/needs.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asos {

/// Where a scene is seen from; as it is by default where nothing is set.
struct StudyCamera {
  std::optional<int> index;                      ///< index in the file's cameras, from 0
  std::optional<std::array<double, 6>> look_at;  ///< eye and target, in the author's coordinates
  std::optional<double> fov_y_deg;

  bool operator==(const StudyCamera&) const = default;
};

/// A moment of an animation of a scene.
struct StudyMoment {
  std::optional<std::string> animation;  ///< by its name or number; none: the first
  double seconds = 0.0;

  bool operator==(const StudyMoment&) const = default;
};

/// Everything beside the scene that its true picture depends on: the same for all methods.
struct StudyLook {
  StudyCamera camera;
  std::optional<StudyMoment> moment;      ///< none: all stands where the file's nodes place it
  std::string sky = "neutral";            ///< its name: Sky::name
  std::shared_ptr<const Sky> opened_sky;  ///< the same to render with, not compared; null: neutral,
                                          ///< or not opened, as where jobs are only merged
  int reflections = RenderSettings{}.mirror.bounces;
  double roughest_mirror = RenderSettings{}.mirror.roughest;
  std::optional<Dfr> dfr;

  bool operator==(const StudyLook& other) const {
    return camera == other.camera && moment == other.moment && sky == other.sky &&
           reflections == other.reflections && roughest_mirror == other.roughest_mirror &&
           dfr == other.dfr;
  }
};

/// That of a picture with these settings, seen by the usual camera.
[[nodiscard]] StudyLook look_of(const RenderSettings& settings);

/// One true picture of a study.
struct StudyScene {
  std::string source;  ///< as on the command line
  StudyLook look;

  /// The source, and in what its look differs from the program's usual one.
  [[nodiscard]] std::string name() const;
  bool operator==(const StudyScene&) const = default;
};

/// The comparisons of a study. All of its jobs follow from it: the same plan makes the same list.
struct StudyPlan {
  std::vector<std::string> scenes;   ///< sources, measured with whole ladders
  StudyLook look;                    ///< of those scenes
  int texture_resolution = 1;        ///< TR of ASOS on them, 1 to 8
  std::vector<std::string> methods;  ///< empty: default_methods()
  int width = 320;
  int height = 180;
  int repetitions = 3;
  double budget_seconds = 60.0;  ///< for the reference of one scene
  /// Longer, up to patience times that, while too many settings cannot be compared.
  bool patient = true;
  static constexpr double patience = 10.0;
  /// The time that one picture of a setting may take. One that takes longer is given up, and with
  /// it the dearer settings of its curve.
  double longest_seconds = 600.0;
  int threads = 0;     ///< of each render; 0: one for each core
  bool paper = false;  ///< also the cases of CGF'98 table 2
  NeedsChoice needs = NeedsChoice::scene;
  std::string asset_root;  ///< see LoadOptions; records of jobs leave it out

  bool operator==(const StudyPlan&) const = default;
};

enum class JobKind {
  regions,    ///< the map of regions of a scene
  point,      ///< one setting of a method, once
  progress,   ///< the pictures of one setting of a method while it renders
  reference,  ///< one half of one pass of the reference
};

/// A piece of work that needs nothing of the others.
struct Job {
  std::size_t id = 0;  ///< place in the list
  JobKind kind = JobKind::point;
  std::string scene;  ///< its subject's name
  StudyScene subject;
  Rung rung;           ///< the setting to render
  int repetition = 0;  ///< point: from 1
  int pass = 0;        ///< reference: from 0
  int half = 0;        ///< reference: 0 or 1

  /// The job in words, the same for the same work.
  [[nodiscard]] std::string title() const;
};

/// How many passes a reference has at most, and the samples of a pixel in each half of one: 64, 64,
/// 128, 256, ... so that each pass doubles what there is.
inline constexpr int reference_passes = 9;
[[nodiscard]] int reference_samples(int pass);

/// Returns true for jobs that may end early. A point is left out then; a render that is watched
/// keeps its pictures so far. The other jobs have to finish.
[[nodiscard]] inline bool may_be_given_up(JobKind kind) {
  return kind == JobKind::point || kind == JobKind::progress;
}

/// All scenes of a plan: its own, and those of the published cases.
[[nodiscard]] std::vector<StudyScene> scenes_of(const StudyPlan& plan);

/// The jobs in their order: scene by scene the regions, the points, the renders that are watched
/// and the reference. A repetition of all points comes before the next, and within it the methods
/// take turns, so that what else the machine does meets all of them. Renders are watched of the
/// plan's own scenes: one of each method. Errors: no scene, an unknown method, a size that is out
/// of range.
[[nodiscard]] Result<std::vector<Job>> make_jobs(const StudyPlan& plan);

}  // namespace asos
