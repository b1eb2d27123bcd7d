#pragma once

#include "renderer/geometry/camera.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "renderer/settings/settings.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace asos {

/// The rays of an exposure at any time in between its moments, built when first used. Thread-safe.
class MovingRays {
 public:
  /// `moments`: as in Exposure.
  explicit MovingRays(std::vector<std::shared_ptr<const RenderScene>> moments)
      : moments_(std::move(moments)) {}

  /// Returns the scene of the motion. Null: its moments differ by more than motion, such as the
  /// visibility of objects, or it does not fit into memory.
  [[nodiscard]] const RayScene* get() const;

 private:
  std::vector<std::shared_ptr<const RenderScene>> moments_;
  mutable std::once_flag once_;
  mutable std::optional<RayScene> rays_;
};

/// A scene while the shutter is open: at moments that are spread evenly from its opening to its
/// closing. A picture is their mean by the trapezoidal rule.
struct Exposure {
  /// The largest number of steps from one moment to the next; a power of two.
  static constexpr int most_steps = 1024;
  /// The stored triangles of all moments together, about 4 GB of memory: with boundaries, and with
  /// hierarchies for rays only.
  static constexpr std::size_t most_triangles = 4'000'000, most_ray_triangles = 16'000'000;
  /// No visible vertex moves farther in a step, in pixels, if these bounds and fine_steps allow it.
  static constexpr double finest_step = 0.25;
  /// More steps are made only where a vertex would move by more than `longest_step` pixels.
  static constexpr int fine_steps = 128;
  static constexpr double longest_step = 1.0;

  ShutterSettings shutter;  ///< for which it was made
  /// An odd number of moments; the middle one is the picture's own. Empty: nothing moves.
  std::vector<std::shared_ptr<const RenderScene>> moments;
  std::shared_ptr<const MovingRays> rays;  ///< null: nothing moves
  double step_pixels = 0.0;                ///< the farthest that a visible vertex moves in a step
  bool limited = false;                    ///< a bound allowed no more steps
  bool before_clip = false;                ///< the shutter opens before the animation begins
  bool after_clip = false;                 ///< the shutter closes after the animation's end

  [[nodiscard]] bool moves() const { return !moments.empty(); }
  [[nodiscard]] int steps() const { return static_cast<int>(moments.size()) - 1; }
};

/// Returns the number of triangles that a world stores. A mesh with many instances counts once, and
/// an instance as a few triangles.
[[nodiscard]] std::size_t stored_triangles(const World& world);

/// Makes the scene of a picture at another time of its animation ready to render. `meshes`: for
/// AnimationInvariants::meshes.
using MomentMaker = std::function<Result<std::shared_ptr<const RenderScene>>(
    const ClipTime& time, const std::shared_ptr<MeshStore>& meshes)>;

/// Returns the scene with the exposure of `settings.shutter`, for a picture by this camera. Returns
/// the same scene if it has no time or the shutter blurs nothing. Times beyond the clip show its
/// first or last pose. The fastest visible vertex sets the number of steps: at least 4 for each
/// pixel of its motion, and at least 16 times the root of that motion. The mean of a pixel that an
/// edge enters or leaves then has an error of at most 1/2048 of the contrast. From fine_steps on
/// there is one step for each pixel. If the triangles of all moments are too many, meshes that keep
/// their shape are stored once (MeshStore). `with_edges`: finds the boundaries of all moments.
/// Errors: the maker's, and lack of memory for boundaries.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> exposed(
    const std::shared_ptr<const RenderScene>& scene, const Camera& camera,
    const RenderSettings& settings, const MomentMaker& at, bool with_edges = true);

/// Returns the picture's camera at another moment. It follows the scene's camera number `followed`
/// on its way from `now` to `then`; -1: it stands still.
[[nodiscard]] Camera camera_at(const Camera& camera, int followed, const World& now,
                               const World& then);

/// Returns warnings about an exposure: nothing moves, a bound on its steps, times beyond the clip.
[[nodiscard]] std::vector<std::string> exposure_remarks(const Exposure& exposure);

}  // namespace asos
