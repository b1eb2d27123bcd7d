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

/// Keeps the reference picture that "Check splits" has sampled for as long as the view stays,
/// whatever EPS, MAX and method the picture uses. Not thread-safe.
class ErrorReference {
 public:
  /// Call once a frame. `findings`: null: there are none.
  void update(const Previewer& previewer, const SplitFindings* findings);
  /// Null: none of this view.
  [[nodiscard]] const Film* film() const { return film_.get(); }
  /// Samples of a pixel.
  [[nodiscard]] int samples() const { return samples_; }
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
};

}  // namespace asos::ui
