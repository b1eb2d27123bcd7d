#pragma once

#include "renderer/film/film.h"
#include "renderer/film/tone.h"
#include "renderer/session/render_session.h"
#include "ui/stoppable_job.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace asos::ui {

class Previewer;

/// Consecutive pixels of a row.
struct PixelRun {
  int x = 0;
  int y = 0;
  int count = 1;

  bool operator==(const PixelRun&) const = default;
};

/// Adds a pixel that follows those of `runs` in reading order.
void add_pixel(std::vector<PixelRun>& runs, int x, int y);

/// A finished picture, and samples of the same view to compare it with.
struct SplitEvidence {
  const Film& picture;
  const Film& centres;                    ///< one sample per pixel, at its centre
  const Film& reference;                  ///< the mean of many
  const std::vector<float>& uncertainty;  ///< standard error of its radiance, largest channel
  int passes = 1000;           ///< number of passes that the uncertainty is estimated from
  DisplayTransform display{};  ///< EPS and errors are measured in its display values
};

/// Pixels that were split too little or needlessly.
struct SplitFindings {
  int passes = 0;  ///< of the reference
  std::shared_ptr<const Film> reference;
  std::vector<PixelRun> missed;  ///< not split, and visibly different from the reference
  std::vector<PixelRun> wasted;  ///< split, although one sample would have given the same
  std::size_t missed_pixels = 0;
  std::size_t wasted_pixels = 0;
  std::size_t split_pixels = 0;
  double rmse = 0.0;   ///< of the picture against the reference, linear, clipped to 0 to 1
  double noise = 0.0;  ///< the part of `rmse` due to noise: the reference's standard error
};

/// Classifies pixels. An unsplit pixel is missed if its display intensity (0 to 1) differs from the
/// reference by more than `alarm` in any channel, and its radiance by more than noise can explain:
/// four standard errors, or more after few passes. A split pixel is wasted if it is within a
/// quarter of an 8-bit step of its single sample. All films have the same size.
[[nodiscard]] SplitFindings find_faults(const SplitEvidence& evidence, double alarm);

/// Samples the finished picture's view in the background with a growing number of samples, and
/// finds where ASOS should have split and where it did so needlessly. All members must be called
/// from one thread.
class SplitCheck {
 public:
  static constexpr int most_passes = 64;
  static constexpr int samples_each = 4;

  /// Call once a frame. `wanted`: whether to check. A changed picture is checked again once it is
  /// finished. `held`: other work needs the processors; the findings stay and the check resumes
  /// later.
  void update(const Previewer& previewer, bool wanted, double alarm, bool held = false);
  /// The findings about the current picture; null: none yet.
  [[nodiscard]] const SplitFindings* findings() const {
    return current_ && findings_ ? &*findings_ : nullptr;
  }
  [[nodiscard]] bool busy() const { return job_.busy(); }
  [[nodiscard]] bool pending() const { return job_.pending(); }

 private:
  struct Subject {
    std::uint64_t restarts = 0;
    double alarm = 0.0;
    bool operator==(const Subject&) const = default;
  };

  std::optional<Subject> subject_;  // of the job
  bool current_ = false;
  bool cut_short_ = false;  // the job was stopped because of `held`
  std::optional<SplitFindings> findings_;
  StoppableJob<SplitFindings> job_;
};

}  // namespace asos::ui
