#pragma once

#include "renderer/film/film.h"
#include "renderer/session/render_session.h"
#include "ui/stoppable_job.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace asos::ui {

class Previewer;

/// Pixels side by side in a row.
struct PixelRun {
  int x = 0;
  int y = 0;
  int count = 1;

  bool operator==(const PixelRun&) const = default;
};

/// A finished picture, and the samples of the same view that it is compared with.
struct SplitEvidence {
  const Film& picture;
  const Film& centres;                    ///< one sample a pixel, through its middle
  const Film& reference;                  ///< the mean of many
  const std::vector<float>& uncertainty;  ///< the reference's standard error, the worst channel
  int passes = 1000;                      ///< that the uncertainty is estimated from
};

/// Where splitting went wrong.
struct SplitFindings {
  int passes = 0;  ///< of the reference
  std::shared_ptr<const Film> reference;
  std::vector<PixelRun> missed;  ///< not split, and visibly off the reference
  std::vector<PixelRun> wasted;  ///< split, and as one sample would have been
  std::size_t missed_pixels = 0;
  std::size_t wasted_pixels = 0;
  std::size_t split_pixels = 0;
  double rmse = 0.0;   ///< of the picture against the reference, linear, clipped to 0 to 1
  double noise = 0.0;  ///< the part of it that is the reference's own: its standard error
};

/// A pixel that was not split is missed if its display intensity is more than `alarm` (0 to 1) off
/// the reference, in any channel, and its radiance more than the reference's own noise can explain:
/// four standard errors, and more where these are told from few passes. One that was split is
/// wasted if it is within a quarter of a step of an 8-bit picture of its single sample. All films
/// have one size.
[[nodiscard]] SplitFindings find_faults(const SplitEvidence& evidence, double alarm);

/// Samples the finished picture's view in the background, with ever more samples, and tells where
/// ASOS should have split and where it need not have. All members are for one thread.
class SplitCheck {
 public:
  static constexpr int most_passes = 64;
  static constexpr int samples_each = 4;

  /// Call once a frame. `wanted`: whether to check at all. A picture that changes is checked anew
  /// once it is finished. `held`: other work needs the processors; what was found stays, and the
  /// rest is found out afterwards.
  void update(const Previewer& previewer, bool wanted, double alarm, bool held = false);
  /// The findings about the picture as it is; null: none yet.
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
  bool cut_short_ = false;  // the job of the subject was held up
  std::optional<SplitFindings> findings_;
  StoppableJob<SplitFindings> job_;
};

}  // namespace asos::ui
