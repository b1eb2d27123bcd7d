#pragma once

#include "renderer/film/film.h"
#include "renderer/film/tone.h"
#include "renderer/settings/settings.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace asos::ui {

class Previewer;
struct SplitFindings;

/// Scale of the layer Error in display steps: 255 steps from black to white.
struct ErrorScale {
  static constexpr double first = 0.25;  ///< and below: black
  static constexpr double last = 64.0;   ///< and above: white
  /// Position on the logarithmic scale of an error in display steps: 0 to 1.
  [[nodiscard]] static float share(double steps);
};

/// Error of a pixel in display steps: the largest difference of any displayed channel.
[[nodiscard]] double error_steps(const Film& picture, const Film& reference, std::size_t pixel,
                                 const DisplayTransform& display);

/// The error of a whole picture.
struct ErrorSummary {
  double rmse = 0.0;     ///< linear, clipped to 0 to 1
  double visible = 0.0;  ///< the fraction of pixels with an error above one display step, 0 to 1
};
/// Both films have the same size, which is not 0.
[[nodiscard]] ErrorSummary error_summary(const Film& picture, const Film& reference,
                                         const DisplayTransform& display);

/// Keeps the reference picture that SplitCheck has sampled for as long as the view stays,
/// whatever EPS, MAX and method the picture uses. Not thread-safe.
class ErrorReference {
 public:
  /// Call once a frame. `findings`: null: there are none.
  void update(const Previewer& previewer, const SplitFindings* findings);
  /// Null: none of this view.
  [[nodiscard]] const Film* film() const { return film_.get(); }
  [[nodiscard]] const std::shared_ptr<const Film>& shared() const { return film_; }
  /// Samples of a pixel.
  [[nodiscard]] int samples() const { return samples_; }
  /// The error of the finished picture; none: it is not finished, or there is no reference.
  [[nodiscard]] std::optional<ErrorSummary> summary(const Previewer& previewer,
                                                    const DisplayTransform& display);
  /// Counts the changes of the reference.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  /// Everything that a converged picture depends on.
  struct View {
    const void* scene = nullptr;
    std::uint64_t camera_revision = 0;
    RenderSettings settings;
    bool operator==(const View&) const = default;
  };
  [[nodiscard]] static View view_of(const Previewer& previewer);

  std::optional<View> view_;
  std::shared_ptr<const Film> film_;
  int samples_ = 0;
  std::uint64_t revision_ = 0;

  struct Measured {
    std::uint64_t revision = 0;
    std::uint64_t restarts = 0;
    DisplayTransform display;
    bool operator==(const Measured&) const = default;
  };
  std::optional<Measured> measured_;
  ErrorSummary summary_;
};

}  // namespace asos::ui
